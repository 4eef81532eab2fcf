// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/textured_plane.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace kambara::testing_support {
namespace {

constexpr int samples = 2;  // across a pixel, and as many down

// A value in [-1, 1] that belongs to a lattice point.
double lattice(std::int64_t x, std::int64_t y, std::uint64_t which) {
    auto h = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ULL ^
             static_cast<std::uint64_t>(y) * 0xc2b2ae3d27d4eb4fULL ^ which * 0x165667b19e3779f9ULL;
    h = (h ^ (h >> 29U)) * 0xbf58476d1ce4e5b9ULL;
    h = (h ^ (h >> 32U)) * 0x94d049bb133111ebULL;
    return static_cast<double>(h >> 11U) / 4503599627370496.0 - 1.0;
}

// Lattice values joined so that value and slope are smooth.
double smoothed(double u, double v, std::uint64_t which) {
    const auto x = static_cast<std::int64_t>(std::floor(u));
    const auto y = static_cast<std::int64_t>(std::floor(v));
    const auto ease = [](double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); };
    const double a = ease(u - static_cast<double>(x));
    const double b = ease(v - static_cast<double>(y));
    return (1 - b) * ((1 - a) * lattice(x, y, which) + a * lattice(x + 1, y, which)) +
           b * ((1 - a) * lattice(x, y + 1, which) + a * lattice(x + 1, y + 1, which));
}

Frame frame_of(Image picture, std::int64_t index, double rate_hz) {
    Frame frame;
    frame.picture = std::make_shared<const Image>(std::move(picture));
    frame.index = index;
    frame.time_ns = static_cast<std::int64_t>(static_cast<double>(index) * 1e9 / rate_hz);
    return frame;
}

}  // namespace

double TexturedPlane::grey_at(double u, double v) const {
    // Two sizes of smoothed random values: no two places look alike.
    const double value = smoothed(u / (14.0 * size), v / (14.0 * size), 1) +
                         1.2 * smoothed(u / (45.0 * size), v / (45.0 * size), 2);
    return offset_grey + contrast_grey * value;
}

Image drawn(const TexturedPlane& plane, const Camera& camera) {
    return drawn(plane, camera, {0, 0, camera.width_px, camera.height_px});
}

Image drawn(const TexturedPlane& plane, const Camera& camera, const Rectangle& part) {
    Image picture(camera.width_px, camera.height_px, 1,
                  static_cast<std::uint8_t>(std::lround(plane.offset_grey)));
    for (int y = std::max(0, part.y); y < std::min(camera.height_px, part.y + part.height); ++y) {
        for (int x = std::max(0, part.x); x < std::min(camera.width_px, part.x + part.width); ++x) {
            double sum = 0.0;
            for (int i = 0; i < samples * samples; ++i) {
                const Eigen::Vector2d pixel(x + (i % samples + 0.5) / samples - 0.5,
                                            y + (i / samples + 0.5) / samples - 0.5);
                const auto ray = camera.unproject(pixel);
                if (!ray) {
                    continue;
                }
                const Eigen::Vector3d normal(-plane.slope.x(), -plane.slope.y(), 1.0);
                const Eigen::Vector3d hit =
                    ray->at((plane.origin_in_rig_mm - ray->origin_mm).dot(normal) /
                            ray->direction.dot(normal));
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
