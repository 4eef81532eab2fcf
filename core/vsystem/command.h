// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/base/angles.h"
#include "core/base/result.h"
#include "core/base/vehicle_motion.h"
#include "core/image/rectangle.h"

namespace kambara {

/// What can be asked of the vision system: the primitives of 1999 (SYS-1) as plain values, so that
/// they can come over a network as well.

/// Up to so many targets are followed at once; they have the numbers from 1 on.
inline constexpr int most_targets = 16;

/// Cuts a template from the left picture. When tracking starts on one cut from an earlier pair, the
/// pairs since then are followed first. `frame` names the pair in which the operator saw the
/// target; it must be among those still remembered. Without it, the latest pair. A `target` that
/// there is not yet is added; without one, the template is the steered target's (number 1 where
/// there is none yet).
struct SelectTemplate {
    Rectangle rectangle;
    std::optional<std::int64_t> frame;
    std::optional<int> target = std::nullopt;
    bool operator==(const SelectTemplate&) const = default;
};
/// Without a `target`: all of them.
struct StartTracking {
    std::optional<int> target = std::nullopt;
    bool operator==(const StartTracking&) const = default;
};
/// Likewise.
struct StopTracking {
    std::optional<int> target = std::nullopt;
    bool operator==(const StopTracking&) const = default;
};
/// Makes what is tracked now the new template; without a `target`, the steered one's.
struct UpdateTemplate {
    std::optional<int> target = std::nullopt;
    bool operator==(const UpdateTemplate&) const = default;
};
/// Forgets a target, or all of them. When it was the steered one, the one of lowest number that
/// remains is steered to.
struct ClearTemplate {
    std::optional<int> target = std::nullopt;
    bool operator==(const ClearTemplate&) const = default;
};
/// That target is the one from now on that the head is steered to. The first one chosen is until
/// then.
struct SteerTo {
    int target = 1;
    bool operator==(const SteerTo&) const = default;
};
/// Turns the head by hand: from then on it is no longer steered, until SteerHead says so.
struct MoveHead {
    HeadAngles angles;
    bool operator==(const MoveHead&) const = default;
};
/// Stops the head where it is, at once, and leaves it to the operator.
struct HaltHead {
    bool operator==(const HaltHead&) const = default;
};
/// Hands the head to automatic steering (true) or to the operator (false).
struct SteerHead {
    bool automatic = true;
    bool operator==(const SteerHead&) const = default;
};
/// Turns the head by hand at these speeds, right and up positive. It ends by itself when it is not
/// told again within `drive_renewal_s`: whoever holds a key or a stick tells it again and again, so
/// that the head does not run on when they are gone. Faster than the head can: as fast as it can.
struct DriveHead {
    double pan_rad_s = 0.0;
    double tilt_rad_s = 0.0;
    bool operator==(const DriveHead&) const = default;
};
inline constexpr double drive_renewal_s = 0.2;
/// Straight ahead, by hand.
struct HomeHead {
    bool operator==(const HomeHead&) const = default;
};
/// Lets the head find its home position anew, by hand.
struct ResetHead {
    bool operator==(const ResetHead&) const = default;
};
/// Turns the head by hand so that what is seen at a pixel of the pan-tilt picture comes to its
/// middle. `seen_from`: where the head looked when that picture was taken; without it, where it
/// looks now.
struct CentreHead {
    double x_px = 0.0;
    double y_px = 0.0;
    std::optional<HeadAngles> seen_from = std::nullopt;
    bool operator==(const CentreHead&) const = default;
};
/// 0 wide to 1 tele. What is about the lens leaves the steering as it is.
struct ZoomHead {
    double share = 0.0;
    bool operator==(const ZoomHead&) const = default;
};
/// 0 far to 1 near; autofocus ends with it.
struct FocusHead {
    double share = 0.0;
    bool operator==(const FocusHead&) const = default;
};
struct AutofocusHead {
    bool operator==(const AutofocusHead&) const = default;
};
/// Keeps where the head looks, and its lens, under a number from 0.
struct KeepPreset {
    int number = 0;
    bool operator==(const KeepPreset&) const = default;
};
/// Goes back to what was kept, by hand.
struct RecallPreset {
    int number = 0;
    bool operator==(const RecallPreset&) const = default;
};
/// Follows the steered target in the pan-tilt camera's own picture as well (true), which makes the
/// aim right and stands in where the stereo pair does not see the target (STR-5); or not (false).
struct ServoHead {
    bool on = true;
    bool operator==(const ServoHead&) const = default;
};
/// Cuts what is followed there from the newest pan-tilt picture; without it, it is found by what
/// the stereo pair follows. Only while that picture is followed.
struct SelectInPanTilt {
    Rectangle rectangle;
    bool operator==(const SelectInPanTilt&) const = default;
};
/// Takes the latest pictures as one view of the calibration target.
struct CaptureView {
    bool operator==(const CaptureView&) const = default;
};
/// Calibrates from the views captured so far; the result takes effect when it is accepted. `target`
/// is the short form, such as chessboard:9x6:30.
struct Calibrate {
    std::string target;
    bool operator==(const Calibrate&) const = default;
};
/// Lets the pictures flow, holds them, or takes one pair. A live source that is held loses pairs.
struct Flow {
    enum class Kind { run, pause, step };
    Kind kind = Kind::run;
    bool operator==(const Flow&) const = default;
};

/// Goes on with that frame of a recording and holds there. What was tracked is no longer followed:
/// its template stays. Live sources refuse.
struct Seek {
    std::int64_t frame = 0;
    bool operator==(const Seek&) const = default;
};
/// Remembers that pair, which must be among those still remembered, until another is held: an
/// operator may look at it for as long as it takes to choose a template.
struct HoldFrame {
    std::int64_t frame = 0;
    bool operator==(const HoldFrame&) const = default;
};

/// How the vehicle moved, from its state estimator: what is followed is expected to have moved
/// accordingly. As often as it is known, and in the order of its times.
struct TellVehicleMotion {
    VehicleMotion motion;
    bool operator==(const TellVehicleMotion&) const = default;
};

using Command = std::variant<SelectTemplate, StartTracking, StopTracking, UpdateTemplate,
                             ClearTemplate, SteerTo, MoveHead, HaltHead, SteerHead, ServoHead,
                             SelectInPanTilt, CaptureView, Calibrate, Flow, Seek, HoldFrame,
                             TellVehicleMotion, DriveHead, HomeHead, ResetHead, CentreHead,
                             ZoomHead, FocusHead, AutofocusHead, KeepPreset, RecallPreset>;

/// What a calibration came to.
struct CalibrationOutcome {
    std::string verdict;  ///< good, usable or refused
    std::vector<std::string> reasons;
    int views_used = 0;
    double stereo_rms_px = 0.0;
    double baseline_mm = 0.0;
    std::string rig_text;  ///< the rig file; empty when refused
    bool operator==(const CalibrationOutcome&) const = default;
};

using Reply = std::variant<Done, CalibrationOutcome>;

}  // namespace kambara
