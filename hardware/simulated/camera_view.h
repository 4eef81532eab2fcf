// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/camera/rig.h"
#include "core/image/image.h"
#include "hardware/simulated/scene.h"
#include "hardware/simulated/sheet.h"

namespace kambara {

/// Draws a scene as a camera of the rig sees it, by casting rays through its exact lens model:
/// every pixel's ray is exact, and its sixteen samples lie between such rays. The seabed is drawn
/// once; a still target once a pose. Any thread.
class CameraView {
  public:
    CameraView(const Scene& scene, const Camera& camera);

    /// The picture before noise, in grey levels, row by row, from where the camera is fixed.
    std::vector<float> draw(double time_s) const;

    /// As above with the camera turned: nothing of it can be kept from the last picture, so the
    /// seabed gets one sample a pixel, of the pixel's width.
    std::vector<float> draw_turned(double time_s, const RigidTransform& T_camera_from_rig) const;

  private:
    struct Box {
        int x0, y0, x1, y1;  // one past the last
    };

    const Eigen::Vector2f* slopes_from(int x, int y) const;
    void draw_seabed(int seabed, std::vector<float>& grey, const RigidTransform& T_camera_from_rig,
                     int samples) const;
    const std::vector<float>& seabed_from_here(double time_s) const;
    void light_and_blur(std::vector<float>& grey, double time_s) const;
    std::vector<TargetPatch> patches_in_camera(const RigidTransform& T_camera_from_target) const;
    Box box_of(const std::vector<TargetPatch>& patches_in_camera) const;
    void draw_target(std::vector<float>& grey, const std::vector<TargetPatch>& patches) const;
    void draw_row(float* row, int y, const Box& box, const std::vector<Sheet>& sheets,
                  std::vector<Sheet::Meeting>& meetings) const;
    void draw_particles(std::vector<float>& grey, double time_s,
                        const RigidTransform& T_camera_from_rig,
                        const std::vector<TargetPatch>& patches) const;

    const Scene& scene_;
    const Camera camera_;
    std::vector<Eigen::Vector2f> slopes_;  // x/z and y/z of every pixel's ray, a border of one more
    // A camera that is only ever turned needs none.
    mutable std::once_flag seabed_once_[Scene::seabeds];
    mutable std::vector<float> seabed_[Scene::seabeds];
    mutable std::mutex mutex_;  // of the cached still picture
    mutable std::int64_t still_since_ = -1;
    mutable std::shared_ptr<const std::vector<float>> still_;
};

}  // namespace kambara
