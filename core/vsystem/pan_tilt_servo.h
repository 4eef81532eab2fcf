// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/image/rectangle.h"
#include "core/pointing/servo.h"
#include "core/tracking/stereo_tracker.h"
#include "core/vsystem/snapshot.h"

namespace kambara {

/// Follows the steered target in the pan-tilt camera's own picture, and makes the head's aim right
/// by it (STR-5). Its template is the operator's, or cut where the stereo pair's look of the target
/// is found in that picture, drawn as the pan-tilt camera should see it there. The head's turning
/// is known and moves the expected place. Owned and used by the pipeline's thread.
///
///   off --on--> without template --select, or found by the pair's look--> following
///                        ^                                                  |
///                        '--- another target is steered to; seen elsewhere -'
class PanTiltServo {
  public:
    PanTiltServo(const Rig& rig, const TrackerOptions& options);

    bool on() const { return on_; }
    /// Off forgets the template. An error where the rig has no pan-tilt camera.
    Result<Done> set_on(bool on);
    /// The operator's choice in a grey pan-tilt picture that was taken at the head's angles.
    Result<Done> select(const Frame& grey, const HeadAngles& angles, double magnified,
                        const Rectangle& rectangle);

    /// What a new picture shows. A picture seen already, or none, changes nothing but that what it
    /// said is older now. `stereo`: of the steered target while it is seen for sure; else null.
    struct Seen {
        const Frame& grey;
        HeadAngles angles;  ///< of the head when it was exposed
        const StereoTracker* stereo = nullptr;
        /// Number of the steered one, while it is followed.
        std::optional<int> target = std::nullopt;
        double magnified = 1.0;  ///< by the zoom, over that of the calibration
    };
    void see(const Seen& seen);

    /// The stereo pair's angles, made right by the picture.
    HeadAngles corrected(const HeadAngles& by_stereo) const;
    /// By the picture alone, for a time on the pictures' clock; empty unless the newest picture
    /// shows the target for sure.
    std::optional<ServoAim::Alone> alone(std::int64_t time_ns) const;
    /// The operator chose another thing than the stereo pair follows: the picture alone counts.
    bool apart() const { return on_ && apart_; }

    ServoSnapshot state(bool steers_alone) const;
    /// The pictures go on elsewhere.
    void wound();
    void use_rig(const Rig& rig);

  private:
    void forget();
    void note_turn(const HeadAngles& angles, std::int64_t time_ns, double magnified);
    std::optional<PatchMatch> found_by_look(const Seen& seen) const;
    void check_by_look(const Seen& seen);
    bool cut(const Frame& grey, const Rectangle& rectangle);
    bool follows() const;
    double range_mm(const Seen& seen) const;

    Rig rig_;
    TrackerOptions options_;
    bool on_ = false;
    bool apart_ = false;
    bool by_hand_ = false;
    std::optional<int> target_;
    std::unique_ptr<StereoTracker> tracker_;  // of the pan-tilt picture alone
    std::shared_ptr<VehicleTrack> turns_;     // of the head
    std::optional<HeadAngles> last_angles_;
    std::int64_t last_time_ns_ = 0;
    std::int64_t last_index_ = -1;
    int pictures_until_check_ = 0;
    bool sure_ = false;  // in the newest picture
    ServoAim aim_;
};

}  // namespace kambara
