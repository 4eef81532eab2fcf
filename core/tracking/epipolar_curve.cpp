// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/epipolar_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

namespace kambara {
namespace {

constexpr int coarse_samples = 256;
constexpr int deepest_split = 8;

struct Curve {
    const Camera& right;
    Ray ray;
    double step_px;
    double margin_px;
    std::vector<EpipolarSample> samples;

    // The right picture moves evenly with the inverse of the distance, so that is what is stepped.
    std::optional<EpipolarSample> at(double inverse_mm) const {
        const Eigen::Vector3d point = ray.at(1.0 / inverse_mm);
        const auto pixel = right.project(point);
        if (!pixel || pixel->x() < -margin_px || pixel->y() < -margin_px ||
            pixel->x() > right.width_px - 1 + margin_px ||
            pixel->y() > right.height_px - 1 + margin_px) {
            return std::nullopt;
        }
        return EpipolarSample{point, *pixel};
    }

    // Appends what lies after `from` up to and including `to`.
    void append(double from, const std::optional<EpipolarSample>& first, double to,
                const std::optional<EpipolarSample>& last, int depth) {
        const bool far_apart = first && last && (first->right_px - last->right_px).norm() > step_px;
        const bool enters = first.has_value() != last.has_value();
        if ((far_apart || enters) && depth < deepest_split) {
            const double middle = 0.5 * (from + to);
            const auto between = at(middle);
            append(from, first, middle, between, depth + 1);
            append(middle, between, to, last, depth + 1);
        } else if (last) {
            samples.push_back(*last);
        }
    }
};

// Leaves out samples whose neighbours are close enough without them; the ends stay.
std::vector<EpipolarSample> thinned(const std::vector<EpipolarSample>& dense, double step_px) {
    std::vector<EpipolarSample> kept;
    for (std::size_t i = 0; i < dense.size(); ++i) {
        const bool end = i == 0 || i + 1 == dense.size();
        if (end || (dense[i + 1].right_px - kept.back().right_px).norm() > step_px) {
            kept.push_back(dense[i]);
        }
    }
    return kept;
}

}  // namespace

std::vector<EpipolarSample> epipolar_curve(const Rig& rig, const Eigen::Vector2d& left_px,
                                           const RangeBounds& bounds, double step_px,
                                           double margin_px) {
    const auto ray = rig.left.unproject(left_px);
    if (!ray || !rig.right) {
        return {};
    }
    Curve curve{*rig.right, *ray, step_px, margin_px, {}};
    const double nearest = 1.0 / bounds.nearest_mm;
    const double farthest = 1.0 / bounds.farthest_mm;
    double from = nearest;
    auto first = curve.at(from);
    if (first) {
        curve.samples.push_back(*first);
    }
    for (int i = 1; i <= coarse_samples; ++i) {
        const double to = nearest + (farthest - nearest) * i / coarse_samples;
        const auto last = curve.at(to);
        curve.append(from, first, to, last, 0);
        from = to;
        first = last;
    }
    return thinned(curve.samples, step_px);
}

}  // namespace kambara
