// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target.h"

#include <algorithm>
#include <cmath>

#include "core/base/angles.h"

namespace kambara {
namespace {

std::vector<Eigen::Vector3d> grid(int across, int down, double pitch_mm) {
    std::vector<Eigen::Vector3d> corners;
    for (int row = 0; row < down; ++row) {
        for (int column = 0; column < across; ++column) {
            corners.emplace_back(column * pitch_mm, row * pitch_mm, 0.0);
        }
    }
    return corners;
}

std::vector<Eigen::Vector3d> drawn(const ChessboardTarget& target) {
    return grid(target.corners_across, target.corners_down, target.square_mm);
}

std::vector<Eigen::Vector3d> drawn(const CharucoTarget& target) {
    return grid(target.squares_across - 1, target.squares_down - 1, target.square_mm);
}

std::vector<Eigen::Vector3d> drawn(const BoxTarget& target) {
    std::vector<Eigen::Vector3d> corners;
    const auto frames = plane_frames(target);
    for (int row = 0; row < target.rows; ++row) {
        for (std::size_t plane = 0; plane < frames.size(); ++plane) {
            const BoxPlaneFrame& frame = frames[plane];
            for (int column = 0; column < target.planes[plane].columns; ++column) {
                const Eigen::Vector3d from = frame.origin_mm +
                                             column * target.pitch_across_mm * frame.across +
                                             row * target.pitch_down_mm * frame.down;
                const Eigen::Vector3d across = target.box_width_mm * frame.across;
                const Eigen::Vector3d down = target.box_height_mm * frame.down;
                corners.insert(corners.end(),
                               {from, from + across, from + across + down, from + down});
            }
        }
    }
    return corners;
}

std::vector<Eigen::Vector3d> drawn(const PointTarget& target) {
    return target.points_mm;
}

}  // namespace

BoxTarget two_plane_24() {
    BoxTarget target;
    target.planes = {{3, 180.0, 0.0, 25.0}, {3, 90.0, 25.0, 0.0}};
    return target;
}

std::vector<BoxPlaneFrame> plane_frames(const BoxTarget& target) {
    std::vector<BoxPlaneFrame> frames;
    const Eigen::Vector3d down = Eigen::Vector3d::UnitY();
    Eigen::Vector3d edge = Eigen::Vector3d::Zero();
    double turn_deg = 0.0;  // of the plane's own across, from x towards the viewer
    for (std::size_t i = 0; i < target.planes.size(); ++i) {
        const BoxPlane& plane = target.planes[i];
        turn_deg += i == 0 ? 0.0 : 180.0 - plane.angle_deg;
        // Exact at right angles, where the cosine of a rounded angle is not quite zero.
        const bool right = std::fmod(turn_deg, 90.0) == 0.0;
        const double cosine = std::cos(rad_from_deg(turn_deg));
        const double sine = std::sin(rad_from_deg(turn_deg));
        const Eigen::Vector3d across(right ? std::round(cosine) : cosine, 0.0,
                                     right ? -std::round(sine) : -sine);
        const Eigen::Vector3d origin = edge + (i == 0 ? 0.0 : plane.gap_before_mm) * across;
        frames.push_back({origin, across, down});
        const double width = (plane.columns - 1) * target.pitch_across_mm + target.box_width_mm;
        edge = origin + (width + plane.gap_after_mm) * across;
    }
    return frames;
}

const TargetAccuracy& accuracy_of(const Target& target) {
    return std::visit([](const auto& kind) -> const TargetAccuracy& { return kind.accuracy; },
                      target);
}

TargetAccuracy& accuracy_of(Target& target) {
    return std::visit([](auto& kind) -> TargetAccuracy& { return kind.accuracy; }, target);
}

std::vector<Eigen::Vector3d> drawn_corners_mm(const Target& target) {
    return std::visit([](const auto& kind) { return drawn(kind); }, target);
}

std::vector<Eigen::Vector3d> corners_in_target_mm(const Target& target) {
    auto corners = drawn_corners_mm(target);
    for (const MeasuredCorner& corner : accuracy_of(target).measured) {
        corners.at(static_cast<std::size_t>(corner.id)) = corner.at_mm;
    }
    return corners;
}

std::vector<double> corner_sigmas_mm(const Target& target) {
    const TargetAccuracy& accuracy = accuracy_of(target);
    std::vector<double> sigmas(drawn_corners_mm(target).size(), accuracy.sigma_mm);
    for (const MeasuredCorner& corner : accuracy.measured) {
        sigmas.at(static_cast<std::size_t>(corner.id)) = corner.sigma_mm;
    }
    return sigmas;
}

}  // namespace kambara
