// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/match_pair.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>

#include "core/stereo/epipolar_offset.h"
#include "core/stereo/ray_pair.h"

namespace kambara {
namespace {

Eigen::Matrix4d joint(const Eigen::Matrix2d& L, const Eigen::Matrix2d& R, const Eigen::Matrix2d& S,
                      const Eigen::Matrix2d& M) {
    const Eigen::Matrix2d cross = L * M.transpose() - M.inverse() * S;
    Eigen::Matrix4d covariance;
    covariance << L, cross, cross.transpose(), M * L * M.transpose() + R - 2.0 * S;
    return 0.5 * (covariance + covariance.transpose());
}

}  // namespace

PairMeasurement pair_of(const Rig& rig, const PatchMatch& left, const PatchMatch& right) {
    PairMeasurement pair{left.pixel, right.pixel, Eigen::Matrix4d::Zero()};
    const Eigen::Matrix2d& L = left.covariance_px2;
    const Eigen::Matrix2d& R = right.covariance_px2;
    pair.covariance_px2.topLeftCorner<2, 2>() = L;
    pair.covariance_px2.bottomRightCorner<2, 2>() = R;
    const auto rays = right.by_other_match ? ray_pair(rig, left.pixel, right.pixel, 0.0)
                                           : Result<RayPair>(Error{});
    const auto M =
        rays ? right_by_left(rig, left.pixel, rays->meeting.distance_a_mm) : std::nullopt;
    if (!M || !(M->determinant() != 0.0)) {
        return pair;
    }
    // The left picture's noise in the right match; no more of it than is in the left one.
    const Eigen::Matrix2d of_patch = R - right.covariance_of_picture_px2;
    const double in_left = (*M * left.covariance_of_picture_px2 * M->transpose()).trace();
    const double share = std::min(1.0, in_left / std::max(1e-12, of_patch.trace()));
    const Eigen::Matrix4d together = joint(L, R, share * of_patch, *M);
    pair.covariance_px2 =
        together.llt().info() == Eigen::Success ? together : joint(L, R, 0.0 * R, *M);
    return pair;
}

}  // namespace kambara
