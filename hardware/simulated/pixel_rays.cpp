// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/pixel_rays.h"

namespace kambara {
namespace {

constexpr float no_ray = 1e6F;

}  // namespace

PixelRays::PixelRays(const Camera& camera)
    : stride_(static_cast<std::size_t>(camera.width_px + 2)) {
    slopes_.reserve(stride_ * static_cast<std::size_t>(camera.height_px + 2));
    for (int y = -1; y <= camera.height_px; ++y) {
        for (int x = -1; x <= camera.width_px; ++x) {
            const auto ray = kambara::unproject(camera.lens, Eigen::Vector2d(x, y));
            slopes_.emplace_back(
                ray ? Eigen::Vector2f((ray->direction.head<2>() / ray->direction.z()).cast<float>())
                    : Eigen::Vector2f(no_ray, no_ray));
        }
    }
}

}  // namespace kambara
