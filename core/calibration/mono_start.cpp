// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/mono_start.h"
#include "core/base/median.h"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <utility>

namespace kambara {
namespace {

constexpr std::size_t least_corners = 6;
constexpr std::size_t views_to_try = 8;
constexpr double hopeless_px = 60.0;
constexpr double outlier_sigmas = 6.0;
constexpr double never_outlier_px = 0.6;

struct Pose {
    PoseBlock camera_from_target{};
    double rms_px = hopeless_px;
};

// The pose that fits a view through a lens without distortion.
std::optional<Pose> pose_by_pinhole(const std::vector<Eigen::Vector3d>& target_mm,
                                    const DetectedCorners& corners, double f_px,
                                    const MonoStart& start, double aspect) {
    if (corners.size() < least_corners) {
        return std::nullopt;
    }
    std::vector<cv::Point3d> at;
    std::vector<cv::Point2d> seen;
    for (const DetectedCorner& corner : corners) {
        const Eigen::Vector3d& p = target_mm[static_cast<std::size_t>(corner.id)];
        at.emplace_back(p.x(), p.y(), p.z());
        seen.emplace_back(corner.px.x(), corner.px.y());
    }
    const cv::Matx33d K(f_px * aspect, 0.0, 0.5 * (start.width_px - 1), 0.0, f_px,
                        0.5 * (start.height_px - 1), 0.0, 0.0, 1.0);
    cv::Vec3d r;
    cv::Vec3d t;
    std::vector<cv::Point2d> again;
    try {
        if (!cv::solvePnP(at, seen, K, cv::noArray(), r, t, false, cv::SOLVEPNP_ITERATIVE)) {
            return std::nullopt;
        }
        cv::projectPoints(at, r, t, K, cv::noArray(), again);
    } catch (const cv::Exception&) {
        return std::nullopt;  // points that determine no pose: all on a line, for example
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const cv::Point2d d = again[i] - seen[i];
        sum += d.dot(d);
    }
    const double rms = std::sqrt(sum / static_cast<double>(seen.size()));
    if (!std::isfinite(rms) || !(t[2] > 0.0)) {
        return std::nullopt;
    }
    return Pose{{r[0], r[1], r[2], t[0], t[1], t[2]}, rms};
}

// Picture height over width of a pixel's pitch: 1 but for a sensor that says otherwise.
double aspect_of(const MonoStart& start) {
    return start.model == LensModel::tsai ? start.sensor.dy_mm / start.sensor.dx_prime_mm() : 1.0;
}

// Up to eight views, spread over all.
std::vector<std::size_t> views_tried(const std::vector<DetectedCorners>& views) {
    std::vector<std::size_t> good;
    for (std::size_t i = 0; i < views.size(); ++i) {
        if (views[i].size() >= least_corners) {
            good.push_back(i);
        }
    }
    std::vector<std::size_t> tried;
    const std::size_t n = std::min(views_to_try, good.size());
    for (std::size_t i = 0; i < n; ++i) {
        tried.push_back(good[i * good.size() / n]);
    }
    return tried;
}

double focal_length_px(const std::vector<Eigen::Vector3d>& target_mm,
                       const std::vector<DetectedCorners>& views, const MonoStart& start) {
    const auto tried = views_tried(views);
    double best_f = 0.0;
    double best = 1e300;
    for (double f = 0.35 * start.width_px; f < 6.0 * start.width_px; f *= 1.22) {
        double sum = 0.0;
        for (const std::size_t i : tried) {
            const auto pose = pose_by_pinhole(target_mm, views[i], f, start, aspect_of(start));
            sum += pose ? std::min(pose->rms_px, hopeless_px) : hopeless_px;
        }
        if (sum < best) {
            best = sum;
            best_f = f;
        }
    }
    return best_f;
}

BundleCamera camera_at(double f_px, const MonoStart& start) {
    BundleCamera camera{start.model, start.sensor, start.free_k3, {}, {}};
    const double cx = 0.5 * (start.width_px - 1);
    const double cy = 0.5 * (start.height_px - 1);
    if (start.model == LensModel::tsai) {
        camera.lens = {f_px * start.sensor.dy_mm, 0.0, cx, cy, 1.0};
    } else {
        camera.lens = {f_px, f_px, cx, cy};
    }
    return camera;
}

std::vector<Eigen::Vector2d> residuals_of(const Bundle& bundle) {
    std::vector<Eigen::Vector2d> residuals;
    for (const BundleCorner& corner : bundle.corners) {
        residuals.push_back(
            residual_px(bundle, corner).value_or(Eigen::Vector2d::Constant(hopeless_px)));
    }
    return residuals;
}

}  // namespace

double robust_sigma_px(const std::vector<Eigen::Vector2d>& residuals) {
    std::vector<double> sizes;
    for (const Eigen::Vector2d& r : residuals) {
        sizes.push_back(std::abs(r.x()));
        sizes.push_back(std::abs(r.y()));
    }
    return 1.4826 * median(std::move(sizes));
}

MonoResult calibrate_mono(const std::vector<Eigen::Vector3d>& target_mm,
                          const std::vector<DetectedCorners>& views, const MonoStart& start,
                          const std::stop_token& stop) {
    MonoResult result;
    result.camera_from_target.resize(views.size());
    result.view_rms_px.resize(views.size());
    result.kept.resize(views.size());
    const double f_px = focal_length_px(target_mm, views, start);
    if (f_px <= 0.0) {
        return result;
    }
    Bundle bundle;
    bundle.target_mm = target_mm;
    bundle.cameras = {camera_at(f_px, start)};
    std::vector<std::size_t> numbers;  // of the views that have a pose
    for (std::size_t i = 0; i < views.size(); ++i) {
        const auto pose = pose_by_pinhole(target_mm, views[i], f_px, start, aspect_of(start));
        if (!pose) {
            continue;
        }
        for (const DetectedCorner& corner : views[i]) {
            bundle.corners.push_back({static_cast<int>(numbers.size()), 0, corner.id, corner.px,
                                      std::clamp(corner.sigma_px, 0.02, 2.0), true});
        }
        numbers.push_back(i);
        bundle.first_from_target.push_back(pose->camera_from_target);
    }
    if (numbers.empty() || !adjust(bundle, 10.0, stop)) {
        return result;
    }
    double sigma = std::max(0.02, robust_sigma_px(residuals_of(bundle)));
    if (!adjust(bundle, 3.0 * sigma, stop)) {
        return result;
    }
    const auto residuals = residuals_of(bundle);
    sigma = robust_sigma_px(residuals);
    const double far_px = std::max(never_outlier_px, outlier_sigmas * sigma);
    std::vector<double> sums(views.size(), 0.0);
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        BundleCorner& corner = bundle.corners[i];
        const std::size_t view = numbers[static_cast<std::size_t>(corner.view)];
        corner.used = residuals[i].norm() <= far_px;
        if (corner.used) {
            result.kept[view].push_back({corner.id, corner.px, corner.sigma_px});
            sums[view] += residuals[i].squaredNorm();
        } else {
            ++result.corners_left_out;
        }
    }
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        const std::size_t view = numbers[k];
        const std::size_t n = result.kept[view].size();
        // A view of which much fits nowhere is no view of this target.
        if (n >= least_corners && 10 * n >= 6 * views[view].size()) {
            result.camera_from_target[view] = bundle.first_from_target[k];
            result.view_rms_px[view] = std::sqrt(sums[view] / static_cast<double>(n));
        }
    }
    result.camera = bundle.cameras[0];
    result.converged = true;
    return result;
}

}  // namespace kambara
