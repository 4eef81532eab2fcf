// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/box_sequence.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>

#include "core/camera/nominal_rig.h"
#include "core/tracking/stereo_tracker.h"
#include "hardware/media/picture_file.h"

namespace kambara::testing_support {
namespace {

constexpr double near_px = 20.0;
constexpr std::int64_t frame_ns = 33'333'333;

std::vector<Box> read_boxes(const std::filesystem::path& file) {
    std::vector<Box> boxes;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream numbers(line);
        Box box;
        if (numbers >> box.x >> box.y >> box.width >> box.height) {
            box.x -= 1.0;
            box.y -= 1.0;
            boxes.push_back(box);
        }
    }
    return boxes;
}

}  // namespace

BoxSequence read_box_sequence(const std::filesystem::path& folder) {
    BoxSequence sequence;
    sequence.truth = read_boxes(folder / "groundtruth_rect.txt");
    for (std::size_t i = 0; i < sequence.truth.size(); ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "%04zu.jpg", i + 1);
        auto picture = read_picture((folder / "img" / name).string());
        if (!picture) {
            break;
        }
        sequence.colour.push_back(std::make_shared<const Image>(std::move(*picture)));
    }
    sequence.truth.resize(sequence.colour.size());
    return sequence;
}

double overlap(const Box& a, const Box& b) {
    const double width = std::min(a.x + a.width, b.x + b.width) - std::max(a.x, b.x);
    const double height = std::min(a.y + a.height, b.y + b.height) - std::max(a.y, b.y);
    const double both = std::max(0.0, width) * std::max(0.0, height);
    return both / (a.width * a.height + b.width * b.height - both);
}

BoxScore score_of(const BoxSequence& sequence, const std::vector<std::optional<Box>>& found) {
    BoxScore score;
    const auto n = static_cast<double>(sequence.truth.size() - 1);
    for (std::size_t i = 1; i < sequence.truth.size(); ++i) {
        if (!found[i]) {
            continue;
        }
        const Box& box = *found[i];
        const Box& truth = sequence.truth[i];
        const double off_x = box.x - truth.x + 0.5 * (box.width - truth.width);
        const double off_y = box.y - truth.y + 0.5 * (box.height - truth.height);
        score.overlap += overlap(box, truth) / n;
        score.near += (std::hypot(off_x, off_y) <= near_px ? 1.0 : 0.0) / n;
    }
    return score;
}

std::vector<Box> nine_starts(const BoxSequence& sequence) {
    std::vector<Box> starts;
    for (const double dy : {-2.0, 0.0, 2.0}) {
        for (const double dx : {-2.0, 0.0, 2.0}) {
            Box box = sequence.truth.front();
            box.x += dx;
            box.y += dy;
            starts.push_back(box);
        }
    }
    return starts;
}

std::vector<std::optional<Box>> followed(const BoxSequence& sequence, const Box& first,
                                         const TrackerOptions& options) {
    std::vector<std::optional<Box>> found(sequence.colour.size());
    const auto pair = [&](std::size_t i) {
        StereoFrame frame;
        frame.left.picture = grey_from(sequence.colour[i]);
        frame.left.index = static_cast<std::int64_t>(i);
        frame.left.time_ns = static_cast<std::int64_t>(i) * frame_ns;
        return frame;
    };
    const Image& size = *sequence.colour.front();
    StereoTracker tracker(unknown_camera(size.width(), size.height()), options);
    const Rectangle rectangle{static_cast<int>(first.x), static_cast<int>(first.y),
                              static_cast<int>(first.width), static_cast<int>(first.height)};
    if (!tracker.set_template(pair(0), rectangle) || !tracker.start()) {
        return found;
    }
    for (std::size_t i = 1; i < found.size(); ++i) {
        const TrackEstimate estimate = tracker.process(pair(i));
        if (estimate.left_px) {
            const double width = estimate.scale * first.width;
            const double height = estimate.scale * first.height;
            found[i] = Box{estimate.left_px->x() - 0.5 * (width - 1.0),
                           estimate.left_px->y() - 0.5 * (height - 1.0), width, height};
        }
    }
    return found;
}

}  // namespace kambara::testing_support
