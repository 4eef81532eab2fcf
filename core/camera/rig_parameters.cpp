// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/rig_parameters.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

constexpr int pose_parameters = 6;
constexpr double step_share = 1e-6;        // of a parameter, or of one where it is smaller
constexpr double rounding_of_unit = 1e-7;  // of an eigenvalue of the correlations

using LensNumbers = std::array<double, 12>;

LensNumbers numbers_of(const Lens& lens) {
    if (const auto* brown = std::get_if<BrownLens>(&lens)) {
        return brown->parameters();
    }
    const auto& tsai = std::get<TsaiLens>(lens);
    return {tsai.f_mm, tsai.kappa1_per_mm2, tsai.cx_px, tsai.cy_px, tsai.sx};
}

// Of a direction that is known to be within the lens's range.
Eigen::Vector2d pixel_of(const Lens& lens, const LensNumbers& numbers, double x, double y) {
    Eigen::Vector2d pixel;
    if (const auto* tsai = std::get_if<TsaiLens>(&lens)) {
        tsai_pixel(numbers.data(), tsai->sensor.dx_prime_mm(), tsai->sensor.dy_mm, x, y,
                   pixel.data());
    } else {
        brown_pixel(numbers.data(), x, y, pixel.data());
    }
    return pixel;
}

int lens_parameters(const Lens& lens) {
    return static_cast<int>(lens_parameter_names(lens).size());
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
    return m;
}

}  // namespace

Eigen::Matrix2Xd pixel_by_lens_parameters(const Lens& lens,
                                          const Eigen::Vector3d& point_in_camera_mm) {
    const double x = point_in_camera_mm.x() / point_in_camera_mm.z();
    const double y = point_in_camera_mm.y() / point_in_camera_mm.z();
    const LensNumbers numbers = numbers_of(lens);
    Eigen::Matrix2Xd result(2, lens_parameters(lens));
    for (int i = 0; i < result.cols(); ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double step = step_share * std::max(1.0, std::abs(numbers[k]));
        LensNumbers low = numbers;
        LensNumbers high = numbers;
        low[k] -= step;
        high[k] += step;
        result.col(i) =
            (pixel_of(lens, high, x, y) - pixel_of(lens, low, x, y)) / (high[k] - low[k]);
    }
    return result;
}

Lens with_lens_moved(const Lens& lens, const Eigen::VectorXd& by) {
    if (const auto* brown = std::get_if<BrownLens>(&lens)) {
        std::vector<double> terms = brown->distortion();
        for (std::size_t i = 0; i < terms.size(); ++i) {
            terms[i] += by[4 + static_cast<Eigen::Index>(i)];
        }
        return BrownLens(brown->fx_px() + by[0], brown->fy_px() + by[1], brown->cx_px() + by[2],
                         brown->cy_px() + by[3], terms);
    }
    TsaiLens tsai = std::get<TsaiLens>(lens);
    tsai.f_mm += by[0];
    tsai.kappa1_per_mm2 += by[1];
    tsai.cx_px += by[2];
    tsai.cy_px += by[3];
    tsai.sx += by[4];
    return tsai;
}

std::vector<std::string> lens_parameter_names(const Lens& lens) {
    const auto* brown = std::get_if<BrownLens>(&lens);
    if (brown == nullptr) {
        return {"f_mm", "kappa1_per_mm2", "cx_px", "cy_px", "sx"};
    }
    std::vector<std::string> names{"fx_px", "fy_px", "cx_px", "cy_px", "k1",
                                   "k2",    "p1",    "p2",    "k3"};
    if (brown->terms() == 8) {
        names.insert(names.end(), {"k4", "k5", "k6"});
    }
    return names;
}

std::vector<std::string> rig_parameter_names(const Rig& rig) {
    std::vector<std::string> names;
    if (!rig.right) {
        return names;
    }
    for (const std::string& name : lens_parameter_names(rig.left.lens)) {
        names.push_back("left." + name);
    }
    for (const std::string& name : lens_parameter_names(rig.right->lens)) {
        names.push_back("right." + name);
    }
    for (const char* name :
         {"turn_x_rad", "turn_y_rad", "turn_z_rad", "shift_x_mm", "shift_y_mm", "shift_z_mm"}) {
        names.push_back(std::string("right_from_left.") + name);
    }
    return names;
}

std::optional<Eigen::Matrix<double, 4, Eigen::Dynamic>> pixels_by_parameters(
    const Rig& rig, const Eigen::Vector3d& point_in_left_mm) {
    if (!rig.right) {
        return std::nullopt;
    }
    const RigidTransform T = T_right_from_left(rig);
    const Eigen::Vector3d turned = T.R * point_in_left_mm;
    const Eigen::Vector3d in_right = turned + T.t_mm;
    Eigen::Matrix<double, 2, 3> right_by_point;
    if (!project(rig.left.lens, point_in_left_mm) ||
        !project(rig.right->lens, in_right, right_by_point)) {
        return std::nullopt;
    }
    const int left = lens_parameters(rig.left.lens);
    const int right = lens_parameters(rig.right->lens);
    Eigen::Matrix<double, 4, Eigen::Dynamic> result =
        Eigen::Matrix<double, 4, Eigen::Dynamic>::Zero(4, left + right + pose_parameters);
    result.block(0, 0, 2, left) = pixel_by_lens_parameters(rig.left.lens, point_in_left_mm);
    result.block(2, left, 2, right) = pixel_by_lens_parameters(rig.right->lens, in_right);
    result.block<2, 3>(2, left + right) = -right_by_point * cross_matrix(turned);
    result.block<2, 3>(2, left + right + 3) = right_by_point;
    return result;
}

Rig with_parameters_moved(const Rig& rig, const Eigen::VectorXd& by) {
    const int left = lens_parameters(rig.left.lens);
    const int right = lens_parameters(rig.right.value().lens);
    const RigidTransform T = T_right_from_left(rig);
    const Eigen::Vector3d turn = by.segment<3>(left + right);
    const double angle = turn.norm();
    const Eigen::Matrix3d turned = angle > 0.0
                                       ? Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix()
                                       : Eigen::Matrix3d::Identity();
    Rig result = rig;
    result.left.lens = with_lens_moved(rig.left.lens, by.head(left));
    result.right->lens = with_lens_moved(rig.right->lens, by.segment(left, right));
    result.right->T_camera_from_rig =
        RigidTransform{turned * T.R, T.t_mm + by.tail<3>()} * rig.left.T_camera_from_rig;
    return result;
}

std::string covariance_fault(const Rig& rig, const Eigen::MatrixXd& covariance) {
    return covariance_fault(static_cast<Eigen::Index>(rig_parameter_names(rig).size()), covariance);
}

std::string covariance_fault(Eigen::Index n, const Eigen::MatrixXd& covariance) {
    if (covariance.rows() != n || covariance.cols() != n) {
        return "does not have a row for each parameter";
    }
    if (!covariance.allFinite() || (n > 0 && covariance.diagonal().minCoeff() < 0.0)) {
        return "holds a variance that is negative or not finite";
    }
    const Eigen::VectorXd scale = covariance.diagonal().unaryExpr(
        [](double variance) { return variance > 0.0 ? 1.0 / std::sqrt(variance) : 0.0; });
    const Eigen::MatrixXd correlations = scale.asDiagonal() * covariance * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(correlations, Eigen::EigenvaluesOnly);
    if (n > 0 && (axes.info() != Eigen::Success ||
                  !(axes.eigenvalues().minCoeff() > -rounding_of_unit * static_cast<double>(n)))) {
        return "holds correlations that contradict each other";
    }
    return {};
}

}  // namespace kambara
