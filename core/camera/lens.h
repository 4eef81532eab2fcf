// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/ray.h"

namespace kambara {

/// The sensor behind a Tsai lens: pixel pitch on the chip, and how many of its columns become how
/// many columns of the picture. d'_x = d_x N_cx / N_fx.
struct Sensor {
    double dx_mm = 0.0;
    double dy_mm = 0.0;
    double ncx = 1.0;
    double nfx = 1.0;

    double dx_prime_mm() const { return dx_mm * ncx / nfx; }
    bool operator==(const Sensor&) const = default;
};

/// Tsai's lens: one radial term whose argument is the distorted point, so that undistorting is
/// closed form and distorting a cubic, solved to machine precision (geometry: equations 10-24).
struct TsaiLens {
    double f_mm = 0.0;
    double kappa1_per_mm2 = 0.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double sx = 1.0;
    Sensor sensor;

    bool operator==(const TsaiLens&) const = default;
};

/// Brown and Conrady's lens in OpenCV's parameters: focal lengths and principal point in px, and
/// 5 (k1 k2 p1 p2 k3) or 8 (then k4 k5 k6, dividing) distortion terms.
class BrownLens {
  public:
    BrownLens() : BrownLens(1.0, 1.0, 0.0, 0.0) {}
    BrownLens(double fx_px, double fy_px, double cx_px, double cy_px,
              const std::vector<double>& distortion = {});

    double fx_px() const { return parameters_[0]; }
    double fy_px() const { return parameters_[1]; }
    double cx_px() const { return parameters_[2]; }
    double cy_px() const { return parameters_[3]; }
    /// 5 or 8: how many terms count; the rest are zero.
    int terms() const { return terms_; }
    std::vector<double> distortion() const;
    /// fx fy cx cy and eight terms, as brown_pixel takes them.
    const std::array<double, 12>& parameters() const { return parameters_; }
    /// The polynomial turns back beyond this radius of the undistorted direction (x, y, 1): what
    /// lies outside would land on pixels that belong to the inside, and is refused.
    double max_radius() const { return max_radius_; }

    bool operator==(const BrownLens& other) const {
        return parameters_ == other.parameters_ && terms_ == other.terms_;
    }

  private:
    std::array<double, 12> parameters_{};
    int terms_ = 5;
    double max_radius_ = 0.0;
};

/// The closed set of lens models. Camera frame: x right, y down, z forward; pixels: (0, 0) is the
/// centre of the first pixel.
using Lens = std::variant<TsaiLens, BrownLens>;

/// The pixel of a point in the camera's frame, mm. Empty where the point projects nowhere: at or
/// behind the camera's plane, or outside the range in which the distortion is invertible.
std::optional<Eigen::Vector2d> project(const Lens& lens, const Eigen::Vector3d& point_in_camera_mm);

/// As above, with the derivative of the pixel by the point, px/mm.
std::optional<Eigen::Vector2d> project(const Lens& lens, const Eigen::Vector3d& point_in_camera_mm,
                                       Eigen::Matrix<double, 2, 3>& pixel_by_point);

/// The ray, in the camera's frame, along which a pixel looks. Empty where no direction projects to
/// the pixel. project() of any point of the ray gives the pixel again to 1e-9 px.
std::optional<Ray> unproject(const Lens& lens, const Eigen::Vector2d& pixel);

/// The lens for pictures resized by the factors: a pixel coordinate X becomes a (X + 0.5) - 0.5.
Lens scaled(const Lens& lens, double factor_x, double factor_y);

/// Focal lengths in px near the axis, and the principal point: what all models share.
struct PinholeParameters {
    double fx_px, fy_px, cx_px, cy_px;
};
PinholeParameters pinhole_parameters(const Lens& lens);

/// Why a lens cannot be that of a real camera with such pictures; empty when it can be.
std::string implausibility(const Lens& lens, int width_px, int height_px);

}  // namespace kambara
