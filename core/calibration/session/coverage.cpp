// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/coverage.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/angles.h"
#include "core/calibration/session/candidate_poses.h"

namespace kambara {
namespace {

PictureCoverage picture_coverage(const std::vector<RigView>& views, std::size_t place,
                                 const PictureSize& size) {
    PictureCoverage result;
    for (const RigView& view : views) {
        std::set<std::size_t> fields;
        for (const DetectedCorner& corner : view.sights[place].corners) {
            const int x = static_cast<int>((corner.px.x() + 0.5) * PictureCoverage::across /
                                           std::max(1, size.width_px));
            const int y = static_cast<int>((corner.px.y() + 0.5) * PictureCoverage::down /
                                           std::max(1, size.height_px));
            fields.insert(static_cast<std::size_t>(std::clamp(y, 0, PictureCoverage::down - 1) *
                                                       PictureCoverage::across +
                                                   std::clamp(x, 0, PictureCoverage::across - 1)));
        }
        for (const std::size_t field : fields) {
            ++result.views[field];
        }
    }
    const auto covered = std::count_if(result.views.begin(), result.views.end(),
                                       [](int count) { return count > 0; });
    result.share = static_cast<double>(covered) / static_cast<double>(result.views.size());
    return result;
}

// Angles of R_z(roll) R_y(turn) R_x(tilt), in whose order candidates are turned, too.
HeldPose held(const RigidTransform& T, const Eigen::Matrix3d& towards_us,
              const Eigen::Vector3d& middle_mm) {
    const Eigen::Matrix3d R = T.R * towards_us.transpose();
    HeldPose pose;
    pose.depth_mm = (T * middle_mm).z();
    pose.turn_deg = deg_from_rad(std::asin(std::clamp(-R(2, 0), -1.0, 1.0)));
    pose.tilt_deg = deg_from_rad(std::atan2(R(2, 1), R(2, 2)));
    pose.roll_deg = deg_from_rad(std::atan2(R(1, 0), R(0, 0)));
    return pose;
}

}  // namespace

Coverage coverage_of(const RigGuess& guess, const Target& target,
                     const std::vector<RigView>& views) {
    Coverage result;
    for (std::size_t k = 0; k < guess.places.size(); ++k) {
        result.pictures[guess.places[k]] = picture_coverage(views, guess.places[k], guess.sizes[k]);
    }
    const auto corners = corners_in_target_mm(target);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& corner : corners) {
        middle += corner / static_cast<double>(corners.size());
    }
    const Eigen::Matrix3d towards_us =
        Eigen::Quaterniond::FromTwoVectors(facing(target), Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
    for (const RigView& view : views) {
        const auto pose = first_from_target(guess, corners, view);
        if (!pose) {
            continue;
        }
        const HeldPose how = held(transform_of(*pose), towards_us, middle);
        const bool first = result.poses.empty();
        result.nearest_mm = first ? how.depth_mm : std::min(result.nearest_mm, how.depth_mm);
        result.farthest_mm = std::max(result.farthest_mm, how.depth_mm);
        const double slant = deg_from_rad(std::acos(
            std::clamp(std::cos(rad_from_deg(how.turn_deg)) * std::cos(rad_from_deg(how.tilt_deg)),
                       -1.0, 1.0)));
        result.widest_slant_deg = std::max(result.widest_slant_deg, slant);
        result.poses.push_back(how);
    }
    return result;
}

}  // namespace kambara
