// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/side_scan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kambara {
namespace {

constexpr double strip_px = 3.0;     // of the levels on either side
constexpr double margin_px = 0.25;   // of the window beyond the step
constexpr double blur_shares = 2.0;  // of the blur's deviation that a step takes to either side
constexpr double clear_shares = 1.5;

Eigen::Vector2d outward(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    const Eigen::Vector2d along = (b - a).normalized();
    return {along.y(), -along.x()};
}

}  // namespace

SideScan::SideScan(const Image& grey, const LightOfLevel& light, const Quadrilateral& box,
                   std::size_t side, double bow_px, const SideFitOptions& options)
    : grey_(grey),
      light_(light),
      box_(box),
      side_(side),
      bow_(bow_px),
      blur_px_(options.blur_px),
      least_contrast_(options.least_contrast) {
    const Eigen::Vector2d& a = box[side];
    const Eigen::Vector2d& b = box[(side + 1) % 4];
    const Eigen::Vector2d out = outward(a, b);
    columns_ = std::abs(out.y()) >= std::abs(out.x());
    a_ = columns_ ? a : a.reverse();
    b_ = columns_ ? b : b.reverse();
    const double out_v = columns_ ? out.y() : out.x();
    outward_ = out_v > 0.0 ? 1.0 : -1.0;
    across_ = std::abs(out_v);
    const Eigen::Vector2d opposite = 0.5 * (box[(side + 2) % 4] + box[(side + 3) % 4]);
    inside_ = std::abs(out.dot(opposite - 0.5 * (a + b))) / across_;
    outside_ = inside_ * (side % 2 == 1 ? options.gap_to_width : options.gap_to_height);
    const double slope = std::sqrt(std::max(0.0, 1.0 - across_ * across_)) / across_;
    step_half_ = 0.5 * (1.0 + slope) + blur_shares * options.blur_px / across_;
}

bool SideScan::clear_of_side(const Eigen::Vector2d& place, std::size_t other) const {
    const Eigen::Vector2d out = outward(box_[other], box_[(other + 1) % 4]);
    const double need = 0.5 * (std::abs(out.x()) + std::abs(out.y())) + clear_shares * blur_px_;
    return out.dot(place - box_[other]) <= -need;
}

bool SideScan::clear_of_corners(double u) const {
    const double edge = v0(u);
    const double depth = std::min(step_half_ + margin_px, 0.5 * inside_);
    for (const std::size_t other : {(side_ + 1) % 4, (side_ + 3) % 4}) {
        if (!clear_of_side(pixel(u, edge), other) ||
            !clear_of_side(pixel(u, edge - outward_ * depth), other)) {
            return false;
        }
    }
    const int length = columns_ ? grey_.height() : grey_.width();
    const int count = columns_ ? grey_.width() : grey_.height();
    const double reach = std::max(step_half_ + strip_px, outside_) + 1.0;
    return u >= 0.0 && u < count && edge - reach >= 0.0 && edge + reach < length - 1;
}

std::optional<SideScan::Levels> SideScan::levels(const std::vector<int>& scans) const {
    Levels sums;
    double dark_squares = 0.0;
    // From the edge: past the step, and not into the one that follows.
    const auto strip = [&](double room) {
        const double last = std::min(step_half_ + strip_px, room - step_half_);
        return last >= step_half_ + 0.5 ? std::pair(step_half_, last)
                                        : std::pair(0.5 * room - 0.5, 0.5 * room + 0.5);
    };
    const auto [dark_first, dark_last] = strip(inside_);
    const auto [light_first, light_last] = strip(outside_);
    for (const int u : scans) {
        const double edge = v0(u);
        const auto gather = [&](double first, double last, auto take) {
            const double low = std::min(edge + first, edge + last);
            const double high = std::max(edge + first, edge + last);
            for (int v = static_cast<int>(std::ceil(low)); v <= high; ++v) {
                take(v, light_at(u, v));
            }
        };
        gather(-outward_ * dark_first, -outward_ * dark_last, [&](int v, double value) {
            if (!clear_of_side(pixel(u, v), (side_ + 1) % 4) ||
                !clear_of_side(pixel(u, v), (side_ + 3) % 4)) {
                return;  // a slanted side comes near
            }
            sums.dark += value;
            dark_squares += value * value;
            sums.dark_count += 1.0;
        });
        gather(outward_ * light_first, outward_ * light_last, [&](int, double value) {
            sums.light += value;
            sums.light_count += 1.0;
        });
    }
    if (sums.dark_count < 1.0 || sums.light_count < 1.0) {
        return std::nullopt;
    }
    sums.dark /= sums.dark_count;
    sums.light /= sums.light_count;
    sums.noise = std::sqrt(std::max(0.25, dark_squares / sums.dark_count - sums.dark * sums.dark));
    if (sums.light - sums.dark < least_contrast_) {
        return std::nullopt;
    }
    return sums;
}

// What of the window would be dark if it were dark or light only. `step` gets the integral of
// p (1 - p) over the pixels' shares of light p, which tells how wide the step is.
double SideScan::dark_length(int u, double v_low, double v_high, const Levels& levels,
                             double& step) const {
    double length = 0.0;
    const int first = static_cast<int>(std::floor(v_low + 0.5));
    const int last = static_cast<int>(std::floor(v_high + 0.5));
    for (int v = first; v <= last; ++v) {
        const double within = std::min(v_high, v + 0.5) - std::max(v_low, v - 0.5);
        const double p = (levels.light - light_at(u, v)) / (levels.light - levels.dark);
        length += within * p;
        step += within * p * (1.0 - p);
    }
    return length;
}

std::optional<SideScan::Edge> SideScan::edge() const {
    std::vector<int> scans;
    const auto [u_first, u_last] = std::minmax(a_.x(), b_.x());
    for (int u = static_cast<int>(std::ceil(u_first)); u <= u_last; ++u) {
        if (clear_of_corners(u)) {
            scans.push_back(u);
        }
    }
    if (scans.empty()) {
        return std::nullopt;
    }
    const auto light = levels(scans);
    if (!light) {
        return std::nullopt;
    }
    const double depth_in = std::min(step_half_ + margin_px, 0.5 * inside_);
    const double depth_out = std::min(step_half_ + margin_px, 0.5 * outside_);
    Edge edge;
    double step_sum = 0.0;
    for (const int u : scans) {
        const double expected = v0(u);
        const double from = expected - outward_ * depth_in;
        const double to = expected + outward_ * depth_out;
        double step = 0.0;
        const double dark = dark_length(u, std::min(from, to), std::max(from, to), *light, step);
        const double found = from + outward_ * dark;
        if (std::abs(found - expected) < std::max(depth_in, depth_out)) {
            edge.points_px.push_back(pixel(u, found));
            step_sum += step;
        }
    }
    if (edge.points_px.empty()) {
        return std::nullopt;
    }
    const double per_level = across_ / (light->light - light->dark);
    edge.sigma_px = light->noise * std::sqrt(depth_in + depth_out) * per_level;
    edge.common_sigma_px = light->noise * per_level *
                           std::hypot(depth_in / std::sqrt(light->dark_count),
                                      depth_out / std::sqrt(light->light_count));
    edge.dark = light->dark;
    edge.light = light->light;
    if (depth_in > step_half_ && depth_out > step_half_) {
        // For a step of deviation s, the integral of p (1 - p) is s / sqrt(pi), near enough for a
        // pixel's box too.
        const double mean = step_sum / static_cast<double>(edge.points_px.size());
        const double slope2 = (1.0 - across_ * across_) / (across_ * across_);
        edge.blur_variance_px2 =
            (std::numbers::pi * mean * mean - (1.0 + slope2) / 12.0) * across_ * across_;
    }
    return edge;
}

double SideScan::bow_of(const std::vector<Eigen::Vector2d>& points_px) const {
    constexpr std::size_t enough = 8;
    if (points_px.size() < enough) {
        return 0.0;
    }
    double products = 0.0;
    double squares = 0.0;
    for (const Eigen::Vector2d& p : points_px) {
        const double u = columns_ ? p.x() : p.y();
        const double v = columns_ ? p.y() : p.x();
        const double t = share(u);
        const double bend = 4.0 * t * (1.0 - t);
        products += bend * (v - a_.y() - t * (b_.y() - a_.y()));
        squares += bend * bend;
    }
    return products / squares;
}

}  // namespace kambara
