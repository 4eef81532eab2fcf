// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <random>
#include <vector>

#include "core/camera/nominal_rig.h"

namespace kambara {

/// The nominal rig, and the same with Brown lenses of five and eight terms.
inline std::vector<Rig> rig_samples() {
    Rig brown = nominal_rig();
    brown.left.lens = BrownLens(390, 385, 330, 236, {-0.28, 0.09, 1e-3, -5e-4, -0.01});
    brown.right->lens =
        BrownLens(400, 398, 300, 243, {0.2, 0.05, -1e-3, 8e-4, 0.01, 0.45, 0.15, 0.02});
    return {nominal_rig(), nominal_rig(Medium::water), brown};
}

/// A point of the rig's frame seen by both cameras, and its two pixels.
struct SeenPoint {
    Eigen::Vector3d in_rig_mm;
    Eigen::Vector3d in_left_mm;
    Eigen::Vector2d left_px;
    Eigen::Vector2d right_px;
};

inline SeenPoint seen(const Rig& rig, const Eigen::Vector3d& in_rig_mm) {
    return {in_rig_mm, rig.left.T_camera_from_rig * in_rig_mm, rig.left.project(in_rig_mm).value(),
            rig.right->project(in_rig_mm).value()};
}

/// Points at 0.5 to 8 m.
inline std::vector<SeenPoint> seen_points(const Rig& rig, int count) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> column(0.0, 639.0);
    std::uniform_real_distribution<double> row(0.0, 479.0);
    std::uniform_real_distribution<double> range(500.0, 8000.0);
    std::vector<SeenPoint> points;
    while (static_cast<int>(points.size()) < count) {
        const auto ray = rig.left.unproject({column(random), row(random)});
        const Eigen::Vector3d point = ray.value().at(range(random));
        const auto in_right = rig.right->project(point);
        if (in_right && rig.right->sees(*in_right)) {
            points.push_back(seen(rig, point));
        }
    }
    return points;
}

/// Noise of a picture's pixels, the same every time.
class PixelNoise {
  public:
    explicit PixelNoise(double sigma_px) : normal_(0.0, sigma_px) {}
    Eigen::Vector2d next() {
        const double x = normal_(random_);
        return {x, normal_(random_)};
    }

  private:
    std::mt19937 random_{11};
    std::normal_distribution<double> normal_;
};

}  // namespace kambara
