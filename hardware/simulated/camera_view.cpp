// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/camera_view.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "hardware/simulated/blur.h"

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

// The slopes of the four pixels (x, y), (x + 1, y) and, one stride on, those below them.
const Eigen::Vector2f* CameraView::slopes_from(int x, int y) const {
    return slopes_.data() +
           static_cast<std::size_t>(y + 1) * static_cast<std::size_t>(camera_.width_px + 2) +
           static_cast<std::size_t>(x + 1);
}

void CameraView::draw_seabed(int seabed, std::vector<float>& grey,
                             const RigidTransform& T_camera_from_rig, int samples) const {
    const RigidTransform T_rig_from_camera = T_camera_from_rig.inverse();
    const double spread = 1.0 / pinhole_parameters(camera_.lens).fx_px / samples;
    const std::size_t stride = static_cast<std::size_t>(camera_.width_px + 2);
    // Between four exact rays the slope is as good as linear: over one pixel a lens bends by about
    // a thousandth of a pixel. A sample is so far on from the first of its four.
    struct Sample {
        int x, y;
        float a, b;
    };
    std::vector<Sample> places;
    for (int i = 0; i < samples * samples; ++i) {
        const double dx = (i % samples + 0.5) / samples - 0.5;
        const double dy = (i / samples + 0.5) / samples - 0.5;
        places.push_back({dx < 0 ? -1 : 0, dy < 0 ? -1 : 0,
                          static_cast<float>(dx < 0 ? dx + 1 : dx),
                          static_cast<float>(dy < 0 ? dy + 1 : dy)});
    }
    grey.clear();
    grey.reserve(static_cast<std::size_t>(camera_.width_px) *
                 static_cast<std::size_t>(camera_.height_px));
    for (int y = 0; y < camera_.height_px; ++y) {
        for (int x = 0; x < camera_.width_px; ++x) {
            float sum = 0.0F;
            for (const Sample& at : places) {
                const Eigen::Vector2f* s = slopes_from(x + at.x, y + at.y);
                const Eigen::Vector2f slope =
                    (1 - at.b) * ((1 - at.a) * s[0] + at.a * s[1]) +
                    at.b * ((1 - at.a) * s[stride] + at.a * s[stride + 1]);
                const Eigen::Vector3d direction(slope.x(), slope.y(), 1.0);
                sum += scene_.seabed_along(
                    seabed, {T_rig_from_camera.t_mm, T_rig_from_camera.R * direction.normalized()},
                    spread);
            }
            grey.push_back(sum / static_cast<float>(places.size()));
        }
    }
}

const std::vector<float>& CameraView::seabed_from_here(double time_s) const {
    const int which = scene_.seabed_at(time_s);
    std::call_once(seabed_once_[which], [&] {
        draw_seabed(which, seabed_[which], camera_.T_camera_from_rig, samples_across);
    });
    return seabed_[which];
}

// The blur is that of the target's distance everywhere.
void CameraView::light_and_blur(std::vector<float>& grey, double time_s) const {
    const auto light = static_cast<float>(scene_.light(time_s));
    if (light != 1.0F) {
        for (float& value : grey) {
            value *= light;
        }
    }
    const double sigma_px = scene_.blur_px(time_s);
    if (sigma_px > 0.1) {
        blur(grey, camera_.width_px, camera_.height_px, sigma_px);
    }
}

std::vector<float> CameraView::draw(double time_s) const {
    const auto patches =
        patches_in_camera(camera_.T_camera_from_rig * scene_.T_rig_from_target(time_s));
    std::vector<float> grey;
    const std::int64_t since = scene_.still_since(time_s);
    if (since < 0) {
        grey = seabed_from_here(time_s);
        draw_target(grey, patches);
    } else {
        std::shared_ptr<const std::vector<float>> still;
        {
            std::lock_guard lock(mutex_);
            still = still_since_ == since ? still_ : nullptr;
        }
        if (!still) {
            grey = seabed_from_here(time_s);
            draw_target(grey, patches);
            still = std::make_shared<const std::vector<float>>(grey);
            std::lock_guard lock(mutex_);
            still_ = still;
            still_since_ = since;
        } else {
            grey = *still;
        }
    }
    draw_particles(grey, time_s, camera_.T_camera_from_rig, patches);
    light_and_blur(grey, time_s);
    return grey;
}

std::vector<float> CameraView::draw_turned(double time_s,
                                           const RigidTransform& T_camera_from_rig) const {
    const auto patches = patches_in_camera(T_camera_from_rig * scene_.T_rig_from_target(time_s));
    std::vector<float> grey;
    draw_seabed(scene_.seabed_at(time_s), grey, T_camera_from_rig, 1);
    draw_target(grey, patches);
    draw_particles(grey, time_s, T_camera_from_rig, patches);
    light_and_blur(grey, time_s);
    return grey;
}

std::vector<TargetPatch> CameraView::patches_in_camera(
    const RigidTransform& T_camera_from_target) const {
    std::vector<TargetPatch> patches = scene_.sheets();
    for (TargetPatch& patch : patches) {
        patch.origin_mm = T_camera_from_target * patch.origin_mm;
        patch.across_mm = T_camera_from_target.R * patch.across_mm;
        patch.down_mm = T_camera_from_target.R * patch.down_mm;
    }
    return patches;
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

void CameraView::draw_target(std::vector<float>& grey,
                             const std::vector<TargetPatch>& patches) const {
    const Box box = box_of(patches);
    const std::vector<Sheet> sheets(patches.begin(), patches.end());
    std::vector<Sheet::Meeting> meetings;
    for (int y = box.y0; y < box.y1; ++y) {
        draw_row(
            grey.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(camera_.width_px),
            y, box, sheets, meetings);
    }
}

// The sheets are met exactly at the pixels' corners only: within a pixel, a place on a sheet is as
// good as linear. `meetings` is this function's scratch memory.
void CameraView::draw_row(float* row, int y, const Box& box, const std::vector<Sheet>& sheets,
                          std::vector<Sheet::Meeting>& meetings) const {
    const std::size_t corners = static_cast<std::size_t>(std::max(0, box.x1 - box.x0)) + 1;
    const std::size_t stride = static_cast<std::size_t>(camera_.width_px + 2);
    meetings.clear();
    for (const Sheet& sheet : sheets) {
        for (int corner_y = y; corner_y <= y + 1; ++corner_y) {
            const Eigen::Vector2f* s = slopes_from(box.x0 - 1, corner_y - 1);
            for (std::size_t i = 0; i < corners; ++i, ++s) {
                meetings.push_back(sheet.meet(0.25F * (s[0] + s[1] + s[stride] + s[stride + 1])));
            }
        }
    }
    constexpr int n = samples_across * samples_across;
    for (int x = box.x0; x < box.x1; ++x) {
        std::array<float, n> depth;
        std::array<float, n> surface;
        depth.fill(std::numeric_limits<float>::max());
        for (std::size_t k = 0; k < sheets.size(); ++k) {
            const Sheet::Meeting* top =
                meetings.data() + 2 * k * corners + static_cast<std::size_t>(x - box.x0);
            const Sheet::Meeting* bottom = top + corners;
            if (std::min({top[0].depth_mm, top[1].depth_mm, bottom[0].depth_mm,
                          bottom[1].depth_mm}) <= 0.0F) {
                continue;
            }
            for (int j = 0; j < n; ++j) {
                const float a = (static_cast<float>(j % samples_across) + 0.5F) / samples_across;
                const float b = (static_cast<float>(j / samples_across) + 0.5F) / samples_across;
                const auto within = [&](float Sheet::Meeting::*part) {
                    return (1 - b) * ((1 - a) * top[0].*part + a * top[1].*part) +
                           b * ((1 - a) * bottom[0].*part + a * bottom[1].*part);
                };
                const float u = within(&Sheet::Meeting::u_mm);
                const float v = within(&Sheet::Meeting::v_mm);
                const float here = within(&Sheet::Meeting::depth_mm);
                const auto i = static_cast<std::size_t>(j);
                if (sheets[k].covers(u, v) && here < depth[i]) {
                    depth[i] = here;
                    surface[i] = scene_.surface(k, u, v);
                }
            }
        }
        float sum = 0.0F;
        float depth_sum = 0.0F;
        int hits = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (depth[i] < std::numeric_limits<float>::max()) {
                sum += surface[i];
                depth_sum += depth[i];
                ++hits;
            }
        }
        if (hits > 0) {
            const auto count = static_cast<float>(hits);
            const float length = std::sqrt(1.0F + slopes_from(x, y)->squaredNorm());
            const float seen = scene_.hazed(sum / count, depth_sum / count * length);
            row[x] += count / n * (seen - row[x]);
        }
    }
}

void CameraView::draw_particles(std::vector<float>& grey, double time_s,
                                const RigidTransform& T_camera_from_rig,
                                const std::vector<TargetPatch>& patches) const {
    const std::vector<Sheet> sheets(patches.begin(), patches.end());
    const double f_px = pinhole_parameters(camera_.lens).fx_px;
    for (const Particle& particle : scene_.particles()) {
        const Eigen::Vector3d place =
            T_camera_from_rig * scene_.particle_place_mm(particle, time_s);
        const auto pixel = kambara::project(camera_.lens, place);
        if (!pixel || place.z() < 100.0 ||
            std::any_of(sheets.begin(), sheets.end(),
                        [&](const Sheet& sheet) { return sheet.hides(place); })) {
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
