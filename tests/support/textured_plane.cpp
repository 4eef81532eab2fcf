// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/textured_plane.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace kambara::testing_support {
namespace {

constexpr int samples = 2;  // across a pixel, and as many down

Frame frame_of(Image picture, std::int64_t index, double rate_hz) {
    Frame frame;
    frame.picture = std::make_shared<const Image>(std::move(picture));
    frame.index = index;
    frame.time_ns = static_cast<std::int64_t>(static_cast<double>(index) * 1e9 / rate_hz);
    return frame;
}

}  // namespace

double TexturedPlane::grey_at(double u, double v) const {
    // Waves whose lengths have no common measure: no two places look alike.
    const double waves = std::sin(u / 11.0 + 0.7 * std::sin(v / 37.0)) * std::cos(v / 13.0) +
                         0.8 * std::sin((u + 2.0 * v) / 29.0) + 0.6 * std::cos((u - v) / 71.0) +
                         0.5 * std::sin(u / 173.0) * std::sin(v / 131.0);
    return offset_grey + contrast_grey * waves / 1.6;
}

Image drawn(const TexturedPlane& plane, const Camera& camera) {
    Image picture(camera.width_px, camera.height_px);
    for (int y = 0; y < camera.height_px; ++y) {
        for (int x = 0; x < camera.width_px; ++x) {
            double sum = 0.0;
            for (int i = 0; i < samples * samples; ++i) {
                const Eigen::Vector2d pixel(x + (i % samples + 0.5) / samples - 0.5,
                                            y + (i / samples + 0.5) / samples - 0.5);
                const auto ray = camera.unproject(pixel);
                if (!ray) {
                    continue;
                }
                const Eigen::Vector3d hit =
                    ray->at((plane.origin_in_rig_mm.z() - ray->origin_mm.z()) / ray->direction.z());
                sum += plane.grey_at(hit.x() - plane.origin_in_rig_mm.x(),
                                     hit.y() - plane.origin_in_rig_mm.y());
            }
            picture.at(x, y) = static_cast<std::uint8_t>(
                std::lround(std::clamp(sum / (samples * samples), 0.0, 255.0)));
        }
    }
    return picture;
}

StereoFrame drawn_pair(const TexturedPlane& plane, const Rig& rig, std::int64_t index,
                       double rate_hz) {
    return {frame_of(drawn(plane, rig.left), index, rate_hz),
            frame_of(drawn(plane, *rig.right), index, rate_hz)};
}

}  // namespace kambara::testing_support
