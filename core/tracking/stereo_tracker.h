// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/image/rectangle.h"
#include "core/stereo/position.h"
#include "core/tracking/appearance_bank.h"
#include "core/tracking/mean_slope.h"
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
    /// What the predictor made of it, in the left camera's frame; empty until it knows a velocity.
    std::optional<MotionEstimate> motion;
    Eigen::Vector2i template_size_px = Eigen::Vector2i::Zero();
    double scale = 1.0;     ///< of the target in the left picture, against when it was chosen
    double turn_rad = 0.0;  ///< likewise, from the picture's x towards its y
    int template_updates = 0;
    std::shared_ptr<const SearchDetail> search;  ///< null while nothing is looked for

    /// Leaves state and template: where the target is is not known of this pair.
    void forget_place();
};

/// Follows one target through stereo pairs: window search left, epipolar search right, position.
/// With one camera alone, through its pictures: a direction, and the target's growth and turn.
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
/// The template cut at first stays the reference. How the target turns in the picture is measured
/// and followed; how it grows, where its distance does not tell. When the view of it changes so
/// much that the first template fits badly, a fresh one is cut from a good and safe match, at the
/// place that the first one says, and kept in a bank beside it; whenever the first fits well again
/// it decides, so that the place does not creep. A match is taken only where no other place that
/// the target may have reached looks the same. Owned and used by one thread. Pictures are grey and
/// of the rig's size.
class StereoTracker {
  public:
    /// Trackers of the same pictures may share what they have transformed of them.
    explicit StereoTracker(Rig rig, TrackerOptions options = {},
                           std::shared_ptr<TransformCache> transforms = nullptr);

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

    /// The vehicle's motion, which moves the expected place. It may grow between two pairs.
    void follow_vehicle(std::shared_ptr<const VehicleTrack> vehicle) {
        predictor_.follow_vehicle(std::move(vehicle));
    }

    /// Takes the next pair. Only while started does it search.
    TrackEstimate process(const StereoFrame& frame);

    /// Where the target will be, in the left camera's frame; empty while nothing is known of it.
    std::optional<Eigen::Vector3d> expected_in_left_mm(std::int64_t time_ns) const;

    const TrackEstimate& estimate() const { return estimate_; }
    /// How it looked when it was chosen, as it has turned and grown since; null without a template.
    const ReferencePatch* look() const { return looks_ ? &looks_->first() : nullptr; }
    bool started() const { return started_; }

  private:
    void see_clearness(const PatchMatch& match);
    bool fits_well(const PatchMatch& match) const;
    std::optional<TargetMeasurement> measure(const StereoFrame& frame, const SearchScope& scope);
    Eigen::Vector3d at_known_range(const Eigen::Vector3d& point_in_rig_mm) const;
    Eigen::Vector3d expected_place(std::int64_t time_ns) const;
    double reach_px(std::int64_t time_ns) const;
    Eigen::Matrix3d covariance_in_rig_mm2(const TargetMeasurement& measured) const;
    std::optional<MotionEstimate> motion_in_left() const;
    void adopt(const TargetMeasurement& measured, const StereoFrame& frame);
    void note_surprise(const TargetMeasurement& measured, const Eigen::Vector3d& expected);
    void grow_surprise();
    void follow_change(const TargetMeasurement& measured);
    void learn_slope(const TargetMeasurement& measured, const StereoFrame& frame);
    void judge(const TargetMeasurement& measured);
    void anchor(const Eigen::Vector3d& point_in_rig_mm);
    std::optional<Eigen::Vector2d> aligned(const TargetMeasurement& measured,
                                           const Image& grey) const;
    void refresh_template(const TargetMeasurement& measured, const StereoFrame& frame);
    Eigen::Vector2i size_now_px() const;
    void describe_size();
    void miss(const std::string& why);
    void become(TrackState state, std::string reason);

    Rig rig_;
    TrackerOptions options_;
    MatchMethod clear_method_;  // while noise is no trouble
    std::shared_ptr<TransformCache> transforms_;
    TrackEstimate estimate_;
    std::optional<AppearanceBank> looks_;
    MeanSlope slope_;  // of the first look, when it was cut
    bool range_known_ = false;
    int pairs_ = 0;  // since the template was cut
    bool place_unknown_ = false;
    bool started_ = false;
    bool measured_by_first_ = false;
    bool to_be_confirmed_ = false;  // it was not told from its likes in the last pair
    int frames_in_state_ = 0;
    std::optional<StereoFrame> last_frame_;
    std::optional<TargetMeasurement> last_measured_;
    std::optional<Eigen::Vector3d> sure_place_in_rig_mm_;  // when it was last Tracking
    double surprise_px_ = 0.0;  // how far it was off its predicted place of late
    std::int64_t seen_time_ns_ = 0;
    Predictor predictor_;
};

}  // namespace kambara
