// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <variant>
#include <vector>

#include "core/camera/lens.h"

namespace kambara {

/// Two radial terms about a centre: a pixel at d from it is straight at d (1 + k1 r^2 + k2 r^4),
/// with r = |d| / radius_px. Says nothing of focal lengths.
struct RadialTerms {
    Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();
    double radius_px = 1.0;
    double k1 = 0.0;
    double k2 = 0.0;
};

/// Takes pixels to coordinates, px, in which straight lines are straight, and back.
class Straightener {
  public:
    /// Leaves pixels as they are.
    Straightener() = default;
    explicit Straightener(const RadialTerms& terms) : model_(terms) {}
    explicit Straightener(const Lens& lens) : model_(lens) {}

    /// Empty where the lens has no direction for the pixel, or no pixel for the place.
    std::optional<Eigen::Vector2d> straight(const Eigen::Vector2d& pixel) const;
    std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& straight) const;

  private:
    std::variant<std::monostate, RadialTerms, Lens> model_;
};

/// Places on one straight thing, px, and their deviation across it.
struct StraightPoints {
    std::vector<Eigen::Vector2d> points_px;
    double sigma_px = 0.02;
};

/// The radial terms that make all lines straightest (plumb lines, D. Brown 1971), held near `start`
/// where the lines do not tell: k1 and k2 within 0.1, the centre within a thirtieth of the circle's
/// radius. Least squares by Gauss-Newton, damped; `start` itself where that goes astray.
RadialTerms plumb_line_terms(const std::vector<StraightPoints>& lines, const RadialTerms& start);

}  // namespace kambara
