// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/image/image.h"
#include "core/image/rectangle.h"

namespace kambara {

/// The interpolating cubic B-spline of a piece of a grey picture, mirrored at the piece's border:
/// passes through every pixel, with two continuous derivatives (Unser 1999, "Splines: a perfect fit
/// for signal and image processing").
class CubicSpline {
  public:
    CubicSpline(const Image& grey, const Rectangle& piece);

    /// The value at picture coordinates. Meant for places inside the piece.
    double value(double x, double y) const;
    /// The derivatives along x and y there.
    struct Gradient {
        double x = 0.0;
        double y = 0.0;
    };
    Gradient gradient(double x, double y) const;

  private:
    template <class Weights>
    double sum(double x, double y, const Weights& along, const Weights& across) const;

    Rectangle piece_;
    std::vector<double> coefficients_;
};

/// The piece of a picture whose spline has the picture's own values over a rectangle: what lies
/// more than 8 pixels outside no longer reaches them.
Rectangle spline_piece(const Rectangle& rectangle, const Image& picture);

}  // namespace kambara
