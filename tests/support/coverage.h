// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

namespace kambara::testing_support {

using Polygon = std::vector<Eigen::Vector2d>;

/// A picture of numbers, in which polygons are drawn by the exact area that they cover of each
/// pixel. Pixel (0, 0) reaches from -0.5 to 0.5.
class CoverageCanvas {
  public:
    CoverageCanvas(int width, int height, double level);

    /// Polygons that do not overlap, though they may share sides: what they leave of a pixel stays.
    struct Piece {
        Polygon outline;
        double level = 0.0;
    };
    void paint(const std::vector<Piece>& pieces);
    void paint(const Polygon& outline, double level) { paint({{outline, level}}); }

    int width() const { return width_; }
    int height() const { return height_; }
    std::vector<double>& pixels() { return pixels_; }
    double at(int x, int y) const { return pixels_[static_cast<std::size_t>(y * width_ + x)]; }

    /// A Gaussian blur of this deviation.
    void blur(double sigma_px);

  private:
    void add_side(Eigen::Vector2d a, Eigen::Vector2d b);
    void add_in_row(int y, double x0, double x1, double dy);

    int width_;
    int height_;
    std::vector<double> pixels_;
    std::vector<double> steps_;  // of a row's coverage from pixel to pixel, while painting
};

}  // namespace kambara::testing_support
