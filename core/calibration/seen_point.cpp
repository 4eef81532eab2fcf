// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/seen_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace kambara {

std::vector<Eigen::Vector2d> residuals_px(const TsaiView& view,
                                          const std::vector<SeenPoint>& points) {
    constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
    std::vector<Eigen::Vector2d> residuals;
    residuals.reserve(points.size());
    for (const SeenPoint& point : points) {
        const auto pixel = project(view.lens, view.T_camera_from_world * point.in_world_mm);
        residuals.push_back(pixel ? Eigen::Vector2d(*pixel - point.seen_px)
                                  : Eigen::Vector2d(nothing, nothing));
    }
    return residuals;
}

double squared_error_px2(const TsaiView& view, const std::vector<SeenPoint>& points) {
    double sum = 0.0;
    for (const Eigen::Vector2d& residual : residuals_px(view, points)) {
        sum += residual.squaredNorm();
    }
    return sum;
}

double extent_px(const std::vector<SeenPoint>& points) {
    double squares = 0.0;
    for (const int axis : {0, 1}) {
        std::vector<double> values;
        values.reserve(points.size());
        for (const SeenPoint& point : points) {
            values.push_back(point.seen_px[axis]);
        }
        std::sort(values.begin(), values.end());
        const std::size_t tenth = values.size() / 10;
        squares += std::pow(values[values.size() - 1 - tenth] - values[tenth], 2);
    }
    return std::sqrt(squares);
}

}  // namespace kambara
