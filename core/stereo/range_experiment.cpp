// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/range_experiment.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "core/geometry/rigid_transform.h"

namespace kambara {
namespace {

using Points = Eigen::Matrix3Xd;

struct Reading {
    Points known;
    Points measured;
    std::vector<double> scatter_mm;
    std::vector<Spread> spreads;
};

Error at_station(std::size_t index, const std::string& what) {
    return {"Station " + std::to_string(index + 1) + " " + what + ".",
            "Leave it out, or mend the tables of known places and of measured positions."};
}

Result<Reading> gathered(const std::vector<RangeStation>& stations) {
    if (stations.empty()) {
        return Error{"There are no stations to judge.",
                     "Give at least one known place with a measured position."};
    }
    const auto count = static_cast<Eigen::Index>(stations.size());
    Reading reading{Points(3, count), Points(3, count), {}, {}};
    for (std::size_t i = 0; i < stations.size(); ++i) {
        const RangeStation& station = stations[i];
        if (station.readings_in_left_mm.empty()) {
            return at_station(i, "was not measured");
        }
        reading.spreads.push_back(spread_of(station.readings_in_left_mm));
        const Eigen::Vector3d mean = reading.spreads.back().mean_mm;
        double squares = 0.0;
        for (const Eigen::Vector3d& point : station.readings_in_left_mm) {
            squares += std::pow(point.norm() - mean.norm(), 2);
        }
        const double others = static_cast<double>(station.readings_in_left_mm.size()) - 1.0;
        reading.scatter_mm.push_back(others > 0.0 ? std::sqrt(squares / others) : 0.0);
        if (!station.known_mm.allFinite() || !mean.allFinite()) {
            return at_station(i, "has a coordinate that is no number");
        }
        if (!(mean.z() > 0.0)) {
            return at_station(i, "was measured behind the left camera");
        }
        const auto column = static_cast<Eigen::Index>(i);
        reading.known.col(column) = station.known_mm;
        reading.measured.col(column) = mean;
    }
    return reading;
}

bool spans_a_plane(const Points& points) {
    const Points centred = points.colwise() - points.rowwise().mean();
    const Eigen::Vector3d spread = Eigen::JacobiSVD<Points>(centred).singularValues();
    return points.cols() >= 4 && spread[1] > 1e-3 * spread[0] && spread[0] > 0.0;
}

// Umeyama (1991): known places laid upon measured ones, with a common scale or without.
Eigen::Matrix4d known_upon(const Points& known, const Points& measured, bool with_scale) {
    return Eigen::umeyama(known, measured, with_scale);
}

Points carried(const Eigen::Matrix4d& T, const Points& points) {
    return (T.topLeftCorner<3, 3>() * points).colwise() + T.topRightCorner<3, 1>();
}

// Measured `factor` farther away than the readings were.
RangeErrors errors_of(const Points& known, const Reading& reading, double factor) {
    const Points measured = factor * reading.measured;
    RangeErrors errors;
    const auto count = static_cast<double>(known.cols());
    for (Eigen::Index i = 0; i < known.cols(); ++i) {
        StationError one;
        one.known_in_left_mm = known.col(i);
        one.measured_in_left_mm = measured.col(i);
        one.range_error_pct = 100.0 * (measured.col(i).norm() / known.col(i).norm() - 1.0);
        one.depth_error_pct = 100.0 * (measured(2, i) / known(2, i) - 1.0);
        one.position_error_mm = (measured.col(i) - known.col(i)).norm();
        const auto station = static_cast<std::size_t>(i);
        one.scatter_mm = factor * reading.scatter_mm[station];
        one.spread_mm = factor * reading.spreads[station].rms_mm;
        one.steady = reading.spreads[station].steady;
        errors.mean_range_pct += std::abs(one.range_error_pct) / count;
        errors.mean_depth_pct += std::abs(one.depth_error_pct) / count;
        errors.mean_position_mm += one.position_error_mm / count;
        errors.worst_range_pct = std::max(errors.worst_range_pct, std::abs(one.range_error_pct));
        errors.worst_depth_pct = std::max(errors.worst_depth_pct, std::abs(one.depth_error_pct));
        errors.worst_position_mm = std::max(errors.worst_position_mm, one.position_error_mm);
        errors.stations.push_back(one);
    }
    return errors;
}

// The factor that makes the measured ranges fit the known ones, each error counting by its share
// of the range.
double best_factor(const Points& known, const Points& measured, bool fit_frame) {
    if (fit_frame) {
        return 1.0 /
               std::cbrt(known_upon(known, measured, true).topLeftCorner<3, 3>().determinant());
    }
    const Eigen::RowVectorXd ratio =
        measured.colwise().norm().cwiseQuotient(known.colwise().norm());
    return ratio.sum() / ratio.squaredNorm();
}

bool within_1999(const RangeErrors& errors) {
    return errors.mean_range_pct <= mean_range_error_1999_pct &&
           errors.worst_range_pct <= worst_range_error_1999_pct;
}

RangeVerdict verdict_of(const RangeExperiment& experiment) {
    if (!std::all_of(experiment.before.stations.begin(), experiment.before.stations.end(),
                     [](const StationError& one) { return one.steady; })) {
        return RangeVerdict::moved;
    }
    if (within_1999(experiment.before)) {
        return RangeVerdict::good;
    }
    if (experiment.baseline_found &&
        experiment.before.stations.size() < least_stations_to_correct) {
        return RangeVerdict::too_few_places;
    }
    return within_1999(experiment.after) ? RangeVerdict::good_corrected : RangeVerdict::not_good;
}

Error no_such_baseline(const RangeExperiment& experiment, double baseline_mm) {
    char cause[240];
    std::snprintf(cause, sizeof cause,
                  "The baseline that suits the known places best is %.0f mm, the rig's is %.0f mm, "
                  "and the range error is %.1f %% in the mean: that is no wrong baseline.",
                  experiment.corrected_baseline_mm, baseline_mm, experiment.before.mean_range_pct);
    return {cause,
            "Check the known places, their frame and their unit, and that the target that was "
            "followed stood there; or give the baseline measured by tape."};
}

}  // namespace

Spread spread_of(const std::vector<Eigen::Vector3d>& readings_mm) {
    Spread spread;
    const auto count = static_cast<double>(readings_mm.size());
    for (const Eigen::Vector3d& one : readings_mm) {
        spread.mean_mm += one / count;
    }
    double squares = 0.0;
    for (const Eigen::Vector3d& one : readings_mm) {
        squares += (one - spread.mean_mm).squaredNorm() / count;
    }
    spread.rms_mm = std::sqrt(squares);
    spread.steady = spread.rms_mm <= most_spread_share * spread.mean_mm.norm();
    return spread;
}

const char* to_string(RangeVerdict verdict) {
    switch (verdict) {
        case RangeVerdict::good:
            return "good";
        case RangeVerdict::good_corrected:
            return "good_corrected";
        case RangeVerdict::not_good:
            return "not_good";
        case RangeVerdict::moved:
            return "moved";
        case RangeVerdict::too_few_places:
            break;
    }
    return "too_few_places";
}

Result<RangeExperiment> judge_ranges(const std::vector<RangeStation>& stations,
                                     const RangeExperimentOptions& options) {
    if (!(options.baseline_mm > 0.0) ||
        (options.true_baseline_mm && !(*options.true_baseline_mm > 0.0))) {
        return Error{"A baseline is not positive.", "Give the distance of both cameras in mm."};
    }
    const auto reading = gathered(stations);
    if (!reading) {
        return reading.error();
    }
    if (options.fit_frame && !(spans_a_plane(reading->known) && spans_a_plane(reading->measured))) {
        return Error{"The known places do not fix where their frame lies.",
                     "Give four or more that are not on one line, or give them in the rig's or the "
                     "left camera's frame."};
    }
    const auto in_left = [&](const Points& measured) -> Points {
        return options.fit_frame
                   ? carried(known_upon(reading->known, measured, false), reading->known)
                   : reading->known;
    };
    const Points known_before = in_left(reading->measured);
    for (Eigen::Index i = 0; i < known_before.cols(); ++i) {
        if (!(known_before(2, i) > 0.0)) {
            return at_station(static_cast<std::size_t>(i),
                              "has a known place that is not before the left camera");
        }
    }
    RangeExperiment result;
    result.before = errors_of(known_before, *reading, 1.0);
    const double factor = options.true_baseline_mm
                              ? *options.true_baseline_mm / options.baseline_mm
                              : best_factor(reading->known, reading->measured, options.fit_frame);
    result.corrected_baseline_mm = factor * options.baseline_mm;
    result.baseline_found = !options.true_baseline_mm;
    if (result.baseline_found && !(std::abs(factor - 1.0) <= most_correction_share)) {
        return no_such_baseline(result, options.baseline_mm);
    }
    const Points corrected = factor * reading->measured;
    result.after = errors_of(in_left(corrected), *reading, factor);
    if (result.baseline_found && known_before.cols() > 1) {
        double squares = 0.0;
        for (const StationError& one : result.after.stations) {
            squares += std::pow(0.01 * one.range_error_pct, 2);
        }
        const auto count = static_cast<double>(known_before.cols());
        result.corrected_baseline_sigma_mm =
            result.corrected_baseline_mm * std::sqrt(squares / (count - 1.0) / count);
    }
    result.verdict = verdict_of(result);
    return result;
}

}  // namespace kambara
