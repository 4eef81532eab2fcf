// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/candidate_poses.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/base/angles.h"

namespace kambara {
namespace {

constexpr double margin_px = 10.0;
constexpr double least_spacing_px = 8.0;
constexpr double most_aslant_deg = 65.0;
constexpr double most_roll_deg = 40.0;
constexpr int positions_across = 7;
constexpr int positions_down = 5;
constexpr int depths = 8;
constexpr double nearest_in_radii = 1.6;
constexpr double depth_step = 1.25;

// Turn about the upright axis and tilt about the one across, degrees.
constexpr std::array<std::array<double, 2>, 11> slants{{{0, 0},
                                                        {12, 0},
                                                        {-12, 0},
                                                        {35, 0},
                                                        {-35, 0},
                                                        {0, 35},
                                                        {0, -35},
                                                        {25, 25},
                                                        {-25, 25},
                                                        {25, -25},
                                                        {-25, -25}}};

struct Extent {
    Eigen::Vector3d middle_mm = Eigen::Vector3d::Zero();
    double radius_mm = 0.0;
};

Extent extent_of(const std::vector<Eigen::Vector3d>& corners) {
    Extent extent;
    extent.middle_mm = middle_of(corners);
    for (const auto& corner : corners) {
        extent.radius_mm = std::max(extent.radius_mm, (corner - extent.middle_mm).norm());
    }
    return extent;
}

// Everything of the target that the test of a pose needs, worked out once.
class Visibility {
  public:
    Visibility(const RigGuess& guess, const Target& target)
        : guess_(guess), corners_(corners_in_target_mm(target)), extent_(extent_of(corners_)) {
        for (const TargetPatch& patch : patches_of(target)) {
            if (patch.sheet) {
                sheets_.push_back(patch);
            }
        }
        for (const BundleCamera& camera : guess.cameras) {
            lenses_.push_back(lens_of(camera.lens, camera.model, camera.sensor));
            poses_.push_back(transform_of(camera.camera_from_first));
        }
    }

    const Extent& extent() const { return extent_; }

    // The camera with the smallest field of view: nothing is seen by all that it does not see.
    std::size_t narrowest() const {
        std::size_t best = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < lenses_.size(); ++k) {
            const double width = guess_.sizes[k].width_px / pinhole_parameters(lenses_[k]).fx_px;
            if (width < least) {
                least = width;
                best = k;
            }
        }
        return best;
    }

    // The point at a depth on a pixel's ray, in the first camera's frame.
    std::optional<Eigen::Vector3d> point_under(std::size_t k, const Eigen::Vector2d& px,
                                               double depth_mm) const {
        const auto ray = unproject(lenses_[k], px);
        if (!ray || ray->direction.z() < 0.1) {
            return std::nullopt;
        }
        return poses_[k].inverse() * (ray->direction * (depth_mm / ray->direction.z()));
    }

    bool holds(const RigidTransform& T_first_from_target) const {
        for (std::size_t k = 0; k < lenses_.size(); ++k) {
            const RigidTransform T = poses_[k] * T_first_from_target;
            if (!faced(T) || !upright(k, T) || !all_inside(k, T)) {
                return false;
            }
        }
        return true;
    }

  private:
    static bool faced(const RigidTransform& T, const TargetPatch& sheet) {
        const Eigen::Vector3d normal = sheet.across_mm.cross(sheet.down_mm).normalized();
        const Eigen::Vector3d middle =
            T * (sheet.origin_mm + 0.5 * (sheet.across_mm + sheet.down_mm));
        return (T.R * normal).dot(middle.normalized()) > std::cos(rad_from_deg(most_aslant_deg));
    }

    bool faced(const RigidTransform& T) const {
        return std::all_of(sheets_.begin(), sheets_.end(),
                           [&T](const TargetPatch& sheet) { return faced(T, sheet); });
    }

    bool upright(std::size_t k, const RigidTransform& T) const {
        const auto middle = project(lenses_[k], T * extent_.middle_mm);
        const auto below =
            project(lenses_[k],
                    T * (extent_.middle_mm + 0.2 * extent_.radius_mm * Eigen::Vector3d::UnitY()));
        if (!middle || !below) {
            return false;
        }
        const Eigen::Vector2d down = *below - *middle;
        return std::abs(std::atan2(down.x(), down.y())) < rad_from_deg(most_roll_deg);
    }

    bool all_inside(std::size_t k, const RigidTransform& T) const {
        const PictureSize& size = guess_.sizes[k];
        std::optional<Eigen::Vector2d> before;
        for (const auto& corner : corners_) {
            const auto px = project(lenses_[k], T * corner);
            if (!px || px->minCoeff() < margin_px || px->x() > size.width_px - 1 - margin_px ||
                px->y() > size.height_px - 1 - margin_px ||
                (before && (*px - *before).norm() < least_spacing_px)) {
                return false;
            }
            before = px;
        }
        return true;
    }

    const RigGuess& guess_;
    std::vector<Eigen::Vector3d> corners_;
    Extent extent_;
    std::vector<TargetPatch> sheets_;
    std::vector<Lens> lenses_;
    std::vector<RigidTransform> poses_;
};

}  // namespace

Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& corners_mm) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& corner : corners_mm) {
        middle += corner / static_cast<double>(corners_mm.size());
    }
    return middle;
}

Eigen::Vector3d facing(const Target& target) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const TargetPatch& patch : patches_of(target)) {
        if (patch.sheet) {
            sum += patch.across_mm.cross(patch.down_mm).normalized();
        }
    }
    return sum.norm() > 1e-6 ? sum.normalized().eval() : Eigen::Vector3d::UnitZ();
}

std::optional<Eigen::Vector2d> pixel_in(const RigGuess& guess, std::size_t camera,
                                        const RigidTransform& T_first_from_target,
                                        const Eigen::Vector3d& on_target_mm) {
    const BundleCamera& c = guess.cameras[camera];
    return project(lens_of(c.lens, c.model, c.sensor),
                   transform_of(c.camera_from_first) * (T_first_from_target * on_target_mm));
}

bool can_be_found(const RigGuess& guess, const Target& target,
                  const RigidTransform& T_first_from_target) {
    return Visibility(guess, target).holds(T_first_from_target);
}

std::vector<RigidTransform> candidate_poses(const RigGuess& guess, const Target& target) {
    const Visibility visibility(guess, target);
    const Extent& extent = visibility.extent();
    const Eigen::Matrix3d towards_us =
        Eigen::Quaterniond::FromTwoVectors(facing(target), Eigen::Vector3d::UnitZ())
            .toRotationMatrix();
    const std::size_t narrowest = visibility.narrowest();
    const PictureSize& size = guess.sizes[narrowest];
    std::vector<RigidTransform> poses;
    int tried = 0;
    for (int depth = 0; depth < depths; ++depth) {
        const double z_mm = nearest_in_radii * extent.radius_mm * std::pow(depth_step, depth);
        for (int place = 0; place < positions_across * positions_down; ++place) {
            const Eigen::Vector2d px(
                (place % positions_across + 0.5) / positions_across * size.width_px,
                (std::floor(place / positions_across) + 0.5) / positions_down * size.height_px);
            const auto at = visibility.point_under(narrowest, px, z_mm);
            if (!at) {
                continue;
            }
            for (const auto& [turn, tilt] : slants) {
                const double roll = rad_from_deg(20.0) * (++tried % 3 - 1);
                RigidTransform T;
                T.R = Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                      rotation_about_y(rad_from_deg(turn)) * rotation_about_x(rad_from_deg(tilt)) *
                      towards_us;
                T.t_mm = *at - T.R * extent.middle_mm;
                if (visibility.holds(T)) {
                    poses.push_back(T);
                }
            }
        }
    }
    return poses;
}

}  // namespace kambara
