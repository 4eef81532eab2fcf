// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/image/rectangle.h"
#include "core/stereo/position.h"
#include "core/tracking/patch.h"
#include "core/tracking/predictor.h"
#include "core/tracking/search_detail.h"
#include "core/tracking/target_search.h"
#include "core/tracking/track_state.h"

namespace kambara {

/// What one pair of pictures said about one target.
struct TrackEstimate {
    std::int64_t frame = -1;  ///< the pair it speaks of
    TrackState state = TrackState::idle;
    std::string reason;  ///< why the state is what it is; empty while all is well
    std::optional<Eigen::Vector2d> left_px;   ///< of the template's reference point
    std::optional<Eigen::Vector2d> right_px;  ///< likewise
    double quality = 0.0;                     ///< in [0, 1]: the weaker of both pictures'
    std::optional<Position> position;
    Eigen::Vector2i template_size_px = Eigen::Vector2i::Zero();
    int template_updates = 0;
    std::shared_ptr<const SearchDetail> search;  ///< null while nothing is looked for

    /// Leaves state and template: where the target is is not known of this pair.
    void forget_place();
};

/// Follows one target through stereo pairs: window search left, epipolar search right, position.
///
///            set_template            start                 good match in both
///   Idle ------------------> TemplateSet ------> Tracking <------------------+
///    ^                         ^   ^                | weak match, or none    |
///    | clear (from any)        |   | stop           v in the right picture   |
///    +---                 given up +----------- Doubtful ------------------->+
///                              |                    | no match, or doubtful  |
///                              |                    v for too long           |
///                              +------------------ Lost -------------------->+
///                                                 (search widens)
///
/// The template cut at first stays the reference. When the view of it changes so much that it fits
/// badly, a fresh one is cut from a good and safe match and used beside it; whenever the first fits
/// well again it decides, so that the place does not creep. Owned and used by one thread. Pictures
/// are grey and of the rig's size.
class StereoTracker {
  public:
    explicit StereoTracker(Rig rig, TrackerOptions options = {});

    /// Cuts the template from the left picture and looks for it in the right one. A refused
    /// rectangle leaves an earlier template as it was.
    Result<Done> set_template(const StereoFrame& frame, const Rectangle& rectangle);
    Result<Done> start();  ///< needs a template
    void stop();           ///< keeps the template
    void clear();
    /// Makes what is seen now the new reference. Needs a current match.
    Result<Done> update_template();

    /// Nothing seen so far says where the target is now: it is looked for everywhere.
    void forget_motion();

    /// Takes the next pair. Only while started does it search.
    TrackEstimate process(const StereoFrame& frame);

    const TrackEstimate& estimate() const { return estimate_; }
    bool started() const { return started_; }

  private:
    std::optional<TargetMeasurement> measure(const StereoFrame& frame,
                                             const Eigen::Vector3d& expected_in_rig_mm, bool lost,
                                             bool everywhere);
    Eigen::Vector3d expected_place(std::int64_t time_ns) const;
    void adopt(const TargetMeasurement& measured, const StereoFrame& frame);
    void judge(const TargetMeasurement& measured);
    void anchor(const Eigen::Vector3d& point_in_rig_mm);
    void refresh_template(const TargetMeasurement& measured, const StereoFrame& frame);
    void miss(const std::string& why);
    void become(TrackState state, std::string reason);

    Rig rig_;
    TrackerOptions options_;
    TrackEstimate estimate_;
    std::optional<ReferencePatch> first_;   // the operator's: the reference
    std::optional<ReferencePatch> latest_;  // cut on the way, where the first fits badly
    bool range_known_ = false;
    bool place_unknown_ = false;
    bool started_ = false;
    int frames_in_state_ = 0;
    int frames_since_update_ = 0;
    std::optional<StereoFrame> last_frame_;
    std::optional<TargetMeasurement> last_measured_;
    std::optional<Eigen::Vector3d> sure_place_in_rig_mm_;  // when it was last Tracking
    std::optional<Eigen::Vector2d> first_seen_px_;  // by the first template, in the last pair
    Predictor predictor_;
};

}  // namespace kambara
