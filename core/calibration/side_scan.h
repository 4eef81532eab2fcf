// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/calibration/side_fit.h"

namespace kambara {

/// The rows or columns of pixels that cross one side of a box, whichever cross it more steeply.
/// `u` counts them, `v` runs along them; the side is near v0(u): a line, bent by `bow_px` in its
/// middle.
class SideScan {
  public:
    SideScan(const Image& grey, const LightOfLevel& light, const Quadrilateral& box,
             std::size_t side, double bow_px, const SideFitOptions& options);

    struct Edge {
        std::vector<Eigen::Vector2d> points_px;
        double sigma_px = 0.0;         ///< of each point, by the picture's noise
        double common_sigma_px = 0.0;  ///< of all together, since the light is known only so well
        double dark = 0.0;
        double light = 0.0;
        std::optional<double> blur_variance_px2;  ///< where the step is seen whole
    };
    /// Empty without contrast, or where nothing is clear of the corners.
    std::optional<Edge> edge() const;

    /// How far the points bend out in the middle of the side, in v.
    double bow_of(const std::vector<Eigen::Vector2d>& points_px) const;

  private:
    struct Levels {
        double dark = 0.0;
        double light = 0.0;
        double noise = 0.0;
        double dark_count = 0.0;
        double light_count = 0.0;
    };

    double light_at(int u, int v) const {
        return static_cast<double>(light_[columns_ ? grey_.at(u, v) : grey_.at(v, u)]);
    }
    Eigen::Vector2d pixel(double u, double v) const {
        return columns_ ? Eigen::Vector2d(u, v) : Eigen::Vector2d(v, u);
    }
    double share(double u) const { return (u - a_.x()) / (b_.x() - a_.x()); }
    double v0(double u) const {
        const double t = share(u);
        return a_.y() + t * (b_.y() - a_.y()) + 4.0 * bow_ * t * (1.0 - t);
    }
    bool clear_of_corners(double u) const;
    bool clear_of_side(const Eigen::Vector2d& place, std::size_t other) const;
    std::optional<Levels> levels(const std::vector<int>& scans) const;
    double dark_length(int u, double v_low, double v_high, const Levels& levels,
                       double& step) const;

    const Image& grey_;
    const LightOfLevel& light_;
    const Quadrilateral& box_;
    std::size_t side_;
    bool columns_ = false;   // scans are columns: u is x
    Eigen::Vector2d a_, b_;  // ends as (u, v)
    double bow_ = 0.0;
    double outward_ = 1.0;    // sign of v away from the box
    double across_ = 1.0;     // of one px in v, what lies across the side
    double inside_ = 0.0;     // v from the side to the opposite one
    double outside_ = 0.0;    // v from the side to what follows the gap
    double step_half_ = 0.0;  // half of what the step takes of a scan
    double blur_px_ = 0.0;
    double least_contrast_ = 0.0;
};

}  // namespace kambara
