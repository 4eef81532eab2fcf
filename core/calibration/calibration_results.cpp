// SPDX-License-Identifier: GPL-3.0-or-later
// From the adjusted bundle to the report's numbers.
#include <algorithm>
#include <cmath>
#include <set>

#include "core/calibration/calibration_gates.h"
#include "core/camera/rig_parameters.h"

namespace kambara {
namespace {

constexpr int fields_across = 8;
constexpr int fields_down = 6;

int field_of(const Eigen::Vector2d& px, const PictureSize& size) {
    const auto at = [](double x, int n, int fields) {
        return std::clamp(static_cast<int>((x + 0.5) * fields / n), 0, fields - 1);
    };
    return at(px.y(), size.height_px, fields_down) * fields_across +
           at(px.x(), size.width_px, fields_across);
}

// What a field's corners have in common beyond what chance leaves of their mean: root mean square
// over the fields, each counting by its corners.
double systematic_px(const std::vector<Residual>& residuals, int camera, const PictureSize& size) {
    struct Field {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        double squares = 0.0;
        int n = 0;
    };
    std::vector<Field> fields(static_cast<std::size_t>(fields_across * fields_down));
    for (const Residual& r : residuals) {
        if (r.camera == camera && r.used) {
            Field& field = fields[static_cast<std::size_t>(field_of(r.px, size))];
            field.sum += r.residual_px;
            field.squares += r.residual_px.squaredNorm();
            ++field.n;
        }
    }
    double systematic = 0.0;
    int n = 0;
    for (const Field& field : fields) {
        if (field.n < 8) {
            continue;
        }
        const double mean2 = (field.sum / field.n).squaredNorm();
        const double within = (field.squares - field.n * mean2) / (field.n - 1);
        systematic += field.n * (mean2 - within / field.n);
        n += field.n;
    }
    return n > 0 ? std::sqrt(std::max(0.0, systematic / n)) : 0.0;
}

CameraResult camera_result(const Bundle& bundle, const BundleCovariance& covariance, std::size_t k,
                           int place, const PictureSize& size, const CalibrationReport& report) {
    const BundleCamera& camera = bundle.cameras[k];
    CameraResult result;
    result.camera = {lens_of(camera.lens, camera.model, camera.sensor), size.width_px,
                     size.height_px, RigidTransform{}};
    const auto names = parameter_names(camera.model);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto at = static_cast<Eigen::Index>(k * camera_parameters + i);
        result.parameters.push_back(
            {names[i], camera.lens[i], std::sqrt(std::max(0.0, covariance.cameras(at, at)))});
    }
    double sum = 0.0;
    std::set<int> views;
    std::set<int> fields;
    for (const Residual& r : report.residuals) {
        if (r.camera == place && r.used) {
            sum += r.residual_px.squaredNorm();
            ++result.corners_used;
            views.insert(r.view);
            fields.insert(field_of(r.px, size));
        }
    }
    result.views_used = static_cast<int>(views.size());
    result.rms_px = std::sqrt(sum / std::max(1, result.corners_used));
    result.picture_share =
        static_cast<double>(fields.size()) / static_cast<double>(fields_across * fields_down);
    result.systematic_px = systematic_px(report.residuals, place, size);
    return result;
}

PairResult pair_result(const Bundle& bundle, const BundleCovariance& covariance, std::size_t k) {
    PairResult pair;
    pair.T_other_from_left = transform_of(bundle.cameras[k].camera_from_first);
    const auto t = static_cast<Eigen::Index>(k * camera_parameters + 15);
    pair.sigma_T_mm = covariance.cameras.diagonal().segment<3>(t).cwiseMax(0.0).cwiseSqrt();
    std::tie(pair.baseline_mm, pair.baseline_sigma_mm) = baseline_of(bundle, covariance, k);
    return pair;
}

void fill_depths(const Bundle& bundle, CalibrationReport& report) {
    report.nearest_mm = 1e300;
    report.farthest_mm = 0.0;
    for (const BundleCorner& corner : bundle.corners) {
        if (corner.used) {
            const auto& pose = bundle.first_from_target[static_cast<std::size_t>(corner.view)];
            const double z =
                (transform_of(pose) * bundle.target_mm[static_cast<std::size_t>(corner.id)]).z();
            report.nearest_mm = std::min(report.nearest_mm, z);
            report.farthest_mm = std::max(report.farthest_mm, z);
        }
    }
}

double rms_of(const std::vector<Residual>& residuals, int most_camera) {
    double sum = 0.0;
    int n = 0;
    for (const Residual& r : residuals) {
        if (r.used && r.camera <= most_camera) {
            sum += r.residual_px.squaredNorm();
            ++n;
        }
    }
    return std::sqrt(sum / std::max(1, n));
}

// From the adjustment's parameters to the rig's own (rig_parameters.h): the pose's angle-axis
// vector to a turn put before the rotation.
Eigen::MatrixXd parameter_covariance(const Bundle& bundle, const BundleCovariance& covariance,
                                     const Rig& rig) {
    const auto left = static_cast<Eigen::Index>(lens_parameter_names(rig.left.lens).size());
    const auto right = static_cast<Eigen::Index>(lens_parameter_names(rig.right->lens).size());
    const PoseBlock& pose = bundle.cameras[1].camera_from_first;
    Eigen::MatrixXd by_block = Eigen::MatrixXd::Zero(left + right + 6, 2 * camera_parameters);
    by_block.block(0, 0, left, left).setIdentity();
    by_block.block(left, camera_parameters, right, right).setIdentity();
    const Eigen::Index at = camera_parameters + 12;
    constexpr double step_rad = 1e-6;
    for (Eigen::Index i = 0; i < 3; ++i) {
        PoseBlock low = pose;
        PoseBlock high = pose;
        low[static_cast<std::size_t>(i)] -= step_rad;
        high[static_cast<std::size_t>(i)] += step_rad;
        const PoseBlock turn = block_of(
            RigidTransform{transform_of(high).R * transform_of(low).R.transpose(), {0, 0, 0}});
        by_block.block<3, 1>(left + right, at + i) =
            Eigen::Vector3d(turn[0], turn[1], turn[2]) / (2.0 * step_rad);
    }
    by_block.block<3, 3>(left + right + 3, at + 3).setIdentity();
    return by_block *
           covariance.cameras.topLeftCorner(2 * camera_parameters, 2 * camera_parameters) *
           by_block.transpose();
}

Rig rig_of(const CalibrationReport& report, const RigCalibratorOptions& options) {
    Rig rig;
    rig.left = report.cameras[0]->camera;
    if (report.cameras[1]) {
        rig =
            rig_from_pair(rig.left, report.cameras[1]->camera, report.pairs[1]->T_other_from_left);
        rig.provenance.baseline_sigma_mm = report.pairs[1]->baseline_sigma_mm;
        rig.provenance.stereo_rms_px = report.stereo_rms_px;
    }
    if (report.cameras[2]) {
        rig.pan_tilt = report.cameras[2]->camera;
        rig.pan_tilt->T_camera_from_rig =
            report.pairs[2]->T_other_from_left * rig.left.T_camera_from_rig;
    }
    rig.medium = options.medium;
    return rig;
}

}  // namespace

std::pair<double, double> baseline_of(const Bundle& bundle, const BundleCovariance& covariance,
                                      std::size_t camera) {
    const Eigen::Vector3d t = transform_of(bundle.cameras[camera].camera_from_first).t_mm;
    const auto at = static_cast<Eigen::Index>(camera * camera_parameters + 15);
    const Eigen::Matrix3d C = covariance.cameras.block<3, 3>(at, at);
    const Eigen::Vector3d along = t.normalized();
    return {t.norm(), std::sqrt(std::max(0.0, along.dot(C * along)))};
}

void fill_report(const Bundle& bundle, const BundleCovariance& covariance,
                 const std::vector<std::size_t>& places, const std::vector<std::size_t>& numbers,
                 const RigCalibratorOptions& options, CalibrationReport& report) {
    for (const BundleCorner& corner : bundle.corners) {
        const auto r = residual_px(bundle, corner);
        report.residuals.push_back(
            {static_cast<int>(numbers[static_cast<std::size_t>(corner.view)]),
             static_cast<int>(places[static_cast<std::size_t>(corner.camera)]), corner.id,
             corner.px, r.value_or(Eigen::Vector2d::Zero()), corner.used && r});
        report.corners_used += corner.used && r ? 1 : 0;
    }
    report.rms_px = rms_of(report.residuals, static_cast<int>(most_cameras));
    for (std::size_t k = 0; k < places.size(); ++k) {
        report.cameras[places[k]] =
            camera_result(bundle, covariance, k, static_cast<int>(places[k]),
                          *options.cameras[places[k]], report);
        if (k > 0) {
            report.pairs[places[k]] = pair_result(bundle, covariance, k);
        }
    }
    fill_depths(bundle, report);
    if (report.cameras[1]) {
        report.stereo_rms_px = rms_of(report.residuals, 1);
    }
    report.rig = rig_of(report, options);
    for (std::size_t k = 0; k < places.size(); ++k) {
        if (places[k] == 2) {
            const auto at = static_cast<Eigen::Index>(k * camera_parameters);
            const auto n =
                static_cast<Eigen::Index>(lens_parameter_names(report.rig.pan_tilt->lens).size());
            report.rig.pan_tilt_lens_covariance = covariance.cameras.block(at, at, n, n);
        }
    }
    if (report.cameras[1]) {
        report.rig.parameter_covariance = parameter_covariance(bundle, covariance, report.rig);
        RangeErrorOptions& range = report.range_options;
        range.nearest_mm = std::min(1000.0, report.farthest_mm);
        range.farthest_mm = 2.0 * range.nearest_mm;
        range.height_mm = 0.2 * range.nearest_mm;
        range.noise_px = report.rms_px / std::sqrt(2.0);
        report.range_errors =
            range_error_map(bundle, covariance.cameras, report.rig.left.T_camera_from_rig,
                            {options.cameras[0]->width_px, options.cameras[0]->height_px}, range);
    }
}

}  // namespace kambara
