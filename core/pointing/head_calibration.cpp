// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/head_calibration.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string>

#include "core/camera/rig_parameters.h"
#include "core/pointing/aim.h"
#include "core/pointing/head_adjustment.h"

namespace kambara {
namespace {

constexpr int weighings = 3;  // the pixels' deviations settle with the second

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
    if (!rig.right && std::any_of(views.begin(), views.end(),
                                  [](const HeadView& view) { return !view.pair.empty(); })) {
        return Error{"The views hold pixels of a right camera, and the rig file has none.",
                     "Use the rig file of the cameras that took the views."};
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

double rms_px(double squares_px2, int pixels) {
    return std::sqrt(squares_px2 / std::max(1, pixels));
}

HeadModel head_at_home(const Rig& rig) {
    HeadModel model;
    model.T_base_from_rig = rig.pan_tilt->T_camera_from_rig;
    return model;
}

struct Solution {
    HeadUnknowns unknowns;
    HeadAdjustment::Equations equations;
};

// From a start that projects.
Solution solution_of(const HeadAdjustment& problem, const HeadModel& start) {
    HeadUnknowns found = problem.start(start);
    HeadAdjustment::Sigmas sigmas;
    for (int round = 0; round < weighings; ++round) {
        found = problem.solved(found, sigmas).value();
        sigmas = problem.sigmas_of(problem.equations(found, sigmas)->squares);
    }
    return {found, problem.equations(found, sigmas).value()};
}

std::vector<HeadView> places_held(std::vector<HeadView> views) {
    for (HeadView& view : views) {
        view.pair.clear();
    }
    return views;
}

// A side that all views of an axis came from tells its backlash from the camera's turn by belief
// alone: it is left out, and that backlash stays nothing.
std::vector<HeadView> with_sides_that_tell(std::vector<HeadView> views) {
    const bool pan = from_both_sides(views, &HeadApproach::pan);
    const bool tilt = from_both_sides(views, &HeadApproach::tilt);
    for (HeadView& view : views) {
        view.approach.pan = pan ? view.approach.pan : 0;
        view.approach.tilt = tilt ? view.approach.tilt : 0;
    }
    return views;
}

// In the frame that rig.h defines, which a moved right camera turns.
Rig refined_rig(const Rig& rig, const HeadModel& model, const Eigen::VectorXd& by) {
    const Rig moved = with_parameters_moved(rig, by);
    const Rig anew = rig_from_pair(moved.left, *moved.right, T_right_from_left(moved));
    const RigidTransform T_given_from_anew =
        rig.left.T_camera_from_rig.inverse() * anew.left.T_camera_from_rig;
    Rig result = rig;
    result.left = anew.left;
    result.right = anew.right;
    HeadModel turned = model;
    turned.T_base_from_rig = model.T_base_from_rig * T_given_from_anew;
    return with_head_model(result, turned);
}

void note_most_moved(const std::vector<std::string>& names, const std::string& of,
                     const Eigen::VectorXd& off, const Eigen::MatrixXd& before,
                     RigByHeadViews& result) {
    for (Eigen::Index i = 0; i < off.size(); ++i) {
        const double sigma = std::sqrt(before(i, i));
        if (sigma > 0.0 && std::abs(off[i]) > result.most_moved_sigmas * sigma) {
            result.most_moved_sigmas = std::abs(off[i]) / sigma;
            result.most_moved = of + names[static_cast<std::size_t>(i)];
        }
    }
}

RigByHeadViews rig_by_views(const Rig& rig, const HeadModel& model, const HeadAdjustment& problem,
                            const HeadUnknowns& found, const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd off = problem.parameters_off(found);
    RigByHeadViews result;
    note_most_moved(rig_parameter_names(rig), "", off, *rig.parameter_covariance, result);
    result.refined = refined_rig(rig, model, off);
    result.refined.parameter_covariance = problem.parameters_left(covariance);
    if (problem.lens_takes_part()) {
        const Eigen::VectorXd of_lens = problem.lens_off(found);
        Lens& lens = result.refined.pan_tilt->lens;
        note_most_moved(lens_parameter_names(lens), "pan_tilt.", of_lens,
                        *rig.pan_tilt_lens_covariance, result);
        lens = with_lens_moved(lens, of_lens);
        result.refined.pan_tilt_lens_covariance = problem.lens_left(covariance);
        result.pan_tilt_lens_held = false;
    }
    return result;
}

}  // namespace

Result<HeadCalibration> calibrate_head(const Rig& rig, const std::vector<HeadView>& given,
                                       const HeadCalibrationOptions& options) {
    if (const auto error = unfit(rig, given, options)) {
        return *error;
    }
    const auto views = with_sides_that_tell(given);
    const HeadAdjustment problem(rig, views);
    const auto start = problem.equations(problem.start(head_at_home(rig)), {});
    if (!start) {
        return Error{"A point lies where the pan-tilt camera can't see it.",
                     "Check the signs of the angles (pan to the right, tilt upwards) and the "
                     "pan-tilt camera's pose in the rig file."};
    }
    HeadCalibration result;
    result.rms_without_model_px = rms_px(start->squares.head_px2, start->squares.head);
    const Solution found = solution_of(problem, head_at_home(rig));
    const HeadAdjustment::Squares& squares = found.equations.squares;
    result.model = found.unknowns.model;
    result.rms_px = rms_px(squares.head_px2, squares.head);
    if (squares.pair > 0) {
        result.pair_rms_px = rms_px(squares.pair_px2, squares.pair);
    }
    result.views = static_cast<int>(views.size());
    result.points = squares.head;
    if (!(std::max(result.rms_px, result.pair_rms_px.value_or(0.0)) <= options.largest_rms_px)) {
        return Error{
            "The views don't fit a head of two axes: RMS " + std::to_string(result.rms_px) + " px.",
            "Check that each picture stands beside the angles it was taken at, the head "
            "still, and that pan is positive to the right and tilt upwards."};
    }
    const Eigen::MatrixXd covariance = problem.covariance(found.equations);
    const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    result.base_turn_sigma_rad = sigma.segment<3>(0);
    result.base_from_rig_sigma_mm = sigma.segment<3>(3);
    result.tilt_axis_ahead_sigma_mm = sigma[6];
    result.camera_from_tilt_sigma_mm = sigma.segment<3>(11);
    result.pan_backlash_seen = from_both_sides(views, &HeadApproach::pan);
    result.tilt_backlash_seen = from_both_sides(views, &HeadApproach::tilt);
    result.pan_backlash_sigma_rad = sigma[14];
    result.tilt_backlash_sigma_rad = sigma[15];
    result.model_for_given_rig = result.model;
    if (problem.rig_takes_part()) {
        result.by_rig = rig_by_views(rig, result.model, problem, found.unknowns, covariance);
        const auto held = places_held(views);
        result.model_for_given_rig =
            solution_of(HeadAdjustment(rig, held), head_at_home(rig)).unknowns.model;
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

HeadMiss missed_without_model(const Rig& rig, const Rig& without,
                              const std::vector<HeadView>& views, double range_mm) {
    constexpr int steps = 8;
    const auto between = [&](double HeadAngles::*angle, int step) {
        const auto [least, most] = std::minmax_element(
            views.begin(), views.end(),
            [angle](const auto& a, const auto& b) { return a.encoder.*angle < b.encoder.*angle; });
        return least->encoder.*angle +
               (most->encoder.*angle - least->encoder.*angle) * step / steps;
    };
    HeadMiss miss;
    double squares = 0.0;
    for (int i = 0; i <= steps; ++i) {
        for (int k = 0; k <= steps; ++k) {
            const HeadAngles axes{between(&HeadAngles::pan_rad, i),
                                  between(&HeadAngles::tilt_rad, k)};
            const Eigen::Vector3d in_rig = T_camera_from_rig(rig.head.value(), axes).inverse() *
                                           Eigen::Vector3d(0.0, 0.0, range_mm);
            const Eigen::Vector3d point = rig.left.T_camera_from_rig * in_rig;
            const double off = aiming_error_rad(rig, angles_towards(without, point), point);
            squares += off * off / ((steps + 1) * (steps + 1));
            miss.worst_rad = std::max(miss.worst_rad, off);
        }
    }
    miss.rms_rad = std::sqrt(squares);
    return miss;
}

Rig with_head_model(Rig rig, const HeadModel& model) {
    rig.head = model;
    rig.pan_tilt.value().T_camera_from_rig = T_camera_from_rig(model, HeadAngles{});
    return rig;
}

}  // namespace kambara
