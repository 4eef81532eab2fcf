// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/tsai_calibrator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/calibration/point_checks.h"
#include "core/calibration/student_t.h"

namespace kambara {
namespace {

// A fit is better than another beyond doubt where its residuals are so many times smaller.
constexpr double clearly = 3.0;
constexpr double least_share_of_inliers = 0.6;
constexpr double worst_noise_of_extent = 0.02;

std::vector<SeenPoint> mirrored(std::vector<SeenPoint> points) {
    for (SeenPoint& point : points) {
        point.in_world_mm.z() = -point.in_world_mm.z();
    }
    return points;
}

Error left_handed() {
    return {
        "The points come out mirrored: the world frame is left-handed, or the picture is "
        "mirrored.",
        "Negate one world axis, so that z = x cross y; count pixel rows downwards and columns "
        "to the right."};
}

Error no_camera(const std::string& detail) {
    return {"The points fit no camera" + detail + ".",
            "Check that each point has its own pixel, the order x y z X Y, the sensor's numbers "
            "and the centre; the points must not all look alike from the camera (a plane seen "
            "square on, or one line of pixels)."};
}

// The chi-squared below which 5 % lie (Wilson and Hilferty: within 1 % from 5 degrees on).
double lower_chi_squared(double degrees) {
    const double a = 2.0 / (9.0 * degrees);
    return degrees * std::pow(std::max(0.05, 1.0 - a - 1.6449 * std::sqrt(a)), 3.0);
}

// Which points agree on a camera, and that camera; or why none is found.
Result<RobustFit> agreeing(const std::vector<SeenPoint>& points, const TsaiFitOptions& options) {
    auto found = robust_fit(points, options);
    if (!options.coplanar && (!found || found->suspicious)) {
        const auto other = robust_fit(mirrored(points), options);
        if (other && (!found || clearly * other->median_px < found->median_px)) {
            return left_handed();
        }
    }
    if (!found) {
        return no_camera("");
    }
    const auto inliers = static_cast<double>(found->inliers.size());
    if (inliers < least_share_of_inliers * static_cast<double>(points.size()) || inliers < 7.0) {
        return no_camera(": only " + std::to_string(found->inliers.size()) + " of " +
                         std::to_string(points.size()) + " agree");
    }
    return std::move(*found);
}

void add_errors(TsaiReport& report, const std::vector<SeenPoint>& used) {
    report.points_used = static_cast<int>(used.size());
    for (const Eigen::Vector2d& residual : residuals_px(report.view, used)) {
        report.sse_px2 += residual.squaredNorm();
        report.mean_error_px += residual.norm() / static_cast<double>(used.size());
        report.max_error_px = std::max(report.max_error_px, residual.norm());
    }
}

void add_reason(TsaiReport& report, double limit_percent) {
    char text[240];
    std::snprintf(text, sizeof text,
                  "Poorly determined: these points tell the focal length to %.2f %% (1 sigma) at "
                  "best, and with it the distance; above %.2g %% it is not to be relied on.",
                  report.f_bound_percent, limit_percent);
    report.reasons.emplace_back(text);
}

// Covariance, intervals and the verdict. False where the points leave a parameter undetermined.
bool add_uncertainty(TsaiReport& report, const std::vector<SeenPoint>& used,
                     const TsaiFitOptions& fit_options, const TsaiOptions& options) {
    const TsaiMask told = told_parameters(fit_options);
    const auto jacobian = tsai_jacobian(report.view, used);
    const auto unit = jacobian ? unit_covariance(*jacobian, told) : std::nullopt;
    const auto parameters = static_cast<int>(std::count(told.begin(), told.end(), true));
    report.degrees_of_freedom = 2 * report.points_used - parameters;
    if (!unit || report.degrees_of_freedom < 1) {
        return false;
    }
    const double variance = report.sse_px2 / report.degrees_of_freedom;
    report.noise_px = std::sqrt(variance);
    const TsaiMatrix covariance = variance * *unit;
    report.f_bound_percent =
        100.0 * std::sqrt(covariance(tsai::f, tsai::f)) / report.view.lens.f_mm;
    if (options.method == TsaiMethod::full) {
        report.covariance = covariance;
        report.sigma = covariance.diagonal().cwiseSqrt();
        report.interval_95 = student_t_quantile(0.975, report.degrees_of_freedom) * report.sigma;
    }
    const double degrees = report.degrees_of_freedom;
    const double upper = report.f_bound_percent * std::sqrt(degrees / lower_chi_squared(degrees));
    report.poorly_determined = upper > options.poor_f_percent;
    if (report.poorly_determined) {
        add_reason(report, options.poor_f_percent);
    }
    return true;
}

}  // namespace

Result<TsaiReport> calibrate_tsai(const std::vector<SeenPoint>& points, const TsaiOptions& options,
                                  const std::vector<int>& labels) {
    if (const auto fault = fault_of(points, options.coplanar, labels)) {
        return *fault;
    }
    TsaiFitOptions fit_options;
    fit_options.given.cx_px = options.cx_px;
    fit_options.given.cy_px = options.cy_px;
    fit_options.given.sx = options.sx;
    fit_options.given.sensor = options.sensor;
    fit_options.method = options.method;
    fit_options.coplanar = options.coplanar;
    const auto found = agreeing(points, fit_options);
    if (!found) {
        return found.error();
    }
    TsaiReport report;
    report.outliers = found->outliers;
    report.view = found->view;
    std::vector<SeenPoint> used;
    for (const int i : found->inliers) {
        used.push_back(points[static_cast<std::size_t>(i)]);
    }
    if (options.method == TsaiMethod::basic) {
        const auto basic = fit(used, fit_options);
        if (!basic) {
            return no_camera(" by the basic method");
        }
        report.view = *basic;
    }
    add_errors(report, used);
    if (!add_uncertainty(report, used, fit_options, options)) {
        return no_camera(": they leave a parameter undetermined");
    }
    if (report.noise_px > worst_noise_of_extent * extent_px(used)) {
        char text[80];
        std::snprintf(text, sizeof text, ": the best one misses them by %.1f px",
                      report.mean_error_px);
        return no_camera(text);
    }
    return report;
}

}  // namespace kambara
