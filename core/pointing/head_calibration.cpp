// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/head_calibration.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

namespace kambara {
namespace {

constexpr int numbers = 16;
// base turn 0-2, base place 3-5, arm 6, skew 7, camera turn 8-10, camera place 11-13, backlash
// 14-15
using Step = Eigen::Matrix<double, numbers, 1>;
using Square = Eigen::Matrix<double, numbers, numbers>;

Eigen::Matrix3d turned_by(const Eigen::Vector3d& vector) {
    const double angle = vector.norm();
    return angle < 1e-15 ? Eigen::Matrix3d::Identity()
                         : Eigen::AngleAxisd(angle, vector / angle).toRotationMatrix();
}

Eigen::Vector3d turn_of(const Eigen::Matrix3d& R) {
    const Eigen::AngleAxisd turn(R);
    return turn.angle() * turn.axis();
}

HeadModel moved(HeadModel model, const Step& step) {
    model.T_base_from_rig.R = turned_by(step.segment<3>(0)) * model.T_base_from_rig.R;
    model.T_base_from_rig.t_mm += step.segment<3>(3);
    model.tilt_axis_ahead_mm += step[6];
    model.tilt_axis_skew_rad += step[7];
    model.T_camera_from_tilt.R = turned_by(step.segment<3>(8)) * model.T_camera_from_tilt.R;
    model.T_camera_from_tilt.t_mm += step.segment<3>(11);
    model.pan_backlash_rad += step[14];
    model.tilt_backlash_rad += step[15];
    return model;
}

// How far a model's numbers are from nothing, by what is believed of them; the base is free.
Step beliefs_of(const HeadModel& model) {
    Step off = Step::Zero();
    off[6] = model.tilt_axis_ahead_mm / 200.0;
    off[7] = model.tilt_axis_skew_rad / 0.1;
    off.segment<3>(8) = turn_of(model.T_camera_from_tilt.R) / 0.1;
    off.segment<3>(11) = model.T_camera_from_tilt.t_mm / 200.0;
    off[14] = model.pan_backlash_rad / 0.05;
    off[15] = model.tilt_backlash_rad / 0.05;
    return off;
}

class Problem {
  public:
    Problem(const Lens& lens, const std::vector<HeadView>& views, double sigma_px)
        : lens_(lens), views_(views), sigma_px_(sigma_px) {
        for (const HeadView& view : views) {
            points_ += static_cast<int>(view.sightings.size());
        }
    }

    int points() const { return points_; }

    // Pixels' errors by their deviation, then the beliefs; empty where a point projects nowhere.
    std::optional<Eigen::VectorXd> errors(const HeadModel& model) const {
        Eigen::VectorXd all(2 * points_ + numbers);
        Eigen::Index row = 0;
        for (const HeadView& view : views_) {
            const RigidTransform T =
                T_camera_from_rig(model, axes_at(model, view.encoder, view.approach));
            for (const HeadSighting& one : view.sightings) {
                const auto pixel = kambara::project(lens_, T * one.point_in_rig_mm);
                if (!pixel) {
                    return std::nullopt;
                }
                all.segment<2>(row) = (*pixel - one.pixel) / sigma_px_;
                row += 2;
            }
        }
        all.tail<numbers>() = beliefs_of(model);
        return all;
    }

    double rms_px(const Eigen::VectorXd& errors) const {
        return sigma_px_ * std::sqrt(errors.head(2 * points_).squaredNorm() / std::max(1, points_));
    }

    // By central differences: sixteen numbers, two thousand pixels, a dozen times.
    std::optional<Eigen::MatrixXd> derivatives(const HeadModel& model) const {
        Eigen::MatrixXd J(2 * points_ + numbers, numbers);
        for (int i = 0; i < numbers; ++i) {
            const bool length = (i >= 3 && i <= 6) || (i >= 11 && i <= 13);
            Step step = Step::Zero();
            step[i] = length ? 1e-3 : 1e-6;
            const auto more = errors(moved(model, step));
            const auto less = errors(moved(model, -step));
            if (!more || !less) {
                return std::nullopt;
            }
            J.col(i) = (*more - *less) / (2.0 * step[i]);
        }
        return J;
    }

  private:
    Lens lens_;
    const std::vector<HeadView>& views_;
    double sigma_px_;
    int points_ = 0;
};

// Each view's points were placed by one look of the fixed cameras and err together: their sums
// scatter from view to view by more than single pixels' would (the sandwich estimator, clustered by
// view: Liang and Zeger, Biometrika 73, 1986).
Square covariance_by_views(const Square& information, const Eigen::MatrixXd& J,
                           const Eigen::VectorXd& errors, const std::vector<HeadView>& views) {
    Square scatter = Square::Zero();
    Eigen::Index row = 0;
    for (const HeadView& view : views) {
        const auto rows = static_cast<Eigen::Index>(2 * view.sightings.size());
        const Step sum = J.middleRows(row, rows).transpose() * errors.segment(row, rows);
        scatter += sum * sum.transpose();
        row += rows;
    }
    const double told = 3.0 * static_cast<double>(views.size());  // a place a view at least
    const Square inverse = information.inverse();
    return told / std::max(1.0, told - numbers) * inverse * scatter * inverse;
}

double span(const std::vector<HeadView>& views, double HeadAngles::*angle) {
    const auto [least, most] = std::minmax_element(
        views.begin(), views.end(),
        [angle](const auto& a, const auto& b) { return a.encoder.*angle < b.encoder.*angle; });
    return most->encoder.*angle - least->encoder.*angle;
}

bool from_both_sides(const std::vector<HeadView>& views, int HeadApproach::*axis) {
    const auto any = [&](int side) {
        return std::any_of(views.begin(), views.end(),
                           [&](const HeadView& view) { return view.approach.*axis == side; });
    };
    return any(1) && any(-1);
}

std::optional<Error> unfit(const Rig& rig, const std::vector<HeadView>& views,
                           const HeadCalibrationOptions& options) {
    if (!rig.pan_tilt) {
        return Error{"The rig file holds no pan-tilt camera.",
                     "Calibrate all three cameras with the head at home first."};
    }
    if (static_cast<int>(views.size()) < options.least_views) {
        return Error{std::to_string(views.size()) + " views are too few to calibrate the head.",
                     "Give at least " + std::to_string(options.least_views) +
                         ", over the whole range of pan and tilt that the target allows."};
    }
    if (span(views, &HeadAngles::pan_rad) < options.least_pan_rad ||
        span(views, &HeadAngles::tilt_rad) < options.least_tilt_rad) {
        return Error{"The head's positions lie too near together to tell its axes.",
                     "Spread them over at least 20 degrees of pan and 10 degrees of tilt."};
    }
    return std::nullopt;
}

}  // namespace

Result<HeadCalibration> calibrate_head(const Rig& rig, const std::vector<HeadView>& views,
                                       const HeadCalibrationOptions& options) {
    if (const auto error = unfit(rig, views, options)) {
        return *error;
    }
    const Problem problem(rig.pan_tilt->lens, views, options.sigma_px);
    HeadModel model;
    model.T_base_from_rig = rig.pan_tilt->T_camera_from_rig;
    auto errors = problem.errors(model);
    if (!errors) {
        return Error{"A point lies where the pan-tilt camera can't see it.",
                     "Check the signs of the angles (pan to the right, tilt upwards) and the "
                     "pan-tilt camera's pose in the rig file."};
    }
    HeadCalibration result;
    result.rms_without_model_px = problem.rms_px(*errors);
    double damping = 1e-3;
    Square information = Square::Identity();
    Square by_views = Square::Zero();
    for (int round = 0; round < 100; ++round) {
        const auto J = problem.derivatives(model);
        if (!J) {
            break;
        }
        information = J->transpose() * *J;
        by_views = covariance_by_views(information, *J, *errors, views);
        const Step gradient = J->transpose() * *errors;
        bool better = false;
        double gain = 0.0;
        while (!better && damping < 1e12) {
            Square damped = information;
            damped.diagonal() += damping * information.diagonal();
            const Step step = -damped.ldlt().solve(gradient);
            const HeadModel tried = moved(model, step);
            const auto then = problem.errors(tried);
            better = then && then->squaredNorm() < errors->squaredNorm();
            if (better) {
                gain = 1.0 - then->squaredNorm() / errors->squaredNorm();
                model = tried;
                errors = then;
            }
            damping = better ? std::max(1e-9, 0.1 * damping) : 10.0 * damping;
        }
        if (!better || gain < 1e-10) {
            break;
        }
    }
    result.model = model;
    result.rms_px = problem.rms_px(*errors);
    result.views = static_cast<int>(views.size());
    result.points = problem.points();
    if (!(result.rms_px <= options.largest_rms_px)) {
        return Error{
            "The views don't fit a head of two axes: RMS " + std::to_string(result.rms_px) + " px.",
            "Check that each picture stands beside the angles it was taken at, the head "
            "still, and that pan is positive to the right and tilt upwards."};
    }
    // The scatter that was found, not the one assumed, says how well the numbers are known.
    const double scale = errors->squaredNorm() / std::max(1, 2 * problem.points() - numbers);
    const Square covariance = scale * information.inverse();
    const Step sigma =
        covariance.diagonal().cwiseMax(by_views.diagonal()).cwiseMax(0.0).cwiseSqrt();
    result.tilt_axis_ahead_sigma_mm = sigma[6];
    result.camera_from_tilt_sigma_mm = sigma.segment<3>(11);
    result.pan_backlash_seen = from_both_sides(views, &HeadApproach::pan);
    result.tilt_backlash_seen = from_both_sides(views, &HeadApproach::tilt);
    result.pan_backlash_sigma_rad = sigma[14];
    result.tilt_backlash_sigma_rad = sigma[15];
    if (!result.pan_backlash_seen) {
        result.model.pan_backlash_rad = 0.0;
    }
    if (!result.tilt_backlash_seen) {
        result.model.tilt_backlash_rad = 0.0;
    }
    return result;
}

std::optional<double> view_rms_rad(const Rig& rig, const HeadModel& model, const HeadView& view) {
    const RigidTransform T = T_camera_from_rig(model, axes_at(model, view.encoder, view.approach));
    double squares = 0.0;
    for (const HeadSighting& one : view.sightings) {
        const auto ray = kambara::unproject(rig.pan_tilt.value().lens, one.pixel);
        if (!ray) {
            return std::nullopt;
        }
        const Eigen::Vector3d there = (T * one.point_in_rig_mm - ray->origin_mm).normalized();
        squares += ray->direction.cross(there).squaredNorm();
    }
    return std::sqrt(squares / std::max<double>(1.0, static_cast<double>(view.sightings.size())));
}

Rig with_head_model(Rig rig, const HeadModel& model) {
    rig.head = model;
    rig.pan_tilt.value().T_camera_from_rig = T_camera_from_rig(model, HeadAngles{});
    return rig;
}

}  // namespace kambara
