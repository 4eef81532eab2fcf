// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/camera_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace kambara {
namespace {

constexpr int samples_across = 4;  // of a pixel, and as many down
constexpr float no_ray = 1e6F;

}  // namespace

CameraView::CameraView(const Scene& scene, const Camera& camera) : scene_(scene), camera_(camera) {
    const int width = camera.width_px;
    const int height = camera.height_px;
    slopes_.reserve(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height + 2));
    for (int y = -1; y <= height; ++y) {
        for (int x = -1; x <= width; ++x) {
            const auto ray = kambara::unproject(camera.lens, Eigen::Vector2d(x, y));
            slopes_.emplace_back(
                ray ? Eigen::Vector2f((ray->direction.head<2>() / ray->direction.z()).cast<float>())
                    : Eigen::Vector2f(no_ray, no_ray));
        }
    }
}

void CameraView::draw_seabed(std::vector<float>& grey, const RigidTransform& T_camera_from_rig,
                             int samples) const {
    const RigidTransform T_rig_from_camera = T_camera_from_rig.inverse();
    const double spread = 1.0 / pinhole_parameters(camera_.lens).fx_px / samples;
    grey.clear();
    grey.reserve(static_cast<std::size_t>(camera_.width_px) *
                 static_cast<std::size_t>(camera_.height_px));
    for (int y = 0; y < camera_.height_px; ++y) {
        for (int x = 0; x < camera_.width_px; ++x) {
            float sum = 0.0F;
            for (int i = 0; i < samples * samples; ++i) {
                const double dx = (i % samples + 0.5) / samples - 0.5;
                const double dy = (i / samples + 0.5) / samples - 0.5;
                const Eigen::Vector2f slope = slope_at(x + dx, y + dy);
                const Eigen::Vector3d direction =
                    Eigen::Vector3d(slope.x(), slope.y(), 1.0).normalized();
                sum += scene_.seabed_along(T_rig_from_camera * Ray{{0, 0, 0}, direction}, spread);
            }
            grey.push_back(sum / static_cast<float>(samples * samples));
        }
    }
}

// Between four exact rays the slope is as good as linear: over one pixel a lens bends by less than
// a thousandth of a pixel.
Eigen::Vector2f CameraView::slope_at(double x, double y) const {
    const int x0 = static_cast<int>(std::floor(x));
    const int y0 = static_cast<int>(std::floor(y));
    const auto a = static_cast<float>(x - x0);
    const auto b = static_cast<float>(y - y0);
    const std::size_t stride = static_cast<std::size_t>(camera_.width_px + 2);
    const Eigen::Vector2f* s = slopes_.data() + static_cast<std::size_t>(y0 + 1) * stride +
                               static_cast<std::size_t>(x0 + 1);
    return (1 - b) * ((1 - a) * s[0] + a * s[1]) + b * ((1 - a) * s[stride] + a * s[stride + 1]);
}

std::vector<float> CameraView::draw(double time_s) const {
    std::call_once(seabed_once_,
                   [&] { draw_seabed(seabed_, camera_.T_camera_from_rig, samples_across); });
    std::vector<float> grey;
    const std::int64_t since = scene_.still_since(time_s);
    if (since < 0) {
        grey = seabed_;
        draw_target(grey, camera_.T_camera_from_rig * scene_.T_rig_from_target(time_s));
    } else {
        std::shared_ptr<const std::vector<float>> still;
        {
            std::lock_guard lock(mutex_);
            still = still_since_ == since ? still_ : nullptr;
        }
        if (!still) {
            grey = seabed_;
            draw_target(grey, camera_.T_camera_from_rig * scene_.T_rig_from_target(time_s));
            still = std::make_shared<const std::vector<float>>(grey);
            std::lock_guard lock(mutex_);
            still_ = still;
            still_since_ = since;
        } else {
            grey = *still;
        }
    }
    draw_particles(grey, time_s, camera_.T_camera_from_rig);
    return grey;
}

std::vector<float> CameraView::draw_turned(double time_s,
                                           const RigidTransform& T_camera_from_rig) const {
    std::vector<float> grey;
    draw_seabed(grey, T_camera_from_rig, 1);
    draw_target(grey, T_camera_from_rig * scene_.T_rig_from_target(time_s));
    draw_particles(grey, time_s, T_camera_from_rig);
    return grey;
}

void CameraView::draw_target(std::vector<float>& grey,
                             const RigidTransform& T_camera_from_target) const {
    std::vector<TargetPatch> sheets = scene_.sheets();
    for (TargetPatch& sheet : sheets) {
        sheet.origin_mm = T_camera_from_target * sheet.origin_mm;
        sheet.across_mm = T_camera_from_target.R * sheet.across_mm;
        sheet.down_mm = T_camera_from_target.R * sheet.down_mm;
    }
    draw_box(grey, box_of(sheets), sheets);
}

// The pixels that the sheets can touch: their outlines are followed, since a lens bends them.
CameraView::Box CameraView::box_of(const std::vector<TargetPatch>& sheets) const {
    constexpr int steps = 8;
    Eigen::Vector2d low(1e9, 1e9);
    Eigen::Vector2d high(-1e9, -1e9);
    for (const TargetPatch& sheet : sheets) {
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps; ++j) {
                if (i % steps != 0 && j % steps != 0) {
                    continue;
                }
                const Eigen::Vector3d point = sheet.origin_mm +
                                              (static_cast<double>(i) / steps) * sheet.across_mm +
                                              (static_cast<double>(j) / steps) * sheet.down_mm;
                if (const auto pixel = kambara::project(camera_.lens, point)) {
                    low = low.cwiseMin(*pixel);
                    high = high.cwiseMax(*pixel);
                }
            }
        }
    }
    const auto inside = [](double value, int limit) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
    };
    return {inside(low.x() - 3.0, camera_.width_px), inside(low.y() - 3.0, camera_.height_px),
            inside(high.x() + 4.0, camera_.width_px), inside(high.y() + 4.0, camera_.height_px)};
}

void CameraView::draw_box(std::vector<float>& grey, const Box& box,
                          const std::vector<TargetPatch>& sheets) const {
    // Along the ray (x, y, 1) s a sheet's plane is met at s = offset / (normal . (x, y, 1)).
    struct Plane {
        Eigen::Vector3f normal;
        Eigen::Vector3f origin, across, down;  // across and down of unit length
        float offset, width, height;
    };
    std::vector<Plane> planes;
    for (const TargetPatch& sheet : sheets) {
        const Eigen::Vector3d across = sheet.across_mm.normalized();
        const Eigen::Vector3d down = sheet.down_mm.normalized();
        const Eigen::Vector3d normal = across.cross(down);
        planes.push_back({normal.cast<float>(), sheet.origin_mm.cast<float>(), across.cast<float>(),
                          down.cast<float>(), static_cast<float>(normal.dot(sheet.origin_mm)),
                          static_cast<float>(sheet.across_mm.norm()),
                          static_cast<float>(sheet.down_mm.norm())});
    }
    for (int y = box.y0; y < box.y1; ++y) {
        float* row =
            grey.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width_px);
        for (int x = box.x0; x < box.x1; ++x) {
            float sum = 0.0F;
            float range = 0.0F;
            int hits = 0;
            for (int i = 0; i < samples_across * samples_across; ++i) {
                const double dx = (i % samples_across + 0.5) / samples_across - 0.5;
                const double dy = (i / samples_across + 0.5) / samples_across - 0.5;
                const Eigen::Vector2f slope = slope_at(x + dx, y + dy);
                const Eigen::Vector3f direction(slope.x(), slope.y(), 1.0F);
                float nearest = std::numeric_limits<float>::max();
                float surface = 0.0F;
                for (std::size_t k = 0; k < planes.size(); ++k) {
                    const Plane& plane = planes[k];
                    const float s = plane.offset / plane.normal.dot(direction);
                    const Eigen::Vector3f at = s * direction - plane.origin;
                    const float u = at.dot(plane.across);
                    const float v = at.dot(plane.down);
                    if (s > 0.0F && s < nearest && u >= 0.0F && v >= 0.0F && u < plane.width &&
                        v < plane.height) {
                        nearest = s;
                        surface = scene_.surface(k, u, v);
                    }
                }
                if (nearest < std::numeric_limits<float>::max()) {
                    sum += surface;
                    range = nearest * direction.norm();
                    ++hits;
                }
            }
            if (hits > 0) {
                const float share = static_cast<float>(hits) / (samples_across * samples_across);
                const float seen = scene_.hazed(sum / static_cast<float>(hits), range);
                row[x] = (1.0F - share) * row[x] + share * seen;
            }
        }
    }
}

void CameraView::draw_particles(std::vector<float>& grey, double time_s,
                                const RigidTransform& T_camera_from_rig) const {
    const double f_px = pinhole_parameters(camera_.lens).fx_px;
    for (const Particle& particle : scene_.particles()) {
        const Eigen::Vector3d place =
            T_camera_from_rig * scene_.particle_place_mm(particle, time_s);
        const auto pixel = kambara::project(camera_.lens, place);
        if (!pixel || place.z() < 100.0) {
            continue;
        }
        const double sigma_px = std::hypot(0.6, f_px * particle.radius_mm / place.z());
        const double peak = particle.brightness_grey *
                            (1.0 - std::exp(-std::pow(f_px * particle.radius_mm / place.z(), 2)));
        const float strength =
            scene_.hazed(static_cast<float>(peak) + Scene::water_grey, place.norm()) -
            Scene::water_grey;
        const int reach = static_cast<int>(std::ceil(3.0 * sigma_px));
        const int cx = static_cast<int>(std::lround(pixel->x()));
        const int cy = static_cast<int>(std::lround(pixel->y()));
        for (int y = std::max(0, cy - reach); y <= std::min(camera_.height_px - 1, cy + reach);
             ++y) {
            float* row = grey.data() +
                         static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width_px);
            for (int x = std::max(0, cx - reach); x <= std::min(camera_.width_px - 1, cx + reach);
                 ++x) {
                const double away = (Eigen::Vector2d(x, y) - *pixel).squaredNorm();
                row[x] +=
                    strength * static_cast<float>(std::exp(-0.5 * away / (sigma_px * sigma_px)));
            }
        }
    }
}

}  // namespace kambara
