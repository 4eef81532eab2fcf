// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/match_search.h"

#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include "core/camera/rig_file.h"
#include "core/tracking/epipolar_region.h"

namespace kambara::cli {
namespace {

constexpr int usual_radius_px = 20;
constexpr int usual_step = 2;
constexpr int usual_band_px = 2;

struct Strategy {
    std::string_view name;
    bool window;
    bool epipolar;
    bool sparse;
};

constexpr std::array<Strategy, 6> strategies{{
    {"full", false, false, false},
    {"window", true, false, false},
    {"sparse", false, false, true},
    {"window-sparse", true, false, true},
    {"epipolar", false, true, false},
    {"epipolar-sparse", false, true, true},
}};

Result<Eigen::Vector2d> parse_point(std::string_view option, std::string_view text) {
    Eigen::Vector2d point;
    const char* const end = text.data() + text.size();
    const auto [comma, first] = std::from_chars(text.data(), end, point.x());
    if (first == std::errc{} && comma != end && *comma == ',') {
        const auto [stopped, second] = std::from_chars(comma + 1, end, point.y());
        if (second == std::errc{} && stopped == end && point.allFinite()) {
            return point;
        }
    }
    return Error{std::string(option) + " \"" + std::string(text) + "\" is no pixel.",
                 "Give it as X,Y, for example 320,240.5."};
}

Result<Done> check_belonging(const MatchSearchOptions& o, const Strategy& strategy) {
    struct Option {
        const char* name;
        bool given;
        bool belongs;
        const char* to;
    };
    const Option options[] = {
        {"--radius", o.radius_px.has_value(), strategy.window, "window or window-sparse"},
        {"--step", o.step.has_value(), strategy.sparse, "sparse, window-sparse or epipolar-sparse"},
        {"--rig", !o.rig.empty(), strategy.epipolar, "epipolar or epipolar-sparse"},
        {"--left-point", !o.left_point_px.empty(), strategy.epipolar,
         "epipolar or epipolar-sparse"},
        {"--band", o.band_px.has_value(), strategy.epipolar, "epipolar or epipolar-sparse"},
        {"--nearest-mm", o.nearest_mm.has_value(), strategy.epipolar,
         "epipolar or epipolar-sparse"},
        {"--farthest-mm", o.farthest_mm.has_value(), strategy.epipolar,
         "epipolar or epipolar-sparse"},
    };
    for (const Option& option : options) {
        if (option.given && !option.belongs) {
            return Error{std::string(option.name) + " says nothing to --search " +
                             std::string(strategy.name) + ".",
                         "Leave it out, or use --search " + std::string(option.to) + "."};
        }
    }
    return Done{};
}

Result<Done> check_needs(const MatchSearchOptions& o, const Strategy& strategy) {
    const std::string search = "--search " + std::string(strategy.name);
    if (strategy.window && o.near_px.empty()) {
        return Error{search + " needs to know where to look.",
                     "Give --near X,Y, where the template's centre is expected."};
    }
    if (strategy.epipolar && (o.rig.empty() || o.left_point_px.empty())) {
        return Error{search + " needs the cameras and the left pixel.",
                     "Give --rig RIG and --left-point X,Y, about which the template was cut."};
    }
    const RangeBounds usual;
    if (strategy.epipolar &&
        o.nearest_mm.value_or(usual.nearest_mm) >= o.farthest_mm.value_or(usual.farthest_mm)) {
        return Error{"The least distance is not smaller than the largest.",
                     "Give --nearest-mm less than --farthest-mm."};
    }
    return Done{};
}

Result<Rig> rig_for(const std::string& file, const Image& right) {
    auto rig = read_rig_file(file);
    if (!rig) {
        return rig.error();
    }
    if (!rig->right) {
        return Error{"The rig file holds no right camera.",
                     "Give one of two cameras, or search without the epipolar curve."};
    }
    const double factor_x = static_cast<double>(right.width()) / rig->right->width_px;
    const double factor_y = static_cast<double>(right.height()) / rig->right->height_px;
    if (factor_x == 1.0 && factor_y == 1.0) {
        return rig;
    }
    if (std::abs(factor_x / factor_y - 1.0) > 1.0 / right.height()) {
        return Error{"The picture is of another shape than the right camera's.",
                     "Give the rig file that belongs to it."};
    }
    return scaled_to(*rig, right.width(), right.height());
}

}  // namespace

Result<MatchSearch> parse_search(const MatchSearchOptions& options) {
    for (const Strategy& strategy : strategies) {
        if (options.strategy != strategy.name) {
            continue;
        }
        for (const auto& checked :
             {check_belonging(options, strategy), check_needs(options, strategy)}) {
            if (!checked) {
                return checked.error();
            }
        }
        MatchSearch search;
        search.window = strategy.window;
        search.epipolar = strategy.epipolar;
        search.step = strategy.sparse ? options.step.value_or(usual_step) : 1;
        if (!options.near_px.empty()) {
            const auto near = parse_point("--near", options.near_px);
            if (!near) {
                return near.error();
            }
            search.expected_px = *near;
        }
        if (strategy.epipolar) {
            const auto left = parse_point("--left-point", options.left_point_px);
            if (!left) {
                return left.error();
            }
            search.left_point_px = *left;
        }
        return search;
    }
    return Error{"There is no search \"" + options.strategy + "\".",
                 "Choose full, window, sparse, window-sparse, epipolar or epipolar-sparse."};
}

Result<SearchRegion> region_of(const MatchSearchOptions& options, const MatchSearch& search,
                               const Image& picture, int width, int height) {
    if (search.window) {
        return window_region(*search.expected_px, options.radius_px.value_or(usual_radius_px),
                             width, height);
    }
    if (!search.epipolar) {
        return full_region(picture);
    }
    const auto rig = rig_for(options.rig, picture);
    if (!rig) {
        return rig.error();
    }
    if (!rig->left.sees(search.left_point_px)) {
        return Error{"--left-point " + options.left_point_px + " is not in the left picture.",
                     "Give the pixel about which the template was cut."};
    }
    RangeBounds bounds;
    bounds.nearest_mm = options.nearest_mm.value_or(bounds.nearest_mm);
    bounds.farthest_mm = options.farthest_mm.value_or(bounds.farthest_mm);
    auto region = epipolar_region(*rig, search.left_point_px, bounds,
                                  options.band_px.value_or(usual_band_px), width, height);
    if (region.positions.empty()) {
        return Error{
            "The right camera sees nothing of the left pixel's ray between these distances.",
            "Check --left-point, --nearest-mm and --farthest-mm."};
    }
    return region;
}

}  // namespace kambara::cli
