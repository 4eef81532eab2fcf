// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/detected_views.h"

#include <random>
#include <utility>

#include "core/base/worker_pool.h"
#include "core/calibration/target_detector.h"
#include "tests/core/calibration/rig_samples.h"
#include "tests/support/box_scene.h"

namespace kambara::testing_support {
namespace {

BoxScene scene_of(const Camera& camera, const RigidTransform& T_rig_from_target,
                  std::uint32_t seed) {
    BoxScene scene;
    scene.camera_from_target = camera.T_camera_from_rig * T_rig_from_target;
    scene.lens = camera.lens;
    scene.width_px = camera.width_px;
    scene.height_px = camera.height_px;
    scene.seed = seed;
    return scene;
}

// Whether all of the target's corners are in the picture, a box no narrower than that.
bool shows_it(const Camera& camera, const Target& target, const RigidTransform& T_rig_from_target,
              double least_boxes_px) {
    std::vector<Eigen::Vector2d> corners;
    for (const auto& corner : corners_in_target_mm(target)) {
        const auto px = camera.project(T_rig_from_target * corner);
        if (!px || !camera.sees(*px)) {
            return false;
        }
        corners.push_back(*px);
    }
    return narrowest_box_px(corners) >= least_boxes_px;
}

// Whether the whole outline of each sheet and box has a place in the camera's picture plane.
bool can_be_drawn(const Camera& camera, const Target& target,
                  const RigidTransform& T_rig_from_target) {
    for (const TargetPatch& patch : patches_of(target)) {
        for (int i = 0; i <= 24; ++i) {
            for (int j = 0; j <= 24; ++j) {
                const Eigen::Vector3d at =
                    patch.origin_mm + i / 24.0 * patch.across_mm + j / 24.0 * patch.down_mm;
                if (!camera.project(T_rig_from_target * at)) {
                    return false;
                }
            }
        }
    }
    return true;
}

}  // namespace

std::vector<ShownTarget> shown_targets(const Rig& rig, int views, std::uint32_t seed,
                                       double least_boxes_px, double blur_px) {
    const Target target = two_plane_24();
    std::mt19937 random(seed);
    std::vector<ShownTarget> shown;
    while (static_cast<int>(shown.size()) < views) {
        const RigidTransform T = random_pose(target, {}, random);
        bool suits = shows_it(rig.left, target, T, least_boxes_px) &&
                     shows_it(*rig.right, target, T, least_boxes_px);
        for (const Camera* camera : cameras_of(rig)) {
            suits = suits && (camera == nullptr || can_be_drawn(*camera, target, T));
        }
        if (suits) {
            shown.push_back({T, {}});
        }
    }
    const auto cameras = cameras_of(rig);
    WorkerPool pool;
    pool.for_each(shown.size(), [&](std::size_t i) {
        for (std::size_t c = 0; c < cameras.size(); ++c) {
            if (cameras[c] != nullptr) {
                const auto noise = static_cast<std::uint32_t>(10000 * seed + 3 * i + c);
                BoxScene scene = scene_of(*cameras[c], shown[i].T_rig_from_target, noise);
                scene.blur_px = blur_px;
                shown[i].pictures.push_back(rendered(scene));
            }
        }
    });
    return shown;
}

std::vector<RigView> detected_views(const std::vector<ShownTarget>& shown, const Target& target) {
    std::vector<RigView> views(shown.size());
    WorkerPool pool;
    pool.for_each(shown.size(), [&](std::size_t i) {
        for (std::size_t c = 0; c < shown[i].pictures.size(); ++c) {
            auto found = detect_target(shown[i].pictures[c], target);
            if (found) {
                views[i].sights[c].corners = std::move(*found);
            } else {
                views[i].sights[c].fault = found.error().cause;
            }
        }
    });
    return views;
}

}  // namespace kambara::testing_support
