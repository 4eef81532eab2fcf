// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/match_command.h"

#include <nlohmann/json.hpp>

#include "app/cli/choices.h"
#include "core/matching/peak.h"
#include "core/matching/score_map.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

Outcome refused(Error error) {
    return {std::move(error)};
}

std::string size_text(const Image& picture) {
    return std::to_string(picture.width()) + " x " + std::to_string(picture.height());
}

}  // namespace

Outcome run_match(const MatchOptions& options) {
    const auto measure = chosen_measure(options.measure, options.transform);
    if (!measure) {
        return refused(measure.error());
    }
    if (options.search != "full") {
        return refused(
            {"The search \"" + options.search + "\" is not available here.", "Use --search full."});
    }
    auto image = read_picture(options.image);
    if (!image) {
        return refused(image.error());
    }
    auto templ = read_picture(options.templ);
    if (!templ) {
        return refused(templ.error());
    }
    if (image->channels() != templ->channels()) {
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
    const ScoreMap map = score_map(*measure, *image, *templ, all_positions(*image, *templ));
    const auto peak = best_peak(map, *measure);
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
    const double x_px = peak->x + 0.5 * (templ->width() - 1);
    const double y_px = peak->y + 0.5 * (templ->height() - 1);
    const double likeness = quality(*measure, peak->score, *templ);
    Outcome outcome;
    outcome.json = nlohmann::json{
        {"x_px", x_px},
        {"y_px", y_px},
        {"score", peak->score},
        {"quality",
         likeness}}.dump(2);
    char line[160];
    std::snprintf(line, sizeof line, "Centre at (%.2f, %.2f) px, %s %.6g, quality %.3f\n", x_px,
                  y_px, to_string(*measure).c_str(), peak->score, likeness);
    outcome.summary = line;
    return outcome;
}

}  // namespace kambara::cli
