// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/seabed_view.h"

#include <algorithm>
#include <cstddef>

#include "hardware/simulated/blur.h"

namespace kambara {
namespace {

constexpr double fading_lengths = 3.0;  // of attenuation

// Between four exact rays the slope is as good as linear: over one pixel a lens bends by about a
// thousandth of a pixel. A sample is so far on from the first of its four.
struct Sample {
    int x, y;
    float a, b;
};

std::vector<Sample> samples_of_pixel(int across) {
    std::vector<Sample> places;
    for (int i = 0; i < across * across; ++i) {
        const double dx = (i % across + 0.5) / across - 0.5;
        const double dy = (i / across + 0.5) / across - 0.5;
        places.push_back({dx < 0 ? -1 : 0, dy < 0 ? -1 : 0,
                          static_cast<float>(dx < 0 ? dx + 1 : dx),
                          static_cast<float>(dy < 0 ? dy + 1 : dy)});
    }
    return places;
}

// The bed lies level, so that a row of the picture is about as far as its middle. Light that comes
// farther than the fading range is too little to tell how wide it is blurred.
std::vector<double> blur_of_rows(const Scene& scene, const Camera& camera, const PixelRays& rays,
                                 const RigidTransform& T_rig_from_camera) {
    std::vector<double> sigmas_px;
    for (int y = 0; y < camera.height_px; ++y) {
        const Eigen::Vector2f slope = *rays.from(camera.width_px / 2, y);
        const Eigen::Vector3d direction(slope.x(), slope.y(), 1.0);
        const double range_mm = scene.seabed_range_mm(
            {T_rig_from_camera.t_mm, T_rig_from_camera.R * direction.normalized()});
        const double widest_px = fading_lengths * scene.blur_px_a_length();
        sigmas_px.push_back(std::max(1e-3, range_mm == Scene::no_seabed
                                               ? widest_px
                                               : std::min(widest_px, scene.blur_px_at(range_mm))));
    }
    return sigmas_px;
}

template <class Level>
void add_scattered(SeabedView<Level>& view, const std::vector<double>& sigmas_px, int width) {
    std::vector<Level> blurred = view.scattered;
    blur(blurred.data(), width, sigmas_px);
    view.picture = view.sharp;
    for (std::size_t i = 0; i < blurred.size(); ++i) {
        view.picture[i] += blurred[i];
    }
}

}  // namespace

template <class Level>
SeabedView<Level> draw_seabed(const Scene& scene, int seabed, const Camera& camera,
                              const PixelRays& rays, const Lighting<Level>& lighting,
                              const RigidTransform& T_camera_from_rig, int samples) {
    const RigidTransform T_rig_from_camera = T_camera_from_rig.inverse();
    const double spread = 1.0 / pinhole_parameters(camera.lens).fx_px / samples;
    const std::size_t stride = rays.stride();
    const std::vector<Sample> places = samples_of_pixel(samples);
    const auto count = static_cast<float>(places.size());
    const bool forward = lighting.scatters_forward();
    const std::size_t pixels =
        static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
    SeabedView<Level> view;
    std::vector<Level>& sharp = forward ? view.sharp : view.picture;
    sharp.reserve(pixels);
    view.scattered.reserve(forward ? pixels : 0);
    for (int y = 0; y < camera.height_px; ++y) {
        for (int x = 0; x < camera.width_px; ++x) {
            Level sum = Channels<Level>::flat(0.0F);
            Level scattered = Channels<Level>::flat(0.0F);
            for (const Sample& at : places) {
                const Eigen::Vector2f* s = rays.from(x + at.x, y + at.y);
                const Eigen::Vector2f slope =
                    (1 - at.b) * ((1 - at.a) * s[0] + at.a * s[1]) +
                    at.b * ((1 - at.a) * s[stride] + at.a * s[stride + 1]);
                const Eigen::Vector3d direction(slope.x(), slope.y(), 1.0);
                const Ray ray{T_rig_from_camera.t_mm, T_rig_from_camera.R * direction.normalized()};
                const double range_mm = scene.seabed_range_mm(ray);
                if (range_mm == Scene::no_seabed) {
                    sum += lighting.endless(x, y);
                    continue;
                }
                const Level bed = scene.seabed<Level>(seabed, ray, range_mm, spread);
                sum += lighting.seen(bed, x, y, range_mm);
                if (forward) {
                    scattered += lighting.scattered(bed, x, y, range_mm);
                }
            }
            sharp.push_back(sum / count);
            if (forward) {
                view.scattered.push_back(scattered / count);
            }
        }
    }
    if (forward) {
        add_scattered(view, blur_of_rows(scene, camera, rays, T_rig_from_camera), camera.width_px);
    }
    return view;
}

template SeabedView<float> draw_seabed(const Scene&, int, const Camera&, const PixelRays&,
                                       const Lighting<float>&, const RigidTransform&, int);
template SeabedView<Colour> draw_seabed(const Scene&, int, const Camera&, const PixelRays&,
                                        const Lighting<Colour>&, const RigidTransform&, int);

}  // namespace kambara
