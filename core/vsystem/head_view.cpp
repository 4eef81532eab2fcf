// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/head_view.h"

#include <Eigen/Geometry>
#include <map>
#include <string>

#include "core/calibration/target_detector.h"
#include "core/stereo/position.h"
#include "core/vsystem/picture_fit.h"

namespace kambara {
namespace {

constexpr std::size_t least_corners = 8;

Result<DetectedCorners> corners_in(const Image& picture, const Target& target, const Camera& camera,
                                   const char* which) {
    if (!fits(picture, camera)) {
        return Error{std::string("The ") + which +
                         " picture is not of the size that the rig was calibrated for.",
                     "Give pictures of that size."};
    }
    auto corners = detect_target(grey_from(picture), target);
    if (!corners) {
        return Error{std::string("The ") + which +
                         " camera does not find the target: " + corners.error().cause,
                     corners.error().remedy};
    }
    return corners;
}

struct PlacedTarget {
    RigidTransform T_rig_from_target;
    std::vector<PairSighting> pair;
};

Result<PlacedTarget> placed_target(const Rig& rig, const Target& target, const Image& left,
                                   const Image& right) {
    const auto in_left = corners_in(left, target, rig.left, "left");
    if (!in_left) {
        return in_left.error();
    }
    const auto in_right = corners_in(right, target, rig.right.value(), "right");
    if (!in_right) {
        return in_right.error();
    }
    std::map<int, DetectedCorner> others;
    for (const DetectedCorner& corner : *in_right) {
        others[corner.id] = corner;
    }
    const auto corners = corners_in_target_mm(target);
    const RigidTransform T_rig_from_left = rig.left.T_camera_from_rig.inverse();
    Eigen::Matrix3Xd known(3, static_cast<Eigen::Index>(in_left->size()));
    Eigen::Matrix3Xd measured = known;
    Eigen::Index count = 0;
    PlacedTarget placed;
    for (const DetectedCorner& corner : *in_left) {
        const auto other = others.find(corner.id);
        if (other == others.end()) {
            continue;
        }
        const auto position = position_from_pair(rig, {corner.px}, {other->second.px});
        if (position) {
            known.col(count) = corners[static_cast<std::size_t>(corner.id)];
            measured.col(count) = T_rig_from_left * position->point_in_left_mm;
            placed.pair.push_back({known.col(count), corner.px, other->second.px});
            ++count;
        }
    }
    if (count < static_cast<Eigen::Index>(least_corners)) {
        return Error{"The left and the right picture share only " + std::to_string(count) +
                         " corners of the target.",
                     "Show it to both."};
    }
    const Eigen::Matrix4d T =
        Eigen::umeyama(known.leftCols(count), measured.leftCols(count), false);
    placed.T_rig_from_target = {T.topLeftCorner<3, 3>(), T.topRightCorner<3, 1>()};
    for (PairSighting& one : placed.pair) {
        one.point_in_rig_mm = placed.T_rig_from_target * one.point_in_rig_mm;
    }
    return placed;
}

}  // namespace

Result<RigidTransform> target_in_rig(const Rig& rig, const Target& target, const Image& left,
                                     const Image& right) {
    const auto placed = placed_target(rig, target, left, right);
    return placed ? Result<RigidTransform>(placed->T_rig_from_target) : placed.error();
}

Result<HeadView> head_view_from(const Rig& rig, const Target& target, const HeadPictures& pictures,
                                const HeadAngles& encoder, const HeadApproach& approach) {
    if (!pictures.left || !pictures.right || !pictures.pan_tilt) {
        return Error{"A picture of the three cameras is missing.",
                     "Check that all three deliver pictures."};
    }
    const auto placed = placed_target(rig, target, *pictures.left, *pictures.right);
    if (!placed) {
        return placed.error();
    }
    const auto seen = corners_in(*pictures.pan_tilt, target, rig.pan_tilt.value(), "pan-tilt");
    if (!seen) {
        return seen.error();
    }
    HeadView view;
    view.encoder = encoder;
    view.approach = approach;
    view.pair = placed->pair;
    const auto corners = corners_in_target_mm(target);
    for (const DetectedCorner& corner : *seen) {
        view.sightings.push_back(
            {placed->T_rig_from_target * corners[static_cast<std::size_t>(corner.id)], corner.px});
    }
    if (view.sightings.size() < least_corners) {
        return Error{"The head's camera sees too few of the target's corners.",
                     "Turn the head towards it."};
    }
    return view;
}

}  // namespace kambara
