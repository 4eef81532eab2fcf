// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_marks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace kambara {
namespace {

constexpr int around = 12;  // places on each circle
constexpr double inner_circle = 0.45;
constexpr double outer_circle = 1.6;  // of the mark's radius
constexpr double least_radius_px = 0.8;
constexpr double least_contrast = 12.0;  // levels, from the paper to the boxes' ink
// Of that contrast: a mark is there above, and is not below; blur makes what lies between.
constexpr double present_share = 0.4;
constexpr double absent_share = 0.15;

// The levels on a circle about the mark that many radii wide; empty where some are out of the
// picture.
std::vector<double> circle(const Image& grey, const BoxMark& mark, const TargetView& view,
                           double radii) {
    std::vector<double> levels;
    for (int i = 0; i < around; ++i) {
        const double turn = 2.0 * std::numbers::pi * i / around;
        const auto pixel = view.pixel(mark.middle_mm + radii * (std::cos(turn) * mark.across_mm +
                                                                std::sin(turn) * mark.down_mm));
        const auto level = pixel ? level_between(grey, *pixel) : std::nullopt;
        if (!level) {
            return {};
        }
        levels.push_back(*level);
    }
    return levels;
}

double smallest_radius_px(const BoxMark& mark, const TargetView& view) {
    const auto middle = view.pixel(mark.middle_mm);
    const auto across = view.pixel(mark.middle_mm + mark.across_mm);
    const auto down = view.pixel(mark.middle_mm + mark.down_mm);
    return middle && across && down ? std::min((*across - *middle).norm(), (*down - *middle).norm())
                                    : 0.0;
}

}  // namespace

std::optional<double> level_between(const Image& grey, const Eigen::Vector2d& place) {
    const double left = std::floor(place.x());
    const double top = std::floor(place.y());
    if (!(left >= 0.0 && top >= 0.0 && left + 1.0 < grey.width() && top + 1.0 < grey.height())) {
        return std::nullopt;
    }
    const int x = static_cast<int>(left);
    const int y = static_cast<int>(top);
    const double u = place.x() - left;
    const double v = place.y() - top;
    return (1.0 - v) * ((1.0 - u) * grey.at(x, y) + u * grey.at(x + 1, y)) +
           v * ((1.0 - u) * grey.at(x, y + 1) + u * grey.at(x + 1, y + 1));
}

std::vector<BoxMark> box_marks(const BoxTarget& target) {
    std::vector<BoxMark> marks;
    const auto frames = plane_frames(target);
    for (const RoundMark& mark : target.marks) {
        const auto& [origin, across, down] = frames[static_cast<std::size_t>(mark.plane)];
        const double radius = 0.5 * mark.diameter_mm;
        marks.push_back({origin + mark.across_mm * across + mark.down_mm * down, radius * across,
                         radius * down});
    }
    return marks;
}

SeenMarks seen_marks(const Image& grey, const std::vector<BoxMark>& marks, const TargetView& view,
                     double ink) {
    SeenMarks seen;
    for (const BoxMark& mark : marks) {
        if (smallest_radius_px(mark, view) < least_radius_px) {
            continue;
        }
        const auto within = circle(grey, mark, view, inner_circle);
        auto outside = circle(grey, mark, view, outer_circle);
        if (within.empty() || outside.empty()) {
            continue;
        }
        double middle = 0.0;
        for (const double level : within) {
            middle += level / around;
        }
        // Not the mean: a box may come near on one side.
        std::sort(outside.begin(), outside.end());
        const double paper = outside[outside.size() * 3 / 4];
        if (paper - ink < least_contrast) {
            continue;
        }
        const double share = (paper - middle) / (paper - ink);
        seen.present += share > present_share ? 1 : 0;
        seen.absent += share < absent_share ? 1 : 0;
    }
    return seen;
}

}  // namespace kambara
