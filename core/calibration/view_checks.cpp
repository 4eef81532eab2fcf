// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/view_checks.h"
#include "core/base/median.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace kambara {
namespace {

constexpr double same_place_px = 0.005;
constexpr double least_contradiction_px = 3.0;
constexpr double most_agreement_px = 12.0;

// The sign of the area in which the flat target's x and y axes appear, by the best affine map.
double affine_turn(const std::vector<Eigen::Vector3d>& at, const DetectedCorners& corners) {
    Eigen::MatrixXd A(static_cast<Eigen::Index>(corners.size()), 3);
    Eigen::MatrixXd b(A.rows(), 2);
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        const DetectedCorner& corner = corners[static_cast<std::size_t>(i)];
        const Eigen::Vector3d& p = at[static_cast<std::size_t>(corner.id)];
        A.row(i) << p.x(), p.y(), 1.0;
        b.row(i) = corner.px.transpose();
    }
    const Eigen::MatrixXd map = A.colPivHouseholderQr().solve(b);
    return map.topRows<2>().determinant();
}

// The sum of the signed areas of the boxes of which all four corners are there.
double turn_of_boxes(const DetectedCorners& corners) {
    double area = 0.0;
    for (std::size_t i = 0; i + 3 < corners.size(); ++i) {
        const int id = corners[i].id;
        if (id % 4 != 0 || corners[i + 3].id != id + 3) {
            continue;
        }
        const Eigen::Vector2d one = corners[i + 2].px - corners[i].px;
        const Eigen::Vector2d other = corners[i + 3].px - corners[i + 1].px;
        area += one.x() * other.y() - one.y() * other.x();
    }
    return area;
}

double transfer_rms_px(const std::vector<Eigen::Vector3d>& target_mm, const MonoResult& a,
                       const MonoResult& b, std::size_t view, const RigidTransform& T_b_from_a) {
    Bundle bundle;
    bundle.target_mm = target_mm;
    bundle.cameras = {b.camera};
    bundle.first_from_target = {block_of(T_b_from_a * transform_of(*a.camera_from_target[view]))};
    double sum = 0.0;
    for (const DetectedCorner& corner : b.kept[view]) {
        const auto r = residual_px(bundle, {0, 0, corner.id, corner.px, 1.0, true});
        sum += r ? std::min(r->squaredNorm(), 1e6) : 1e6;
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, b.kept[view].size())));
}

}  // namespace

bool mirrored(const Target& target, const DetectedCorners& corners) {
    if (corners.size() < 4) {
        return false;
    }
    if (std::holds_alternative<BoxTarget>(target)) {
        return turn_of_boxes(corners) < 0.0;
    }
    if (std::holds_alternative<PointTarget>(target)) {
        return false;
    }
    return affine_turn(corners_in_target_mm(target), corners) < 0.0;
}

bool same_picture(const DetectedCorners& a, const DetectedCorners& b) {
    if (a.empty() || a.size() != b.size()) {
        return false;
    }
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].id != b[i].id || (a[i].px - b[i].px).norm() > same_place_px) {
            return false;
        }
    }
    return true;
}

PoseAgreement agreed_pose(const std::vector<Eigen::Vector3d>& target_mm, const MonoResult& a,
                          const MonoResult& b) {
    PoseAgreement agreement;
    for (std::size_t i = 0; i < a.camera_from_target.size(); ++i) {
        if (a.camera_from_target[i] && b.camera_from_target[i]) {
            agreement.views.push_back(static_cast<int>(i));
        }
    }
    double best = 1e300;
    std::vector<double> best_errors;
    for (const int candidate : agreement.views) {
        const auto c = static_cast<std::size_t>(candidate);
        const RigidTransform T = transform_of(*b.camera_from_target[c]) *
                                 transform_of(*a.camera_from_target[c]).inverse();
        std::vector<double> errors;
        for (const int view : agreement.views) {
            errors.push_back(transfer_rms_px(target_mm, a, b, static_cast<std::size_t>(view), T));
        }
        const double middle = median(errors);
        if (middle < best) {
            best = middle;
            best_errors = errors;
            agreement.b_from_a = block_of(T);
        }
    }
    if (agreement.views.empty()) {
        return agreement;
    }
    agreement.found = true;
    const double far_px = std::clamp(4.0 * best, least_contradiction_px, most_agreement_px);
    for (std::size_t i = 0; i < agreement.views.size(); ++i) {
        if (best_errors[i] > far_px) {
            agreement.against.push_back(agreement.views[i]);
        }
    }
    return agreement;
}

void align_half_turn(const ChessboardTarget& board, const DetectedCorners& a, DetectedCorners& b) {
    const auto all = static_cast<std::size_t>(board.corners_across * board.corners_down);
    if (a.size() != all || b.size() != all ||
        (a.back().px - a.front().px).dot(b.back().px - b.front().px) >= 0.0) {
        return;
    }
    std::reverse(b.begin(), b.end());
    for (std::size_t i = 0; i < all; ++i) {
        b[i].id = static_cast<int>(i);
    }
}

}  // namespace kambara
