// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/base/result.h"

namespace kambara {

/// The bar of 1999 (section 7.2.3): the mean and the worst range error after its baseline had been
/// corrected.
inline constexpr double mean_range_error_1999_pct = 1.33;
inline constexpr double worst_range_error_1999_pct = 2.76;
/// A baseline that is fitted to fewer places says nothing of what is left after it.
inline constexpr std::size_t least_stations_to_correct = 4;
/// 1999 corrected its baseline by 15 %. One that would have to change by more is no baseline that
/// is wrong, but places or a target that are.
inline constexpr double most_correction_share = 0.25;

/// The target moved, or another was matched, while readings lie farther apart than this (RMS about
/// their mean, by the distance): a rig's noise is a tenth of it.
inline constexpr double most_spread_share = 0.005;

/// A known place and the positions measured while the target was there, in the left camera's frame.
struct RangeStation {
    Eigen::Vector3d known_mm = Eigen::Vector3d::Zero();  ///< in the frame in which it was measured
    std::vector<Eigen::Vector3d> readings_in_left_mm;    ///< one or more
};

/// How far readings lie about their mean in all directions, RMS; and whether the target stood still
/// meanwhile (most_spread_share).
struct Spread {
    Eigen::Vector3d mean_mm = Eigen::Vector3d::Zero();
    double rms_mm = 0.0;
    bool steady = true;
};

/// Of one reading or more.
Spread spread_of(const std::vector<Eigen::Vector3d>& readings_mm);

struct RangeExperimentOptions {
    double baseline_mm = 0.0;  ///< of the rig that measured
    /// The baseline measured by other means; without it, the one that suits the known places best
    /// is found, which uses up what they say of scale.
    std::optional<double> true_baseline_mm;
    /// Where the known places' frame lies is not known: it is laid upon the measured ones by least
    /// squares, separately before and after the correction, and what is left is judged.
    bool fit_frame = false;
};

/// One station as measured: the mean of its readings.
struct StationError {
    Eigen::Vector3d known_in_left_mm = Eigen::Vector3d::Zero();
    Eigen::Vector3d measured_in_left_mm = Eigen::Vector3d::Zero();
    double range_error_pct = 0.0;  ///< of the distance from the left camera; positive: too far
    double depth_error_pct = 0.0;  ///< likewise, of z
    double position_error_mm = 0.0;
    double scatter_mm = 0.0;  ///< deviation of the readings' range; 0 with a single one
    double spread_mm = 0.0;   ///< as spread_of() says
    bool steady = true;       ///< the target stood still, as far as the readings tell
};

struct RangeErrors {
    std::vector<StationError> stations;
    double mean_range_pct = 0.0;  ///< of the errors' amounts
    double worst_range_pct = 0.0;
    double mean_depth_pct = 0.0;
    double worst_depth_pct = 0.0;
    double mean_position_mm = 0.0;
    double worst_position_mm = 0.0;
};

enum class RangeVerdict {
    good,            ///< within the bar of 1999 without any correction
    good_corrected,  ///< with the corrected baseline
    not_good,        ///< not even then
    moved,           ///< a target that did not stand still was measured: nothing is proven
    too_few_places,  ///< not without a correction, and a found one would prove nothing
};

const char* to_string(RangeVerdict verdict);  ///< as the enumerator

struct RangeExperiment {
    RangeErrors before;
    RangeErrors after;  ///< with the corrected baseline
    RangeVerdict verdict = RangeVerdict::not_good;
    double corrected_baseline_mm = 0.0;
    bool baseline_found = false;  ///< from the places; false: given
    /// One deviation of a found baseline, as the stations' errors scatter; 0 where it was given or
    /// rests on one station.
    double corrected_baseline_sigma_mm = 0.0;
};

/// Known places against measured ones, before and after a correction of the baseline alone (1999,
/// section 7.2.3: errors of about 15 % fell to 1.33 % in the mean). A baseline longer by a factor
/// makes every position that much farther from the left camera's centre, so nothing is matched or
/// triangulated anew. Refuses: no station or one without readings, places that are not finite or
/// before the cameras, a frame to be fitted to fewer than four places or to places on one line, a
/// baseline found that is beyond most_correction_share.
Result<RangeExperiment> judge_ranges(const std::vector<RangeStation>& stations,
                                     const RangeExperimentOptions& options);

}  // namespace kambara
