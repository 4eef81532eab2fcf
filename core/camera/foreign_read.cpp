// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>

#include "core/camera/foreign_formats.h"
#include "core/camera/foreign_yaml.h"

namespace kambara {
namespace {

using namespace foreign_yaml;

constexpr double mm_per_m = 1000.0;

Rig pair_of(const Camera& left, const Camera& right, const RigidTransform& T_right_from_left,
            const std::string& from) {
    if (!(T_right_from_left.t_mm.norm() > 1e-3)) {
        throw Fault{"both cameras are in one place"};
    }
    Rig rig = rig_from_pair(left, right, T_right_from_left);
    rig.provenance.method = "converted from " + from;
    return rig;
}

Camera opencv_camera(const YAML::Node& root, const std::string& index, const PictureSize& size) {
    const auto K = numbers(child(root, "M" + index), "M" + index, 9);
    auto D = numbers(child(root, "D" + index), "D" + index);
    return {lens_of(K[0], K[4], K[2], K[5], std::move(D), size.width_px, size.height_px),
            size.width_px,
            size.height_px,
            {}};
}

// One camera_info: the lens, and what rectifies it.
struct RosCamera {
    Camera camera;
    Eigen::Matrix3d R_rectified_from_camera;
    double offset_mm;  // of the projection's fourth column
};

RosCamera ros_camera(std::string_view text) {
    const YAML::Node root = parsed(text);
    const int width =
        picture_side(number(child(root, "image_width"), "image_width"), "image_width");
    const int height =
        picture_side(number(child(root, "image_height"), "image_height"), "image_height");
    const auto K = numbers(child(root, "camera_matrix"), "camera_matrix", 9);
    const YAML::Node model_node = child(root, "distortion_model");
    const std::string model = model_node.IsScalar() ? model_node.Scalar() : "";
    if (model != "plumb_bob" && model != "rational_polynomial") {
        throw Fault{"the distortion model \"" + model +
                    "\" is neither plumb_bob nor rational_polynomial"};
    }
    auto D = numbers(child(root, "distortion_coefficients"), "distortion_coefficients");
    const auto R = numbers(child(root, "rectification_matrix"), "rectification_matrix", 9);
    const auto P = numbers(child(root, "projection_matrix"), "projection_matrix", 12);
    if (!(P[0] > 0.0)) {
        throw Fault{"\"projection_matrix\" has no focal length"};
    }
    return {{lens_of(K[0], K[4], K[2], K[5], std::move(D), width, height), width, height, {}},
            rotation_of(R, "rectification_matrix"),
            mm_per_m * P[3] / P[0]};
}

Camera kalibr_camera(const YAML::Node& node, const std::string& name) {
    const YAML::Node model = child(node, "camera_model");
    if (!model.IsScalar() || model.Scalar() != "pinhole") {
        throw Fault{name + "'s camera_model is not pinhole"};
    }
    const auto f = numbers(child(node, "intrinsics"), name + ".intrinsics", 4);
    const auto size = numbers(child(node, "resolution"), name + ".resolution", 2);
    const int width = picture_side(size[0], name + ".resolution");
    const int height = picture_side(size[1], name + ".resolution");
    const YAML::Node distortion = child(node, "distortion_model");
    const std::string kind = distortion.IsScalar() ? distortion.Scalar() : "";
    std::vector<double> D;
    if (kind == "radtan") {
        D = numbers(child(node, "distortion_coeffs"), name + ".distortion_coeffs", 4);
    } else if (kind != "none") {
        throw Fault{name + "'s distortion model \"" + kind + "\" is neither radtan nor none"};
    }
    return {lens_of(f[0], f[1], f[2], f[3], std::move(D), width, height), width, height, {}};
}

}  // namespace

Result<Rig> rig_from_opencv(std::string_view intrinsics, std::string_view extrinsics,
                            const std::optional<PictureSize>& size) {
    return reading("OpenCV calibration", [&]() -> Result<Rig> {
        const YAML::Node lenses = parsed(intrinsics);
        const YAML::Node pose = parsed(extrinsics);
        std::optional<PictureSize> known = size;
        if (!known && lenses["image_width"] && lenses["image_height"]) {
            known = PictureSize{
                picture_side(number(lenses["image_width"], "image_width"), "image_width"),
                picture_side(number(lenses["image_height"], "image_height"), "image_height")};
        }
        if (!known) {
            return Error{"OpenCV's files do not say how large the pictures are.",
                         "Give --size W,H."};
        }
        const Camera left = opencv_camera(lenses, "1", *known);
        const Camera right = opencv_camera(lenses, "2", *known);
        RigidTransform T_right_from_left;
        T_right_from_left.R = rotation_of(numbers(child(pose, "R"), "R", 9), "R");
        const auto t = numbers(child(pose, "T"), "T", 3);
        T_right_from_left.t_mm = {t[0], t[1], t[2]};
        return pair_of(left, right, T_right_from_left, "opencv");
    });
}

Result<Rig> rig_from_ros(std::string_view left_text, std::string_view right_text) {
    return reading("ROS camera_info", [&]() -> Result<Rig> {
        const RosCamera left = ros_camera(left_text);
        const RosCamera right = ros_camera(right_text);
        // Rectified, the right camera stands beside the left one along x.
        RigidTransform T_rectified;
        T_rectified.t_mm.x() = right.offset_mm - left.offset_mm;
        const RigidTransform left_rectified{left.R_rectified_from_camera, Eigen::Vector3d::Zero()};
        const RigidTransform right_rectified{right.R_rectified_from_camera,
                                             Eigen::Vector3d::Zero()};
        return pair_of(left.camera, right.camera,
                       right_rectified.inverse() * T_rectified * left_rectified, "ros");
    });
}

Result<Rig> rig_from_kalibr(std::string_view camchain) {
    return reading("Kalibr camchain", [&]() -> Result<Rig> {
        const YAML::Node root = parsed(camchain);
        const YAML::Node second = child(root, "cam1");
        const Camera left = kalibr_camera(child(root, "cam0"), "cam0");
        const Camera right = kalibr_camera(second, "cam1");
        const auto T = numbers(child(second, "T_cn_cnm1"), "cam1.T_cn_cnm1", 16);
        RigidTransform T_right_from_left;
        T_right_from_left.R =
            rotation_of({T[0], T[1], T[2], T[4], T[5], T[6], T[8], T[9], T[10]}, "cam1.T_cn_cnm1");
        T_right_from_left.t_mm = mm_per_m * Eigen::Vector3d(T[3], T[7], T[11]);
        return pair_of(left, right, T_right_from_left, "kalibr");
    });
}

}  // namespace kambara
