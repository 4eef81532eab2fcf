// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/ray_pair.h"

#include <cstdio>
#include <string>

#include "core/base/angles.h"

namespace kambara {
namespace {

std::string text_of(const char* form, double a, double b) {
    char text[160];
    std::snprintf(text, sizeof text, form, a, b);
    return text;
}

Error no_ray(const char* side, const Eigen::Vector2d& pixel) {
    return {
        std::string("No ray reaches the ") + side + " pixel " +
            text_of("(%.2f, %.2f): it lies outside what the lens can show.", pixel.x(), pixel.y()),
        "Check the pixel and that the rig file belongs to these cameras."};
}

}  // namespace

Result<RayPair> ray_pair(const Rig& rig, const Eigen::Vector2d& left_pixel,
                         const Eigen::Vector2d& right_pixel, double min_parallax_rad) {
    const auto left = rig.left.unproject(left_pixel);
    if (!left) {
        return no_ray("left", left_pixel);
    }
    const auto right = rig.right.value().unproject(right_pixel);
    if (!right) {
        return no_ray("right", right_pixel);
    }
    const auto meeting = meeting_of(*left, *right);
    if (!meeting || meeting->angle_rad < min_parallax_rad) {
        return Error{
            text_of("The two rays are parallel to %.3f degrees (at least %.3f needed): the "
                    "point is too far away to measure.",
                    deg_from_rad(meeting ? meeting->angle_rad : 0.0),
                    deg_from_rad(min_parallax_rad)),
            "Bring the target nearer, or use cameras further apart."};
    }
    if (meeting->distance_a_mm <= 0.0 || meeting->distance_b_mm <= 0.0) {
        return Error{"The two rays run apart: they would meet behind a camera.",
                     "Check that both pixels show the same point, left and right not swapped."};
    }
    return RayPair{*left, *right, *meeting};
}

}  // namespace kambara
