// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/rig_guess.h"

#include <cmath>
#include <opencv2/calib3d.hpp>

#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

constexpr std::size_t least_corners = 6;

const Camera* camera_of(const Rig& rig, std::size_t place) {
    return place == 0   ? &rig.left
           : place == 1 ? (rig.right ? &*rig.right : nullptr)
                        : (rig.pan_tilt ? &*rig.pan_tilt : nullptr);
}

bool fits(const Camera& camera, const PictureSize& size) {
    return camera.width_px > 0 && camera.height_px > 0 &&
           std::abs(static_cast<double>(camera.width_px) * size.height_px /
                        (static_cast<double>(camera.height_px) * size.width_px) -
                    1.0) < 0.01;
}

// The lens in pictures of this size.
Lens lens_for(const Camera& camera, const PictureSize& size) {
    if (camera.width_px == size.width_px && camera.height_px == size.height_px) {
        return camera.lens;
    }
    return scaled(camera.lens, size.width_px / static_cast<double>(camera.width_px),
                  size.height_px / static_cast<double>(camera.height_px));
}

LensBlock block_for(const Lens& lens, LensModel model, const Sensor& sensor) {
    const bool brown = std::holds_alternative<BrownLens>(lens);
    if (brown == (model == LensModel::brown)) {
        return block_of(lens);
    }
    const PinholeParameters p = pinhole_parameters(lens);
    if (model == LensModel::brown) {
        return {p.fx_px, p.fy_px, p.cx_px, p.cy_px};
    }
    const double f_mm = p.fy_px * sensor.dy_mm;
    return {f_mm, 0.0, p.cx_px, p.cy_px, p.fx_px * sensor.dx_prime_mm() / f_mm};
}

}  // namespace

RigGuess guess_from(const Rig& rig, const RigCalibratorOptions& options) {
    const Rig nominal = nominal_rig(options.medium);
    RigGuess guess;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (!options.cameras[c]) {
            continue;
        }
        const PictureSize& size = *options.cameras[c];
        const bool known = camera_of(rig, c) != nullptr && fits(*camera_of(rig, c), size);
        const Rig& from = known ? rig : nominal;
        Camera camera = *camera_of(from, c);
        if (!known && !fits(camera, size)) {
            const Rig unknown = unknown_camera(size.width_px, size.height_px);
            camera.lens = unknown.left.lens;
            camera.width_px = size.width_px;
            camera.height_px = size.height_px;
        }
        BundleCamera taken;
        taken.model = options.model;
        taken.sensor = options.sensor;
        taken.free_k3 = options.free_k3.value_or(false);
        taken.lens = block_for(lens_for(camera, size), options.model, options.sensor);
        if (!guess.cameras.empty()) {
            taken.camera_from_first =
                block_of(camera.T_camera_from_rig * from.left.T_camera_from_rig.inverse());
        }
        guess.places.push_back(c);
        guess.cameras.push_back(taken);
        guess.sizes.push_back(size);
    }
    return guess;
}

std::optional<PoseBlock> first_from_target(const RigGuess& guess,
                                           const std::vector<Eigen::Vector3d>& target_mm,
                                           const RigView& view) {
    for (std::size_t k = 0; k < guess.cameras.size(); ++k) {
        const BundleCamera& camera = guess.cameras[k];
        const Lens lens = lens_of(camera.lens, camera.model, camera.sensor);
        std::vector<cv::Point3d> points;
        std::vector<cv::Point2d> slopes;
        for (const DetectedCorner& corner : view.sights[guess.places[k]].corners) {
            const auto ray = unproject(lens, corner.px);
            if (ray && ray->direction.z() > 0.0) {
                const Eigen::Vector3d& at = target_mm[static_cast<std::size_t>(corner.id)];
                points.emplace_back(at.x(), at.y(), at.z());
                slopes.emplace_back(ray->direction.x() / ray->direction.z(),
                                    ray->direction.y() / ray->direction.z());
            }
        }
        if (points.size() < least_corners) {
            continue;
        }
        cv::Vec3d turn;
        cv::Vec3d t;
        if (!cv::solvePnP(points, slopes, cv::Matx33d::eye(), cv::noArray(), turn, t, false,
                          cv::SOLVEPNP_SQPNP) ||
            !std::isfinite(cv::norm(turn)) || !std::isfinite(cv::norm(t))) {
            continue;
        }
        const RigidTransform pose =
            transform_of(PoseBlock{turn[0], turn[1], turn[2], t[0], t[1], t[2]});
        return block_of(transform_of(camera.camera_from_first).inverse() * pose);
    }
    return std::nullopt;
}

}  // namespace kambara
