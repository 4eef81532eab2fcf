// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/point_layout.h"

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace kambara {

PointLayout layout_of(const std::vector<SeenPoint>& points) {
    PointLayout layout;
    const auto n = static_cast<Eigen::Index>(points.size());
    if (n == 0) {
        return layout;
    }
    Eigen::MatrixX3d rows(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        rows.row(i) = points[static_cast<std::size_t>(i)].in_world_mm;
    }
    layout.mean_mm = rows.colwise().mean();
    rows.rowwise() -= layout.mean_mm.transpose();
    // Three rows at least, so that there are three axes.
    Eigen::MatrixXd padded = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(n, 3), 3);
    padded.topRows(n) = rows;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(padded, Eigen::ComputeThinU | Eigen::ComputeThinV);
    layout.axes = svd.matrixV();
    if (layout.axes.determinant() < 0.0) {
        layout.axes.col(2) *= -1.0;
    }
    layout.spread_mm = svd.singularValues() / std::sqrt(static_cast<double>(n));
    return layout;
}

}  // namespace kambara
