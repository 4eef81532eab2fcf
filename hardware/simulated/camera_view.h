// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/camera/rig.h"
#include "core/image/image.h"
#include "hardware/simulated/scene.h"

namespace kambara {

/// Draws a scene as a fixed camera sees it, by casting rays through its exact lens model: every
/// pixel's ray is exact, those of its sixteen samples lie between the exact ones. The seabed is
/// drawn once; a still target once a pose. Any thread.
class CameraView {
  public:
    CameraView(const Scene& scene, const Camera& camera);

    /// The picture before noise, in grey levels, row by row.
    std::vector<float> draw(double time_s) const;

  private:
    struct Box {
        int x0, y0, x1, y1;  // one past the last
    };

    Eigen::Vector2f slope_at(double x, double y) const;
    void draw_target(std::vector<float>& grey, const RigidTransform& T_rig_from_target) const;
    void draw_box(std::vector<float>& grey, const Box& box,
                  const std::vector<TargetPatch>& sheets_in_camera) const;
    void draw_particles(std::vector<float>& grey, double time_s) const;
    Box box_of(const std::vector<TargetPatch>& sheets_in_camera) const;

    const Scene& scene_;
    const Camera camera_;
    std::vector<Eigen::Vector2f> slopes_;  // x/z and y/z of every pixel's ray, a border of one more
    std::vector<float> seabed_;
    mutable std::mutex mutex_;  // of the cached still picture
    mutable std::int64_t still_since_ = -1;
    mutable std::shared_ptr<const std::vector<float>> still_;
};

}  // namespace kambara
