// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/parallel_range.h"

#include <string>

#include "core/stereo/position_method.h"

namespace kambara {

Result<double> parallel_range_mm(double baseline_mm, double f_mm, double disparity_px,
                                 double pixel_size_mm) {
    if (!(disparity_px > 0.0)) {
        return Error{
            "The disparity is " + std::to_string(disparity_px) +
                " px: for parallel cameras it must be positive.",
            "Check that left and right are not swapped and that the cameras are parallel."};
    }
    return baseline_mm * f_mm / (disparity_px * pixel_size_mm);
}

Result<Eigen::Vector3d> parallel_from_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                                           const Eigen::Vector2d& right_pixel) {
    if (auto suits = check_position_method(rig, PositionMethod::parallel); !suits) {
        return suits.error();
    }
    const auto left = unproject(rig.left.lens, left_pixel);
    const auto right = unproject(rig.right->lens, right_pixel);
    if (!left || !right) {
        return Error{"No ray reaches one of the pixels: it lies outside what the lens can show.",
                     "Check the pixels and that the rig file belongs to these cameras."};
    }
    // As pinhole cameras of one focal length would see it: f in px, then, and pixels of size 1.
    const Eigen::Vector3d in_left = left->direction / left->direction.z();
    const Eigen::Vector3d in_right = right->direction / right->direction.z();
    const double f_px = pinhole_parameters(rig.left.lens).fx_px;
    const auto depth =
        parallel_range_mm(baseline_mm(rig), f_px, f_px * (in_left.x() - in_right.x()), 1.0);
    return depth ? Result<Eigen::Vector3d>(*depth * in_left) : depth.error();
}

}  // namespace kambara
