// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/lens.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/angles.h"
#include "core/camera/brown.h"
#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

struct Distorted {
    Eigen::Vector2d pixel;
    Eigen::Matrix2d by_direction;  // derivative by the undistorted direction (x, y)
};

std::optional<Distorted> distorted(const TsaiLens& lens, const Eigen::Vector2d& direction,
                                   bool with_derivative) {
    const Eigen::Vector2d u = lens.f_mm * direction;
    const double kappa = lens.kappa1_per_mm2;
    const double w = tsai_squared_distorted_radius(kappa, u.squaredNorm());
    if (!std::isfinite(w)) {
        return std::nullopt;
    }
    const double shrink = 1.0 / (1.0 + kappa * w);
    const Eigen::Vector2d scale(lens.sx / lens.sensor.dx_prime_mm(), 1.0 / lens.sensor.dy_mm);
    Distorted result{scale.cwiseProduct(shrink * u) + Eigen::Vector2d(lens.cx_px, lens.cy_px), {}};
    if (with_derivative) {
        const double w_by_q = 1.0 / ((1.0 + kappa * w) * (1.0 + 3.0 * kappa * w));
        const double shrink_by_q = -kappa * shrink * shrink * w_by_q;
        const Eigen::Matrix2d by_u =
            shrink * Eigen::Matrix2d::Identity() + 2.0 * shrink_by_q * u * u.transpose();
        result.by_direction = scale.asDiagonal() * by_u * lens.f_mm;
    }
    return result;
}

std::optional<Distorted> distorted(const BrownLens& lens, const Eigen::Vector2d& direction,
                                   bool with_derivative) {
    if (direction.norm() > lens.max_radius()) {
        return std::nullopt;
    }
    Distorted result;
    brown_pixel(lens.parameters().data(), direction.x(), direction.y(), result.pixel.data());
    if (with_derivative) {
        const Eigen::Vector2d f(lens.fx_px(), lens.fy_px());
        result.by_direction = f.asDiagonal() * brown_jacobian(lens.parameters(), direction);
    }
    return result;
}

std::optional<Distorted> projected(const Lens& lens, const Eigen::Vector3d& p,
                                   bool with_derivative) {
    if (!(p.z() > 0.0) || !p.allFinite()) {
        return std::nullopt;
    }
    const Eigen::Vector2d direction = p.head<2>() / p.z();
    return std::visit(
        [&](const auto& model) { return distorted(model, direction, with_derivative); }, lens);
}

std::optional<Eigen::Vector2d> direction_of(const TsaiLens& lens, const Eigen::Vector2d& pixel) {
    const double x_d = (pixel.x() - lens.cx_px) * lens.sensor.dx_prime_mm() / lens.sx;
    const double y_d = (pixel.y() - lens.cy_px) * lens.sensor.dy_mm;
    const double w = x_d * x_d + y_d * y_d;
    // Beyond the turning point of a pincushion lens no ray arrives.
    if (!std::isfinite(w) || 1.0 + 3.0 * lens.kappa1_per_mm2 * w < 0.0) {
        return std::nullopt;
    }
    const double stretch = (1.0 + lens.kappa1_per_mm2 * w) / lens.f_mm;
    return Eigen::Vector2d(x_d * stretch, y_d * stretch);
}

std::optional<Eigen::Vector2d> direction_of(const BrownLens& lens, const Eigen::Vector2d& pixel) {
    const Eigen::Vector2d at((pixel.x() - lens.cx_px()) / lens.fx_px(),
                             (pixel.y() - lens.cy_px()) / lens.fy_px());
    return brown_undistort(lens.parameters(), lens.max_radius(), at);
}

TsaiLens scaled_model(TsaiLens lens, double a, double b) {
    lens.cx_px = a * (lens.cx_px + 0.5) - 0.5;
    lens.cy_px = b * (lens.cy_px + 0.5) - 0.5;
    lens.sensor.nfx *= a;
    lens.sensor.dy_mm /= b;
    return lens;
}

BrownLens scaled_model(const BrownLens& lens, double a, double b) {
    return {a * lens.fx_px(), b * lens.fy_px(), a * (lens.cx_px() + 0.5) - 0.5,
            b * (lens.cy_px() + 0.5) - 0.5, lens.distortion()};
}

PinholeParameters pinhole_of(const TsaiLens& lens) {
    return {lens.f_mm * lens.sx / lens.sensor.dx_prime_mm(), lens.f_mm / lens.sensor.dy_mm,
            lens.cx_px, lens.cy_px};
}

PinholeParameters pinhole_of(const BrownLens& lens) {
    return {lens.fx_px(), lens.fy_px(), lens.cx_px(), lens.cy_px()};
}

}  // namespace

BrownLens::BrownLens(double fx, double fy, double cx, double cy,
                     const std::vector<double>& distortion) {
    if (distortion.size() > 8) {
        throw std::invalid_argument("kambara::BrownLens: more than eight distortion terms");
    }
    parameters_ = {fx, fy, cx, cy};
    std::copy(distortion.begin(), distortion.end(), parameters_.begin() + 4);
    terms_ = distortion.size() > 5 ? 8 : 5;
    max_radius_ = brown_max_radius(parameters_);
}

std::vector<double> BrownLens::distortion() const {
    return {parameters_.begin() + 4, parameters_.begin() + 4 + terms_};
}

std::optional<Eigen::Vector2d> project(const Lens& lens, const Eigen::Vector3d& point) {
    const auto result = projected(lens, point, false);
    return result ? std::optional(result->pixel) : std::nullopt;
}

std::optional<Eigen::Vector2d> project(const Lens& lens, const Eigen::Vector3d& point,
                                       Eigen::Matrix<double, 2, 3>& pixel_by_point) {
    const auto result = projected(lens, point, true);
    if (!result) {
        return std::nullopt;
    }
    Eigen::Matrix<double, 2, 3> direction_by_point;
    const double z = point.z();
    direction_by_point << 1.0 / z, 0.0, -point.x() / (z * z), 0.0, 1.0 / z, -point.y() / (z * z);
    pixel_by_point = result->by_direction * direction_by_point;
    return result->pixel;
}

std::optional<Ray> unproject(const Lens& lens, const Eigen::Vector2d& pixel) {
    const auto direction =
        std::visit([&](const auto& model) { return direction_of(model, pixel); }, lens);
    if (!direction) {
        return std::nullopt;
    }
    return Ray{Eigen::Vector3d::Zero(),
               Eigen::Vector3d(direction->x(), direction->y(), 1.0).normalized()};
}

Lens scaled(const Lens& lens, double factor_x, double factor_y) {
    return std::visit(
        [&](const auto& model) { return Lens(scaled_model(model, factor_x, factor_y)); }, lens);
}

PinholeParameters pinhole_parameters(const Lens& lens) {
    return std::visit([](const auto& model) { return pinhole_of(model); }, lens);
}

std::string implausibility(const Lens& lens, int width_px, int height_px) {
    const auto p = pinhole_parameters(lens);
    const double size = std::max(width_px, height_px);
    if (!(std::isfinite(p.fx_px) && std::isfinite(p.fy_px) && std::isfinite(p.cx_px) &&
          std::isfinite(p.cy_px))) {
        return "a lens parameter is not a finite number";
    }
    if (p.fx_px < 0.05 * size || p.fy_px < 0.05 * size || p.fx_px > 200.0 * size ||
        p.fy_px > 200.0 * size) {
        return "the focal length is " + std::to_string(p.fx_px) + " x " + std::to_string(p.fy_px) +
               " px for pictures of " + std::to_string(width_px) + " x " +
               std::to_string(height_px) + " px";
    }
    if (p.fx_px > 3.0 * p.fy_px || p.fy_px > 3.0 * p.fx_px) {
        return "the focal lengths across and down differ more than threefold";
    }
    if (std::abs(p.cx_px - 0.5 * width_px) > 2.0 * width_px ||
        std::abs(p.cy_px - 0.5 * height_px) > 2.0 * height_px) {
        return "the principal point is far outside the picture";
    }
    const Eigen::Vector2d corners[] = {{0.25 * width_px, 0.25 * height_px},
                                       {0.75 * width_px, 0.25 * height_px},
                                       {0.25 * width_px, 0.75 * height_px},
                                       {0.75 * width_px, 0.75 * height_px}};
    for (const auto& corner : corners) {
        const auto ray = unproject(lens, corner);
        if (!ray || ray->direction.z() < std::cos(rad_from_deg(85.0))) {
            return "the distortion is so strong that not even the middle of the picture can be "
                   "undistorted";
        }
    }
    return {};
}

}  // namespace kambara
