// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/camera_view.h"

#include <cstddef>

#include "core/camera/zoom.h"
#include "hardware/simulated/blur.h"
#include "hardware/simulated/particle_view.h"
#include "hardware/simulated/target_view.h"

namespace kambara {
namespace {

constexpr int samples_across = 4;         // of a pixel, and as many down
constexpr double sharpest_blur_px = 0.1;  // less is none

}  // namespace

template <class Level>
CameraView<Level>::CameraView(const Scene& scene, const Camera& camera)
    : scene_(scene),
      camera_(camera),
      rays_(camera),
      lighting_(lighting_from({camera_, rays_}, camera.T_camera_from_rig)) {}

template <class Level>
Lighting<Level> CameraView<Level>::lighting_from(const Optics& optics,
                                                 const RigidTransform& T_camera_from_rig) const {
    return scene_.has_lamps()
               ? Lighting<Level>(scene_.water(), optics.camera, optics.rays, T_camera_from_rig)
               : Lighting<Level>(scene_.water());
}

template <class Level>
const SeabedView<Level>& CameraView<Level>::seabed_from_here(double time_s) const {
    const int which = scene_.seabed_at(time_s);
    std::call_once(seabed_once_[which], [&] {
        seabed_[which] = draw_seabed(scene_, which, camera_, rays_, lighting_,
                                     camera_.T_camera_from_rig, samples_across);
    });
    return seabed_[which];
}

template <class Level>
std::vector<Level> CameraView<Level>::with_target(const Optics& optics,
                                                  const SeabedView<Level>& seabed, double time_s,
                                                  const Lighting<Level>& lighting,
                                                  const std::vector<TargetPatch>& patches) const {
    std::vector<Level> picture = seabed.picture;
    draw_target(picture, seabed, scene_, optics.camera, optics.rays, lighting, patches,
                scene_.blur_px(time_s));
    return picture;
}

// The blur is that of the target's distance everywhere, unless water scatters forward: then it is
// only that share's, and drawn with the seabed and the target.
template <class Level>
void CameraView<Level>::finish(const Optics& optics, std::vector<Level>& picture, double time_s,
                               const Lighting<Level>& lighting,
                               const RigidTransform& T_camera_from_rig,
                               const std::vector<TargetPatch>& patches) const {
    const std::vector<Sheet> sheets(patches.begin(), patches.end());
    draw_specks(picture, scene_, time_s, optics.camera, lighting, T_camera_from_rig, sheets);
    draw_snow(picture, scene_, time_s, optics.camera, lighting, T_camera_from_rig, sheets);
    const auto light = static_cast<float>(scene_.light(time_s));
    if (light != 1.0F) {
        for (Level& value : picture) {
            value *= light;
        }
    }
    const double sigma_px = scene_.blur_px(time_s);
    if (!lighting.scatters_forward() && sigma_px > sharpest_blur_px) {
        blur(picture.data(), optics.camera.width_px,
             std::vector<double>(static_cast<std::size_t>(optics.camera.height_px), sigma_px));
    }
}

template <class Level>
std::vector<Level> CameraView<Level>::draw(double time_s) const {
    const Optics here{camera_, rays_};
    const auto patches =
        patches_in_camera(camera_.T_camera_from_rig * scene_.T_rig_from_target(time_s));
    std::vector<Level> picture;
    const std::int64_t since = scene_.still_since(time_s);
    if (since < 0) {
        picture = with_target(here, seabed_from_here(time_s), time_s, lighting_, patches);
    } else {
        std::shared_ptr<const std::vector<Level>> still;
        {
            std::lock_guard lock(mutex_);
            still = still_since_ == since ? still_ : nullptr;
        }
        if (!still) {
            still = std::make_shared<const std::vector<Level>>(
                with_target(here, seabed_from_here(time_s), time_s, lighting_, patches));
            std::lock_guard lock(mutex_);
            still_ = still;
            still_since_ = since;
        }
        picture = *still;
    }
    finish(here, picture, time_s, lighting_, camera_.T_camera_from_rig, patches);
    return picture;
}

template <class Level>
std::vector<Level> CameraView<Level>::draw_turned(double time_s,
                                                  const RigidTransform& T_camera_from_rig,
                                                  double magnification) const {
    if (magnification == 1.0) {
        return turned({camera_, rays_}, time_s, T_camera_from_rig);
    }
    const auto optics = zoomed_in(magnification);
    return turned({optics->camera, optics->rays}, time_s, T_camera_from_rig);
}

// A zoom mostly rests: its rays are worth keeping.
template <class Level>
std::shared_ptr<const typename CameraView<Level>::Zoomed> CameraView<Level>::zoomed_in(
    double magnification) const {
    std::lock_guard lock(mutex_);
    if (!zoomed_ || zoomed_->magnification != magnification) {
        Camera camera = camera_;
        camera.lens = zoomed(camera_.lens, magnification);
        zoomed_ = std::make_shared<const Zoomed>(Zoomed{magnification, camera, PixelRays(camera)});
    }
    return zoomed_;
}

template <class Level>
std::vector<Level> CameraView<Level>::turned(const Optics& optics, double time_s,
                                             const RigidTransform& T_camera_from_rig) const {
    const auto patches = patches_in_camera(T_camera_from_rig * scene_.T_rig_from_target(time_s));
    const Lighting<Level> lighting = lighting_from(optics, T_camera_from_rig);
    const SeabedView<Level> seabed = draw_seabed(scene_, scene_.seabed_at(time_s), optics.camera,
                                                 optics.rays, lighting, T_camera_from_rig, 1);
    std::vector<Level> picture = with_target(optics, seabed, time_s, lighting, patches);
    finish(optics, picture, time_s, lighting, T_camera_from_rig, patches);
    return picture;
}

template <class Level>
std::vector<TargetPatch> CameraView<Level>::patches_in_camera(
    const RigidTransform& T_camera_from_target) const {
    std::vector<TargetPatch> patches = scene_.sheets();
    for (TargetPatch& patch : patches) {
        patch.origin_mm = T_camera_from_target * patch.origin_mm;
        patch.across_mm = T_camera_from_target.R * patch.across_mm;
        patch.down_mm = T_camera_from_target.R * patch.down_mm;
    }
    return patches;
}

template class CameraView<float>;
template class CameraView<Colour>;

}  // namespace kambara
