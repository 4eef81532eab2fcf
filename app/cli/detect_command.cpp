// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/detect_command.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "app/cli/detect_stages.h"
#include "core/calibration/box_detector.h"
#include "core/calibration/target_detector.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

using Json = nlohmann::json;

struct Found {
    DetectedCorners corners;
    std::vector<std::string> remarks;
};

// What detection and the drawing of its stages came to.
struct Detected {
    Result<Found> found;
    Result<Done> drawn = Done{};
};

// Chessboards, with markers or without.
Detected detect_board(const Image& grey, const Target& board, const DetectOptions& options) {
    auto corners = detect_target(grey, board);
    if (!corners) {
        return {corners.error()};
    }
    Detected result{Found{std::move(*corners), {}}};
    if (options.stages) {
        result.drawn = write_order(*options.stages, grey, result.found->corners);
    }
    return result;
}

Detected detect_box_target(const Image& grey, const BoxTarget& target,
                           const DetectOptions& options) {
    BoxStages stages;
    const auto detection = detect_boxes(grey, target, {}, &stages);
    Detected result{Error{}};
    if (options.stages) {
        const int boxes = static_cast<int>(corners_in_target_mm(Target(target)).size() / 4);
        result.drawn = write_box_stages(*options.stages, grey, stages, boxes);
    }
    if (!detection) {
        result.found = detection.error();
        return result;
    }
    result.found = Found{detection->corners, detection->remarks};
    if (options.stages && result.drawn) {
        result.drawn = write_order(*options.stages, grey, detection->corners);
    }
    return result;
}

Detected detected(const Image& grey, const Target& target, const DetectOptions& options) {
    if (const auto* boxes = std::get_if<BoxTarget>(&target)) {
        return detect_box_target(grey, *boxes, options);
    }
    return detect_board(grey, target, options);
}

Json json_of(const Found& found, int total) {
    Json corners = Json::array();
    for (const DetectedCorner& corner : found.corners) {
        corners.push_back({{"id", corner.id},
                           {"x_px", corner.px.x()},
                           {"y_px", corner.px.y()},
                           {"sigma_px", corner.sigma_px}});
    }
    std::string reason;
    for (const std::string& remark : found.remarks) {
        reason += (reason.empty() ? "" : " ") + remark;
    }
    return {{"found", true}, {"reason", reason}, {"corners", corners}, {"corners_total", total}};
}

}  // namespace

Outcome run_detect(const DetectOptions& options) {
    Outcome outcome;
    const auto refused = [&](const Error& error) {
        outcome.failure = error;
        outcome.json =
            Json{{"found", false}, {"reason", error.text()}, {"corners", Json::array()}}.dump(2);
        return outcome;
    };
    const auto target = parse_target(options.target);
    if (!target) {
        outcome.wrong_usage = true;
        return refused(target.error());
    }
    const auto picture = read_picture(options.image);
    if (!picture) {
        return refused(picture.error());
    }
    const Detected result = detected(grey_from(*picture), *target, options);
    if (!result.found) {
        return refused(result.found.error());
    }
    const int total = static_cast<int>(corners_in_target_mm(*target).size());
    outcome.json = json_of(*result.found, total).dump(2);
    outcome.summary = std::to_string(result.found->corners.size()) + " of " +
                      std::to_string(total) + " corners found.\n";
    for (const std::string& remark : result.found->remarks) {
        outcome.summary += remark + "\n";
    }
    if (!result.drawn) {
        outcome.failure = result.drawn.error();
    }
    return outcome;
}

}  // namespace kambara::cli
