// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/camera/rig.h"
#include "hardware/simulated/lighting.h"
#include "hardware/simulated/pixel_rays.h"
#include "hardware/simulated/scene.h"
#include "hardware/simulated/seabed_view.h"

namespace kambara {

/// Draws a scene as a camera of the rig sees it, by casting rays through its exact lens model:
/// every pixel's ray is exact, and its sixteen samples lie between such rays. The seabed is drawn
/// once, water and light included; a still target once a pose. Level is float for grey pictures
/// and Colour for coloured ones. Any thread.
template <class Level>
class CameraView {
  public:
    CameraView(const Scene& scene, const Camera& camera);

    /// The picture before noise, in grey levels, row by row, from where the camera is fixed.
    std::vector<Level> draw(double time_s) const;

    /// As above with the camera turned: nothing of it can be kept from the last picture, so the
    /// seabed gets one sample a pixel, of the pixel's width. Zoomed in, things are `magnification`
    /// times as large.
    std::vector<Level> draw_turned(double time_s, const RigidTransform& T_camera_from_rig,
                                   double magnification = 1.0) const;

  private:
    /// A lens, and its pixels' rays.
    struct Optics {
        const Camera& camera;
        const PixelRays& rays;
    };

    struct Zoomed {
        double magnification;
        Camera camera;
        PixelRays rays;
    };

    std::shared_ptr<const Zoomed> zoomed_in(double magnification) const;
    Lighting<Level> lighting_from(const Optics& optics,
                                  const RigidTransform& T_camera_from_rig) const;
    const SeabedView<Level>& seabed_from_here(double time_s) const;
    std::vector<Level> turned(const Optics& optics, double time_s,
                              const RigidTransform& T_camera_from_rig) const;
    std::vector<Level> with_target(const Optics& optics, const SeabedView<Level>& seabed,
                                   double time_s, const Lighting<Level>& lighting,
                                   const std::vector<TargetPatch>& patches) const;
    void finish(const Optics& optics, std::vector<Level>& picture, double time_s,
                const Lighting<Level>& lighting, const RigidTransform& T_camera_from_rig,
                const std::vector<TargetPatch>& patches) const;
    std::vector<TargetPatch> patches_in_camera(const RigidTransform& T_camera_from_target) const;

    const Scene& scene_;
    const Camera camera_;
    const PixelRays rays_;
    const Lighting<Level> lighting_;
    // A camera that is only ever turned needs none.
    mutable std::once_flag seabed_once_[Scene::seabeds];
    mutable SeabedView<Level> seabed_[Scene::seabeds];
    mutable std::mutex mutex_;  // of the cached still picture and zoomed lens
    mutable std::int64_t still_since_ = -1;
    mutable std::shared_ptr<const std::vector<Level>> still_;
    mutable std::shared_ptr<const Zoomed> zoomed_;
};

extern template class CameraView<float>;
extern template class CameraView<Colour>;

}  // namespace kambara
