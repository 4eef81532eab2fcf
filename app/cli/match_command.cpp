// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/match_command.h"

#include <nlohmann/json.hpp>

#include "core/matching/matcher.h"
#include "core/matching/peak.h"
#include "core/matching/subpixel.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

constexpr int smallest_inner_px = 3;
constexpr double farthest_fit_px = 0.75;

Outcome refused(Error error) {
    return {std::move(error)};
}

std::string size_text(const Image& picture) {
    return std::to_string(picture.width()) + " x " + std::to_string(picture.height());
}

}  // namespace

Outcome run_match(const MatchOptions& options) {
    auto method = parse_method(options.measure, options.transform);
    if (!method) {
        return refused(method.error());
    }
    if (options.search != "full" && options.search != "sparse") {
        return refused({"The search \"" + options.search + "\" is not available here.",
                        "Use --search full, or sparse to compare every second pixel."});
    }
    method->step = options.search == "sparse" ? 2 : 1;
    if (options.map) {
        if (const auto named = check_float_tiff_name(*options.map); !named) {
            return refused(named.error());
        }
    }
    auto image = read_picture(options.image);
    if (!image) {
        return refused(image.error());
    }
    auto templ = read_picture(options.templ);
    if (!templ) {
        return refused(templ.error());
    }
    if (image->channels() != templ->channels() || method->transform != Transform::none) {
        image = grey_from(*image);
        templ = grey_from(*templ);
    }
    if (templ->width() > image->width() || templ->height() > image->height()) {
        return refused({"The template of " + size_text(*templ) +
                            " pixels is larger than the picture of " + size_text(*image) + ".",
                        "Give the picture first, then the template."});
    }
    if (templ->width() > largest_template_px || templ->height() > largest_template_px) {
        return refused({"The template has " + size_text(*templ) + " pixels: too many to compare.",
                        "Give one of at most 255 x 255 pixels, or make both pictures smaller."});
    }
    // The template's own border has no transform: the part within it is compared.
    const int margin = margin_px(method->transform);
    const Rectangle inner{margin, margin, templ->width() - 2 * margin,
                          templ->height() - 2 * margin};
    if (inner.width < smallest_inner_px || inner.height < smallest_inner_px) {
        const std::string why = margin == 0
                                    ? "to be compared"
                                    : "for the transform " + options.transform + ", which takes " +
                                          std::to_string(margin) + " pixels off each side";
        return refused(
            {"The template of " + size_text(*templ) + " pixels is too small " + why + ".",
             margin == 0 ? "Give one of at least 3 x 3 pixels."
                         : "Give a larger one, or use another transform."});
    }
    Matcher matcher(*method);
    matcher.set_template(*templ, inner);
    ScoreMap map;
    matcher.scores(*image, {0, 0, image->width(), image->height()}, map);
    const auto peak = best_peak(map, method->measure);
    if (options.map) {
        std::vector<float> values(map.size());
        for (std::size_t i = 0; i < map.size(); ++i) {
            values[i] = static_cast<float>(map.value(i));
        }
        const auto written =
            write_float_tiff(*options.map, values, map.positions.width, map.positions.height);
        if (!written) {
            return refused(written.error());
        }
    }
    Eigen::Vector2d top_left_px(peak->x - margin, peak->y - margin);
    // The fit goes by the grey levels, and counts where it agrees with the scores.
    const auto fitted = refine_match(grey_from(*image), grey_from(*templ),
                                     {0, 0, templ->width(), templ->height()}, top_left_px);
    if (fitted && (fitted->position_px - top_left_px).norm() < farthest_fit_px) {
        top_left_px = fitted->position_px;
    }
    const double x_px = top_left_px.x() + 0.5 * (templ->width() - 1);
    const double y_px = top_left_px.y() + 0.5 * (templ->height() - 1);
    const double likeness = matcher.quality(peak->score);
    Outcome outcome;
    outcome.json = nlohmann::json{
        {"x_px", x_px},
        {"y_px", y_px},
        {"score", peak->score},
        {"quality",
         likeness}}.dump(2);
    char line[160];
    std::snprintf(line, sizeof line, "Centre at (%.2f, %.2f) px, %s %.6g, quality %.3f\n", x_px,
                  y_px, to_string(method->measure).c_str(), peak->score, likeness);
    outcome.summary = line;
    return outcome;
}

}  // namespace kambara::cli
