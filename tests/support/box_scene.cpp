// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/box_scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace kambara::testing_support {
namespace {

constexpr int pieces_a_side = 24;  // a lens bends sides
constexpr double second_sheet = 0.9;

Eigen::Vector2d pixel_of(const BoxScene& scene, const Eigen::Vector3d& point_in_target_mm) {
    return project(scene.lens, scene.camera_from_target * point_in_target_mm).value();
}

Polygon outline_of(const BoxScene& scene, const TargetPatch& patch) {
    const Eigen::Vector3d corner[] = {patch.origin_mm, patch.origin_mm + patch.across_mm,
                                      patch.origin_mm + patch.across_mm + patch.down_mm,
                                      patch.origin_mm + patch.down_mm};
    Polygon outline;
    if (patch.round) {
        const Eigen::Vector3d middle = patch.origin_mm + 0.5 * (patch.across_mm + patch.down_mm);
        for (int i = 0; i < 48; ++i) {
            const double turn = 2.0 * std::numbers::pi * i / 48;
            outline.push_back(pixel_of(scene, middle + 0.5 * (std::cos(turn) * patch.across_mm +
                                                              std::sin(turn) * patch.down_mm)));
        }
        return outline;
    }
    for (int side = 0; side < 4; ++side) {
        const Eigen::Vector3d step = (corner[(side + 1) % 4] - corner[side]) / pieces_a_side;
        for (int i = 0; i < pieces_a_side; ++i) {
            outline.push_back(pixel_of(scene, corner[side] + i * step));
        }
    }
    return outline;
}

double camera_level(double light, double gamma) {
    return gamma == 1.0 ? light : 255.0 * std::pow(std::max(light, 0.0) / 255.0, 1.0 / gamma);
}

}  // namespace

Image rendered(const BoxScene& scene) {
    CoverageCanvas canvas(scene.width_px, scene.height_px, scene.background);
    canvas.paint(scene.behind);
    std::vector<CoverageCanvas::Piece> sheets;
    std::vector<CoverageCanvas::Piece> boxes;
    for (const TargetPatch& patch : patches_of(scene.target)) {
        if (patch.sheet) {
            sheets.push_back(
                {outline_of(scene, patch), scene.paper * (sheets.empty() ? 1.0 : second_sheet)});
        } else if (!scene.hidden.contains(static_cast<int>(boxes.size()))) {
            boxes.push_back({outline_of(scene, patch), scene.ink});
        } else {
            boxes.push_back({{}, 0.0});
        }
    }
    canvas.paint(sheets);
    canvas.paint(boxes);
    for (const auto& piece : scene.over_it) {
        canvas.paint(piece.outline, piece.level);
    }
    if (scene.blur_px > 0.0) {
        canvas.blur(scene.blur_px);
    }
    std::mt19937 random(scene.seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    Image picture(scene.width_px, scene.height_px);
    for (int y = 0; y < scene.height_px; ++y) {
        for (int x = 0; x < scene.width_px; ++x) {
            const double level =
                camera_level(canvas.at(x, y), scene.gamma) + scene.noise * noise(random);
            picture.at(x, y) =
                static_cast<std::uint8_t>(std::lround(std::clamp(level, 0.0, 255.0)));
        }
    }
    return picture;
}

std::vector<Eigen::Vector2d> true_corners_px(const BoxScene& scene) {
    std::vector<Eigen::Vector2d> corners;
    for (const Eigen::Vector3d& corner : corners_in_target_mm(scene.target)) {
        corners.push_back(pixel_of(scene, corner));
    }
    return corners;
}

RigidTransform target_pose(const Target& target, const Eigen::Vector3d& middle_in_camera_mm,
                           double yaw_rad, double tilt_rad, double roll_rad) {
    const auto corners = corners_in_target_mm(target);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& corner : corners) {
        middle += corner / static_cast<double>(corners.size());
    }
    const double bisector = std::atan(1.0);
    RigidTransform pose;
    pose.R = Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
             rotation_about_x(tilt_rad) * rotation_about_y(yaw_rad - bisector);
    pose.t_mm = middle_in_camera_mm - pose.R * middle;
    return pose;
}

std::vector<CoverageCanvas::Piece> decoys(const BoxScene& scene, int count, std::uint32_t seed) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    struct Disc {
        Eigen::Vector2d centre;
        double radius;
    };
    std::vector<Disc> taken;
    for (const TargetPatch& patch : patches_of(scene.target)) {
        const Polygon outline = outline_of(scene, patch);
        const Eigen::Vector2d middle = 0.5 * (outline[0] + outline[outline.size() / 2]);
        taken.push_back({middle, patch.sheet ? 0.0 : (outline[0] - middle).norm()});
        for (std::size_t i = 0; patch.sheet && i < outline.size(); i += 2) {
            taken.push_back({outline[i], 3.0});
        }
    }
    std::vector<CoverageCanvas::Piece> pieces;
    for (int attempt = 0; attempt < 100 * count && static_cast<int>(pieces.size()) < count;
         ++attempt) {
        const Disc disc{{uniform(0, scene.width_px), uniform(0, scene.height_px)},
                        uniform(6.0, 25.0)};
        const auto clashes = [&](const Disc& other) {
            return (other.centre - disc.centre).norm() < other.radius + disc.radius + 2.0;
        };
        if (std::any_of(taken.begin(), taken.end(), clashes)) {
            continue;
        }
        taken.push_back(disc);
        CoverageCanvas::Piece piece{{}, uniform(5.0, scene.background - 40.0)};
        const double start = uniform(0.0, 6.28);
        const double spread = uniform(0.5, 1.07);
        for (const double angle : {0.0, 2.0 * spread, 3.1416, 3.1416 + 2.0 * spread}) {
            const double bent = start + angle + uniform(-0.1, 0.1);
            piece.outline.push_back(disc.centre +
                                    0.5 * disc.radius * uniform(1.7, 2.0) *
                                        Eigen::Vector2d(std::cos(bent), std::sin(bent)));
        }
        pieces.push_back(piece);
    }
    return pieces;
}

double narrowest_box_px(const std::vector<Eigen::Vector2d>& corners_px) {
    double narrowest = 1e9;
    for (std::size_t i = 0; i + 3 < corners_px.size(); i += 4) {
        narrowest = std::min({narrowest, (corners_px[i + 1] - corners_px[i]).norm(),
                              (corners_px[i + 3] - corners_px[i + 2]).norm()});
    }
    return narrowest;
}

}  // namespace kambara::testing_support
