// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/match_command.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/matching/match_quality.h"
#include "core/matching/matcher.h"
#include "core/matching/peak.h"
#include "core/matching/search_region.h"
#include "core/matching/subpixel.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

constexpr int smallest_inner_px = 3;
constexpr double farthest_fit_px = 0.75;

std::string size_text(const Image& picture) {
    return std::to_string(picture.width()) + " x " + std::to_string(picture.height());
}

struct Pictures {
    Image image;
    Image templ;
};

Result<Pictures> read_pictures(const MatchOptions& options, const MatchMethod& method) {
    auto image = read_picture(options.image);
    if (!image) {
        return image.error();
    }
    auto templ = read_picture(options.templ);
    if (!templ) {
        return templ.error();
    }
    if (image->channels() != templ->channels() || method.transform != Transform::none) {
        image = grey_from(*image);
        templ = grey_from(*templ);
    }
    if (templ->width() > image->width() || templ->height() > image->height()) {
        return Error{"The template of " + size_text(*templ) +
                         " pixels is larger than the picture of " + size_text(*image) + ".",
                     "Give the picture first, then the template."};
    }
    if (templ->width() > largest_template_px || templ->height() > largest_template_px) {
        return Error{"The template has " + size_text(*templ) + " pixels: too many to compare.",
                     "Give one of at most 255 x 255 pixels, or make both pictures smaller."};
    }
    return Pictures{std::move(*image), std::move(*templ)};
}

// The template's own border has no transform: the part within it is compared.
Result<Rectangle> compared_part(const Image& templ, const MatchMethod& method) {
    const int margin = margin_px(method.transform);
    const Rectangle inner{margin, margin, templ.width() - 2 * margin, templ.height() - 2 * margin};
    if (inner.width < smallest_inner_px || inner.height < smallest_inner_px) {
        const std::string why = margin == 0 ? "to be compared"
                                            : "for the transform " + to_string(method.transform) +
                                                  ", which takes " + std::to_string(margin) +
                                                  " pixels off each side";
        return Error{"The template of " + size_text(templ) + " pixels is too small " + why + ".",
                     margin == 0 ? "Give one of at least 3 x 3 pixels."
                                 : "Give a larger one, or use another transform."};
    }
    const int least_px = (smallest_inner_px - 1) * method.step + 1;
    if (inner.width < least_px || inner.height < least_px) {
        return Error{"Of a template of " + size_text(templ) + " pixels, a step of " +
                         std::to_string(method.step) + " leaves too few to be compared.",
                     "Use a smaller --step."};
    }
    return inner;
}

// The scores of all positions of the whole template, NaN where the search did not look.
Result<Done> write_map(const std::filesystem::path& file, const ScoreMap& map,
                       const Pictures& pictures, int margin) {
    const int columns = pictures.image.width() - pictures.templ.width() + 1;
    const int rows = pictures.image.height() - pictures.templ.height() + 1;
    std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows),
                              std::numeric_limits<float>::quiet_NaN());
    const Rectangle& r = map.positions;
    for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
            if (map.searched(x, y)) {
                const std::ptrdiff_t to =
                    static_cast<std::ptrdiff_t>(y - margin) * columns + (x - margin);
                values[static_cast<std::size_t>(to)] = static_cast<float>(map.at(x, y));
            }
        }
    }
    return write_float_tiff(file, values, columns, rows);
}

struct Placed {
    Eigen::Vector2d centre_px;
    std::optional<Eigen::Matrix2d> covariance_px2;
};

// The fit goes by the grey levels, and counts where it agrees with the scores.
Placed place_of(const Peak& peak, const Pictures& pictures, int margin) {
    const Image& templ = pictures.templ;
    Placed placed;
    Eigen::Vector2d top_left_px(peak.x - margin, peak.y - margin);
    const auto fitted = refine_match(grey_from(pictures.image), grey_from(templ),
                                     {0, 0, templ.width(), templ.height()}, top_left_px);
    if (fitted && (fitted->position_px - top_left_px).norm() < farthest_fit_px) {
        top_left_px = fitted->position_px;
        placed.covariance_px2 = fitted->covariance_px2;
    }
    placed.centre_px = top_left_px + 0.5 * Eigen::Vector2d(templ.width() - 1, templ.height() - 1);
    return placed;
}

nlohmann::json json_of(const std::optional<Eigen::Matrix2d>& covariance) {
    if (!covariance) {
        return nullptr;
    }
    const Eigen::Matrix2d& c = *covariance;
    const double mixed = 0.5 * (c(0, 1) + c(1, 0));  // rounded apart by the inversion
    return {{c(0, 0), mixed}, {mixed, c(1, 1)}};
}

Result<Outcome> match(const MatchOptions& options, const MatchMethod& method,
                      const MatchSearch& search) {
    const auto pictures = read_pictures(options, method);
    if (!pictures) {
        return pictures.error();
    }
    const auto inner = compared_part(pictures->templ, method);
    if (!inner) {
        return inner.error();
    }
    const auto region =
        region_of(options.search, search, pictures->image, inner->width, inner->height);
    if (!region) {
        return region.error();
    }
    Matcher matcher(method);
    matcher.set_template(pictures->templ, *inner);
    ScoreMap map;
    scores_within(matcher, pictures->image, *region, map);
    std::optional<Eigen::Vector2d> expected;
    if (search.expected_px) {
        expected = *search.expected_px - 0.5 * Eigen::Vector2d(inner->width - 1, inner->height - 1);
    }
    const auto peak = best_peak(map, method.measure, expected);
    if (!peak) {
        return Error{"Where the search looks, the template does not fit into the picture.",
                     "Look elsewhere, or give a smaller template."};
    }
    const int margin = margin_px(method.transform);
    if (options.map) {
        if (const auto written = write_map(*options.map, map, *pictures, margin); !written) {
            return written.error();
        }
    }
    const Placed placed = place_of(*peak, *pictures, margin);
    const double likeness = matcher.quality(peak->score);
    const auto second =
        second_peak(map, method.measure, *peak, apart_px(inner->width, inner->height));
    const double next = second ? matcher.quality(*second) : 0.0;
    const double ratio = likeness > 0.0 ? std::min(next / likeness, 1.0) : 1.0;
    const double quality = match_probability(method, match_evidence(matcher, map, *peak));
    Outcome outcome;
    outcome.json = nlohmann::json{{"x_px", placed.centre_px.x()},
                                  {"y_px", placed.centre_px.y()},
                                  {"score", peak->score},
                                  {"quality", quality},
                                  {"likeness", likeness},
                                  {"second_score", second ? nlohmann::json(*second) : nullptr},
                                  {"peak_ratio", ratio},
                                  {"covariance_px2", json_of(placed.covariance_px2)}}
                       .dump(2);
    char line[240];
    std::snprintf(
        line, sizeof line,
        "Centre at (%.2f, %.2f) px, %s %.6g, likeness %.3f, next peak %.2f of it; right with a "
        "probability of %.0f %%\n",
        placed.centre_px.x(), placed.centre_px.y(), to_string(method.measure).c_str(), peak->score,
        likeness, ratio, 100.0 * quality);
    outcome.summary = line;
    return outcome;
}

Outcome refused(const Error& error, bool wrong_usage) {
    Outcome outcome{error};
    outcome.json = nlohmann::json{{"error", error.text()}}.dump(2);
    outcome.wrong_usage = wrong_usage;
    return outcome;
}

}  // namespace

Outcome run_match(const MatchOptions& options) {
    const auto search = parse_search(options.search);
    if (!search) {
        return refused(search.error(), true);
    }
    auto method = parse_method(options.measure, options.transform);
    if (!method) {
        return refused(method.error(), true);
    }
    method->step = search->step;
    if (options.map) {
        if (const auto named = check_float_tiff_name(*options.map); !named) {
            return refused(named.error(), false);
        }
    }
    auto outcome = match(options, *method, *search);
    return outcome ? std::move(*outcome) : refused(outcome.error(), false);
}

}  // namespace kambara::cli
