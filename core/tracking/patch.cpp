// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/patch.h"

#include <algorithm>
#include <cmath>

#include "core/matching/score_map.h"

namespace kambara {
namespace {

constexpr double smallest_cosine = 0.05;  // rays along the plane hit it nowhere useful

// Keys' cubic convolution with a = -1/2: exact for quadratics.
void cubic_weights(double t, double* w) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    w[0] = -0.5 * t3 + t2 - 0.5 * t;
    w[1] = 1.5 * t3 - 2.5 * t2 + 1.0;
    w[2] = -1.5 * t3 + 2.0 * t2 + 0.5 * t;
    w[3] = 0.5 * t3 - 0.5 * t2;
}

// Pixels beyond the border repeat it: only the interpolation's outermost taps ever ask for them.
double cubic_sample(const Image& grey, double x, double y) {
    const double fx = std::floor(x);
    const double fy = std::floor(y);
    double wx[4];
    double wy[4];
    cubic_weights(x - fx, wx);
    cubic_weights(y - fy, wy);
    const int x0 = static_cast<int>(fx) - 1;
    const int y0 = static_cast<int>(fy) - 1;
    double sum = 0.0;
    for (int j = 0; j < 4; ++j) {
        const std::uint8_t* row = grey.row(std::clamp(y0 + j, 0, grey.height() - 1));
        double of_row = 0.0;
        for (int i = 0; i < 4; ++i) {
            of_row += wx[i] * row[std::clamp(x0 + i, 0, grey.width() - 1)];
        }
        sum += wy[j] * of_row;
    }
    return sum;
}

// Half width and half height, in whole pixels, of the largest upright rectangle about the centre
// whose corners stay within the reference patch.
std::optional<Eigen::Vector2i> half_size_at(const ReferencePatch& patch, const Camera& left,
                                            const Camera& camera, const Eigen::Vector3d& point,
                                            const Eigen::Vector2d& centre) {
    Eigen::Vector2d half(1e9, 1e9);
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            Eigen::Vector2d side = patch.centre_px;
            side[axis] += sign * 0.5 * patch.size_px[axis];
            const auto ray = left.unproject(side);
            if (!ray || std::abs(ray->direction.z()) < smallest_cosine) {
                return std::nullopt;
            }
            const double along =
                (patch.point_in_rig_mm.z() - ray->origin_mm.z()) / ray->direction.z();
            const Eigen::Vector3d shifted = ray->at(along) - patch.point_in_rig_mm + point;
            const auto pixel = camera.project(shifted);
            if (!pixel) {
                return std::nullopt;
            }
            half[axis] = std::min(half[axis], (*pixel - centre).norm());
        }
    }
    const Eigen::Vector2i whole = (half.array() - 0.49).floor().cast<int>();
    // Never more than twice as large as it was.
    return whole.cwiseMin(patch.size_px.cwiseMin((largest_template_px - 1) / 2));
}

}  // namespace

std::optional<RenderedPatch> render_patch(const ReferencePatch& patch, const Camera& left,
                                          const Camera& camera,
                                          const Eigen::Vector3d& point_in_rig_mm, int margin) {
    const auto centre = camera.project(point_in_rig_mm);
    if (!centre || !camera.sees(*centre)) {
        return std::nullopt;
    }
    const auto half = half_size_at(patch, left, camera, point_in_rig_mm, *centre);
    if (!half || half->minCoeff() < 2) {
        return std::nullopt;
    }
    const Eigen::Vector2i middle(static_cast<int>(std::lround(centre->x())),
                                 static_cast<int>(std::lround(centre->y())));
    RenderedPatch result;
    result.top_left = middle - *half;
    result.centre = *centre - result.top_left.cast<double>();
    result.margin = margin;
    result.picture = Image(2 * (half->x() + margin) + 1, 2 * (half->y() + margin) + 1);
    const Eigen::Vector2i first = result.top_left - Eigen::Vector2i(margin, margin);
    const Eigen::Vector3d back = patch.point_in_rig_mm - point_in_rig_mm;
    for (int y = 0; y < result.picture.height(); ++y) {
        std::uint8_t* out = result.picture.row(y);
        for (int x = 0; x < result.picture.width(); ++x) {
            const auto ray = camera.unproject((first + Eigen::Vector2i(x, y)).cast<double>());
            if (!ray || std::abs(ray->direction.z()) < smallest_cosine) {
                return std::nullopt;
            }
            const double along = (point_in_rig_mm.z() - ray->origin_mm.z()) / ray->direction.z();
            const auto source = left.project(ray->at(along) + back);
            if (!source) {
                return std::nullopt;
            }
            const double value = cubic_sample(*patch.left_grey, source->x(), source->y());
            out[x] = static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
        }
    }
    return result;
}

}  // namespace kambara
