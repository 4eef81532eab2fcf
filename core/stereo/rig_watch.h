// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "core/camera/rig.h"
#include "core/stereo/position.h"

namespace kambara {

struct RigWatchOptions {
    double window_s =
        4.0;  ///< matches older than this no longer count: a knock shows after half of it
    int least_matches = 20;  ///< fewer say nothing
    double suspect_sigmas = 4.0;
    /// What the matches of a picture's place may have in common all the same, px: interpolation,
    /// the patch's flatness.
    double common_sigma_px = 0.05;
    /// Matches of one target, a frame apart, err together: so many count as one.
    int alike = 10;
};

/// What the watch found in the last few seconds.
struct RigWatchState {
    int matches = 0;
    double offset_px = 0.0;  ///< median of the right pixels beside their epipolar curves, + below
    double sigma_px = 0.0;   ///< deviation of that median for a rig as calibrated
    double turn_rad = 0.0;   ///< of the right camera against the left that would do it; + upwards
    bool moved = false;      ///< the offset is more than a rig as calibrated can leave
    bool operator==(const RigWatchState&) const = default;
};

/// Watches whether the cameras still stand as calibrated (POS-7): the epipolar offset of good
/// matches, as a median over the last seconds, against the deviation that the matches' noise and
/// the calibration allow. A knock that turns the cameras apart vertically, or one of them about its
/// own axis, shows; one that turns them towards each other moves pixels along their epipolar curves
/// and can't be seen this way.
///
///              offset beyond suspect_sigmas
///   as calibrated ------------------------> moved
///                 <------------------------
///                  offset within half of that
///
/// Owned and used by one thread.
class RigWatch {
  public:
    explicit RigWatch(const Rig& rig, RigWatchOptions options = {});

    /// A good match's offset. After a gap of a window or more, and where times run backwards, it
    /// begins anew, the verdict included.
    void add(std::int64_t time_ns, const EpipolarOffset& epipolar);
    /// Forgets the matches and the verdict: for pictures that do not follow the last ones.
    void reset();

    /// Empty while there are too few matches to judge by.
    const std::optional<RigWatchState>& state() const { return state_; }

  private:
    struct Match {
        std::int64_t time_ns;
        EpipolarOffset epipolar;
    };

    void judge();

    RigWatchOptions options_;
    double focal_px_ = 1.0;          // down the right picture
    double rms_of_calibration_ = 0;  // px; what stands for its covariance where that is not known
    std::deque<Match> matches_;
    bool moved_ = false;
    std::optional<RigWatchState> state_;
};

/// What an operator should be told of a rig that has moved: which way, by how much, what to do.
std::string rig_moved_text(const RigWatchState& state);
/// Of one that is again as calibrated.
std::string rig_restored_text(const RigWatchState& state);

}  // namespace kambara
