// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/calibration/side_fit.h"

namespace kambara {

/// The share of each pixel that a set of boxes covers, the picture's blur included.
class BoxCoverage {
  public:
    BoxCoverage(int width, int height, double blur_px);

    /// A box's own share about it, and how it follows the eight coordinates of the corners. Rows of
    /// the matrices are the region's pixels, row by row; without `by_corners` where only shares
    /// were asked for.
    struct Region {
        int x0 = 0;
        int y0 = 0;
        int width = 0;
        int height = 0;
        Eigen::VectorXd share;
        Eigen::Matrix<double, Eigen::Dynamic, 8> by_corners;
    };
    Region region_of(const Quadrilateral& box, double around_px, const Straightener& straightener,
                     bool shares_only = false) const;

    /// Puts a box into the sum of all, or takes it out with a sign of -1.
    void add(const Quadrilateral& box, const Straightener& straightener, double sign);
    double at(int x, int y) const { return sum_[static_cast<std::size_t>(y * width_ + x)]; }
    int width() const { return width_; }
    int height() const { return height_; }

  private:
    void blur(Region& region) const;

    int width_;
    int height_;
    std::vector<double> kernel_;
    std::vector<double> sum_;
};

/// Measures a box by the light of every pixel about it: corners, and light on either side, such
/// that the share that the box covers of each pixel explains the picture (Gauss-Newton). For boxes
/// too small for their sides to have rows of their own; `others` holds the boxes beside it, whose
/// light it may share pixels with. Empty where it doesn't
/// come to rest nearby.
std::optional<FittedBox> fit_area(const Image& grey, const LightOfLevel& light,
                                  const Quadrilateral& start, const SideFitOptions& options,
                                  const BoxCoverage& others, const Straightener& straightener = {});

}  // namespace kambara
