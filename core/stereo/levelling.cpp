// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/levelling.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/base/angles.h"
#include "core/base/median.h"

namespace kambara {
namespace {

using Points = std::vector<Eigen::Vector3d>;

struct Axes {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d directions = Eigen::Matrix3d::Identity();  // columns, of rising spread
    Eigen::Vector3d spread = Eigen::Vector3d::Zero();          // sums of squares
};

Axes axes_of(const Points& points) {
    Axes axes;
    for (const Eigen::Vector3d& p : points) {
        axes.mean += p / static_cast<double>(points.size());
    }
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& p : points) {
        squares += (p - axes.mean) * (p - axes.mean).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(squares);
    axes.directions = solved.eigenvectors();
    axes.spread = solved.eigenvalues().cwiseMax(0.0);
    return axes;
}

// Distance from the line of the largest spread, or from the plane across the least one.
double distance_mm(const Axes& axes, const Eigen::Vector3d& point, bool from_line) {
    const Eigen::Vector3d off = point - axes.mean;
    const double along = off.dot(axes.directions.col(from_line ? 2 : 0));
    return from_line ? (off - along * axes.directions.col(2)).norm() : std::abs(along);
}

// Fits again without what lies far off, until nothing does.
Points without_outliers(Points points, bool line, std::size_t least, double deviations) {
    for (int round = 0; round < 10; ++round) {
        const Axes axes = axes_of(points);
        std::vector<double> distances;
        for (const Eigen::Vector3d& p : points) {
            distances.push_back(distance_mm(axes, p, line));
        }
        const double gate = std::max(deviations * 1.4826 * median(distances), 1e-9);
        Points kept;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (distances[i] <= gate) {
                kept.push_back(points[i]);
            }
        }
        if (kept.size() == points.size() || kept.size() < least) {
            return points;
        }
        points = std::move(kept);
    }
    return points;
}

Error not_known_well(double sigma_rad) {
    return {"The points scatter so much that the mount's angle is known to " +
                std::to_string(deg_from_rad(sigma_rad)) + " degrees only.",
            "Measure more points, over more height, nearer to the rig."};
}

Error too_few(std::size_t points, std::size_t least) {
    return {std::to_string(points) + " points are too few to level by.",
            "Give at least " + std::to_string(least) + "."};
}

// The deviation of a direction's angle in the plane that `across` and the direction span.
double angle_sigma(const Points& points, const Eigen::Vector3d& mean, const Eigen::Vector3d& along,
                   const Eigen::Vector3d& across, int taken) {
    double off = 0.0;
    double lever = 0.0;
    for (const Eigen::Vector3d& p : points) {
        off += std::pow((p - mean).dot(across), 2);
        lever += std::pow((p - mean).dot(along), 2);
    }
    return std::sqrt(off / (static_cast<double>(points.size()) - taken) / std::max(lever, 1e-12));
}

double extent(const Points& points, const Eigen::Vector3d& along) {
    double least = HUGE_VAL;
    double most = -HUGE_VAL;
    for (const Eigen::Vector3d& p : points) {
        least = std::min(least, p.dot(along));
        most = std::max(most, p.dot(along));
    }
    return most - least;
}

bool all_finite(const Points& points) {
    return std::all_of(points.begin(), points.end(), [](const auto& p) { return p.allFinite(); });
}

const Error no_number{"A point has a coordinate that is no number.", "Leave it out."};

}  // namespace

Result<Levelling> level_from_vertical(const Points& points_in_rig_mm,
                                      const LevellingOptions& options) {
    constexpr std::size_t least = 4;
    if (points_in_rig_mm.size() < least) {
        return too_few(points_in_rig_mm.size(), least);
    }
    if (!all_finite(points_in_rig_mm)) {
        return no_number;
    }
    const Points points =
        without_outliers(points_in_rig_mm, true, least, options.outlier_deviations);
    const Axes axes = axes_of(points);
    if (!(axes.spread[2] > 0.0) || axes.spread[1] > 0.1 * axes.spread[2]) {
        return Error{"The target was not moved along a line.",
                     "Move it straight up or down, as on a plumb line, and nothing else."};
    }
    Eigen::Vector3d down = axes.directions.col(2);
    down = down.y() < 0.0 ? Eigen::Vector3d(-down) : down;
    Levelling result;
    result.mount = mount_of_down(down);
    if (std::abs(result.mount.pitch_rad) > options.largest_tilt_rad ||
        std::abs(result.mount.roll_rad) > options.largest_tilt_rad) {
        return Error{"The movement is far from upright in the pictures.",
                     "Move the target up and down, not across or away; a rig that looks down by "
                     "more than 60 degrees can't be levelled so."};
    }
    // The plumb line's errors forward or backward are pitch, those sideways roll.
    const Eigen::Matrix3d R = R_level_from_rig(result.mount);
    const double pitch_sigma = angle_sigma(points, axes.mean, down, R.row(2).transpose(), 2);
    const double side_sigma = angle_sigma(points, axes.mean, down, R.row(0).transpose(), 2);
    result.mount.pitch_sigma_rad = pitch_sigma;
    result.mount.roll_sigma_rad = side_sigma / std::cos(result.mount.pitch_rad);
    const double worse_sigma = std::max(pitch_sigma, *result.mount.roll_sigma_rad);
    if (!(worse_sigma <= options.largest_sigma_rad)) {
        return not_known_well(worse_sigma);
    }
    const auto count = static_cast<double>(points.size());
    result.axis_in_rig = down;
    result.extent_mm = extent(points, down);
    result.rms_mm = std::sqrt((axes.spread[0] + axes.spread[1]) / count);
    result.points_used = static_cast<int>(points.size());
    result.points_left_out = static_cast<int>(points_in_rig_mm.size() - points.size());
    return result;
}

Result<Levelling> level_from_wall(const Points& points_in_rig_mm, double roll_rad,
                                  const LevellingOptions& options) {
    constexpr std::size_t least = 6;
    if (points_in_rig_mm.size() < least) {
        return too_few(points_in_rig_mm.size(), least);
    }
    if (!all_finite(points_in_rig_mm)) {
        return no_number;
    }
    const Points points =
        without_outliers(points_in_rig_mm, false, least, options.outlier_deviations);
    const Axes axes = axes_of(points);
    if (!(axes.spread[1] > 1e-3 * axes.spread[2]) || axes.spread[0] > 0.1 * axes.spread[1]) {
        return Error{"The points do not lie spread over a plane.",
                     "Measure points all over a flat, upright wall."};
    }
    Eigen::Vector3d into = axes.directions.col(0);
    into = into.z() < 0.0 ? Eigen::Vector3d(-into) : into;
    if (into.z() < std::cos(options.largest_tilt_rad)) {
        return Error{"The wall is seen too much from its side.",
                     "Stand the rig before the wall, looking at it."};
    }
    Levelling result;
    result.mount.roll_rad = roll_rad;
    // Into the wall is level: (sin h, 0, cos h) there, for a wall that faces h to the side.
    const Eigen::Vector3d unrolled = R_level_from_rig(result.mount) * into;
    result.mount.pitch_rad = std::atan2(-unrolled.y(), unrolled.z());
    // Up the wall, by how much the plane turns about the level line in it.
    const Eigen::Vector3d down = R_level_from_rig(result.mount).row(1).transpose();
    const Eigen::Vector3d level_in_wall = down.cross(into).normalized();
    const Eigen::Vector3d up_the_wall = into.cross(level_in_wall).normalized();
    // The plane's turn is fitted together with its turn the other way and its distance.
    Eigen::Matrix2d lever = Eigen::Matrix2d::Zero();
    for (const Eigen::Vector3d& p : points) {
        const Eigen::Vector2d at((p - axes.mean).dot(up_the_wall),
                                 (p - axes.mean).dot(level_in_wall));
        lever += at * at.transpose();
    }
    const double variance = axes.spread[0] / (static_cast<double>(points.size()) - 3.0);
    const double turn_sigma = std::sqrt(variance * lever.inverse()(0, 0));
    result.mount.pitch_sigma_rad =
        turn_sigma / std::max(0.1, std::hypot(unrolled.y(), unrolled.z()));
    if (!(*result.mount.pitch_sigma_rad <= options.largest_sigma_rad)) {
        return not_known_well(*result.mount.pitch_sigma_rad);
    }
    result.axis_in_rig = into;
    result.extent_mm = extent(points, up_the_wall);
    result.rms_mm = std::sqrt(axes.spread[0] / static_cast<double>(points.size()));
    result.points_used = static_cast<int>(points.size());
    result.points_left_out = static_cast<int>(points_in_rig_mm.size() - points.size());
    return result;
}

Movement movement_of(const Points& points_mm) {
    Movement movement;
    if (points_mm.size() < 2 || !all_finite(points_mm)) {
        return movement;
    }
    const Axes axes = axes_of(points_mm);
    const auto count = static_cast<double>(points_mm.size());
    movement.extent_mm = extent(points_mm, axes.directions.col(2));
    movement.off_line_rms_mm = std::sqrt((axes.spread[0] + axes.spread[1]) / count);
    movement.off_plane_rms_mm = std::sqrt(axes.spread[0] / count);
    return movement;
}

double largest_turn_by_bending_rad(double rms_mm, double extent_mm) {
    return extent_mm > 0.0 ? std::atan(std::sqrt(12.0) * rms_mm / extent_mm) : 0.0;
}

Rig with_mount(Rig rig, const Levelling& found, bool from_wall) {
    const Mount before = rig.mount.value_or(Mount{});
    Mount mount = found.mount;
    mount.heading_rad = before.heading_rad;
    mount.rig_in_vehicle_mm = before.rig_in_vehicle_mm;
    if (from_wall) {
        mount.roll_sigma_rad = before.roll_sigma_rad;
    }
    rig.mount = mount;
    return rig;
}

}  // namespace kambara
