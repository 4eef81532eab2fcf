// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/particle_view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kambara {
namespace {

constexpr double focused_at_mm = 1500.0;
constexpr double aperture_mm = 2.0;
constexpr double pixel_radius_px = 0.56;  // of the disc with a pixel's area
constexpr float faintest = 0.01F;  // a share of a pixel that is worth a grey level at the most

bool hidden(const std::vector<Sheet>& sheets, const Eigen::Vector3d& place) {
    return std::any_of(sheets.begin(), sheets.end(),
                       [&](const Sheet& sheet) { return sheet.hides(place); });
}

// A flake's picture: the disc of the flake spread by the disc of its blur. What share of a pixel
// it covers is the same in the middle and falls to nothing at the rim.
struct Disc {
    double x_px, y_px;
    double range_mm;
    float share;
    float inner_px, outer_px;
    float grey;
};

Disc disc_of(const Flake& flake, const Eigen::Vector2d& pixel, const Eigen::Vector3d& place,
             double f_px) {
    const double sharp_px = 0.5 * static_cast<double>(flake.diameter_mm) * f_px / place.z();
    const double defocus_px =
        0.5 * aperture_mm * f_px * std::abs(1.0 / place.z() - 1.0 / focused_at_mm);
    const double blur_px = std::hypot(pixel_radius_px, defocus_px);
    const double small = std::min(sharp_px, blur_px);
    const double large = std::max(sharp_px, blur_px);
    const double share = sharp_px < blur_px ? (sharp_px * sharp_px) / (blur_px * blur_px) : 1.0;
    return {pixel.x(),
            pixel.y(),
            place.norm(),
            static_cast<float>(share),
            static_cast<float>(large - small),
            static_cast<float>(large + small),
            flake.grey};
}

std::vector<Disc> discs_of(const Scene& scene, double time_s, const Camera& camera,
                           const RigidTransform& T_camera_from_rig,
                           const std::vector<Sheet>& sheets) {
    const double f_px = pinhole_parameters(camera.lens).fx_px;
    // Wider than any picture of a rig, to leave out quickly what is beside it.
    const auto widest = static_cast<float>(0.75 * camera.width_px / f_px);
    const auto highest = static_cast<float>(0.75 * camera.height_px / f_px);
    const auto thinnest =
        static_cast<float>(2.0 * std::sqrt(static_cast<double>(faintest)) * pixel_radius_px / f_px);
    const Eigen::Matrix3f R = T_camera_from_rig.R.cast<float>();
    const Eigen::Vector3f t = T_camera_from_rig.t_mm.cast<float>();
    std::vector<Disc> discs;
    for (const Flake& flake : scene.snow().flakes()) {
        const Eigen::Vector3f at = R * Snow::place_mm(flake, time_s) + t;
        if (at.z() < 30.0F || std::abs(at.x()) > widest * at.z() + 20.0F ||
            std::abs(at.y()) > highest * at.z() + 20.0F || flake.diameter_mm < thinnest * at.z()) {
            continue;
        }
        const Eigen::Vector3d place = at.cast<double>();
        const auto pixel = kambara::project(camera.lens, place);
        if (pixel && !hidden(sheets, place)) {
            discs.push_back(disc_of(flake, *pixel, place, f_px));
        }
    }
    std::sort(discs.begin(), discs.end(),
              [](const Disc& a, const Disc& b) { return a.range_mm > b.range_mm; });
    return discs;
}

}  // namespace

template <class Level>
void draw_specks(std::vector<Level>& picture, const Scene& scene, double time_s,
                 const Camera& camera, const Lighting<Level>& lighting,
                 const RigidTransform& T_camera_from_rig, const std::vector<Sheet>& sheets) {
    const double f_px = pinhole_parameters(camera.lens).fx_px;
    for (const Particle& particle : scene.particles()) {
        const Eigen::Vector3d place = T_camera_from_rig * scene.particle_place_mm(particle, time_s);
        const auto pixel = kambara::project(camera.lens, place);
        if (!pixel || place.z() < 100.0 || hidden(sheets, place)) {
            continue;
        }
        const double sigma_px = std::hypot(0.6, f_px * particle.radius_mm / place.z());
        const double peak = particle.brightness_grey *
                            (1.0 - std::exp(-std::pow(f_px * particle.radius_mm / place.z(), 2)));
        const Level strength =
            lighting.added(static_cast<float>(peak), pixel->x(), pixel->y(), place.norm());
        const int reach = static_cast<int>(std::ceil(3.0 * sigma_px));
        const int cx = static_cast<int>(std::lround(pixel->x()));
        const int cy = static_cast<int>(std::lround(pixel->y()));
        for (int y = std::max(0, cy - reach); y <= std::min(camera.height_px - 1, cy + reach);
             ++y) {
            Level* row = picture.data() +
                         static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width_px);
            for (int x = std::max(0, cx - reach); x <= std::min(camera.width_px - 1, cx + reach);
                 ++x) {
                const double away = (Eigen::Vector2d(x, y) - *pixel).squaredNorm();
                row[x] +=
                    strength * static_cast<float>(std::exp(-0.5 * away / (sigma_px * sigma_px)));
            }
        }
    }
}

template <class Level>
void draw_snow(std::vector<Level>& picture, const Scene& scene, double time_s, const Camera& camera,
               const Lighting<Level>& lighting, const RigidTransform& T_camera_from_rig,
               const std::vector<Sheet>& sheets) {
    if (scene.snow().flakes().empty()) {
        return;
    }
    for (const Disc& disc : discs_of(scene, time_s, camera, T_camera_from_rig, sheets)) {
        const double reach = static_cast<double>(disc.outer_px);
        const int x0 = std::max(0, static_cast<int>(std::ceil(disc.x_px - reach)));
        const int x1 = std::min(camera.width_px - 1, static_cast<int>(disc.x_px + reach));
        const int y0 = std::max(0, static_cast<int>(std::ceil(disc.y_px - reach)));
        const int y1 = std::min(camera.height_px - 1, static_cast<int>(disc.y_px + reach));
        if (x0 > x1 || y0 > y1) {
            continue;
        }
        const Level seen =
            lighting.seen(Channels<Level>::flat(disc.grey), disc.x_px, disc.y_px, disc.range_mm);
        const float rim_px = disc.outer_px - disc.inner_px;
        for (int y = y0; y <= y1; ++y) {
            Level* row = picture.data() +
                         static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width_px);
            const auto dy = static_cast<float>(y - disc.y_px);
            for (int x = x0; x <= x1; ++x) {
                const auto dx = static_cast<float>(x - disc.x_px);
                const float within = (disc.outer_px - std::sqrt(dx * dx + dy * dy)) / rim_px;
                if (within > 0.0F) {
                    row[x] += disc.share * std::min(1.0F, within) * (seen - row[x]);
                }
            }
        }
    }
}

template void draw_specks(std::vector<float>&, const Scene&, double, const Camera&,
                          const Lighting<float>&, const RigidTransform&, const std::vector<Sheet>&);
template void draw_specks(std::vector<Colour>&, const Scene&, double, const Camera&,
                          const Lighting<Colour>&, const RigidTransform&,
                          const std::vector<Sheet>&);
template void draw_snow(std::vector<float>&, const Scene&, double, const Camera&,
                        const Lighting<float>&, const RigidTransform&, const std::vector<Sheet>&);
template void draw_snow(std::vector<Colour>&, const Scene&, double, const Camera&,
                        const Lighting<Colour>&, const RigidTransform&, const std::vector<Sheet>&);

}  // namespace kambara
