// SPDX-License-Identifier: GPL-3.0-or-later
// What the head is told, and what it does: its state, steering handed over and taken away, the head
// by hand. What turns it takes it away from steering, until SteerHead hands it back; what is about
// its lens does not.
#include <algorithm>
#include <cmath>
#include <string>

#include "core/pointing/aim.h"
#include "core/pointing/pan_tilt_view.h"
#include "core/vsystem/pipeline.h"

namespace kambara {
namespace {

// Only where a head model has lever arms does it matter how far away the thing is.
constexpr double centred_range_mm = 2000.0;

Error no_head() {
    return {"There is no pan-tilt head.", "Connect one, or name it when starting."};
}

Result<Done> unless(bool able, const char* what) {
    if (able) {
        return Done{};
    }
    return Error{std::string("The head ") + what + ".", "Use another head."};
}

Result<Done> is_share(double share) {
    if (share >= 0.0 && share <= 1.0) {
        return Done{};
    }
    return Error{"The lens can't be set to " + std::to_string(share) + ".",
                 "Give a number from 0 to 1."};
}

Result<Done> is_preset(int number, const HeadAbilities& abilities) {
    if (number >= 0 && number < abilities.presets) {
        return Done{};
    }
    if (abilities.presets == 0) {
        return unless(false, "has no presets");
    }
    return Error{"There is no preset " + std::to_string(number) + ".",
                 "Give a number from 0 to " + std::to_string(abilities.presets - 1) + "."};
}

struct TurnCheck {
    const HeadAbilities& abilities;
    Result<Done> operator()(const HomeHead&) { return Done{}; }
    Result<Done> operator()(const ResetHead&) { return unless(abilities.reset, "can't be reset"); }
    Result<Done> operator()(const RecallPreset& c) { return is_preset(c.number, abilities); }
};

struct SettingCheck {
    const HeadAbilities& abilities;
    Result<Done> operator()(const ZoomHead& c) {
        const auto able = unless(abilities.zoom, "has no zoom");
        return able ? is_share(c.share) : able;
    }
    Result<Done> operator()(const FocusHead& c) {
        const auto able = unless(abilities.focus, "has no focus");
        return able ? is_share(c.share) : able;
    }
    Result<Done> operator()(const AutofocusHead&) {
        return unless(abilities.autofocus, "has no autofocus");
    }
    Result<Done> operator()(const KeepPreset& c) { return is_preset(c.number, abilities); }
};

}  // namespace

// A scatter below nothing is none.
void Pipeline::tell_backlash() {
    if (head_) {
        const HeadModel model = rig_.head.value_or(HeadModel{});
        head_->use_backlash(
            {std::max(0.0, model.pan_backlash_rad), std::max(0.0, model.tilt_backlash_rad)});
    }
}

void Pipeline::announce_head() {
    for (const HeadNote& note : head_->take_notes()) {
        switch (note.kind) {
            case HeadNote::Kind::note:
                announce(Event::Kind::note, note.text);
                break;
            case HeadNote::Kind::warning:
                announce(Event::Kind::warning, note.text);
                break;
            case HeadNote::Kind::fault:
                announce(Event::Kind::fault, note.text);
        }
    }
}

HeadSnapshot Pipeline::head_now() {
    const auto reading = head_->reading();
    return {reading.status.angles, commanded_,    reading.status.moving, steering_.automatic(),
            steering_.at_limit(),  reading.fault, reading.lens,          reading.abilities,
            head_->limits(),       reading.axes};
}

void Pipeline::watch_head() {
    if (!head_ || !images_.stereo.left.picture) {
        return;
    }
    announce_head();
    if (head_now() != head_told_) {
        publish();
    }
}

void Pipeline::take_by_hand(const std::optional<HeadAngles>& commanded) {
    steering_.set_automatic(false);
    steering_.nothing_wanted();
    commanded_ = commanded;
    // By hand the encoders are told; where that leaves the axes is not steering's last word.
    aimed_ = rig_.head ? std::nullopt : commanded;
    publish();
}

Result<Reply> Pipeline::move_head(const MoveHead& command) {
    if (!head_) {
        return no_head();
    }
    const HeadLimits limits = head_->limits();
    if (within_limits(command.angles, limits) != command.angles) {
        return Error{"The head can't look there: it reaches " +
                         std::to_string(deg_from_rad(limits.pan_rad)) +
                         " degrees to the sides and " +
                         std::to_string(deg_from_rad(limits.tilt_rad)) + " up and down.",
                     "Give angles within these limits."};
    }
    head_->command(command.angles, true);
    take_by_hand(command.angles);
    return Reply(Done{});
}

Result<Reply> Pipeline::halt_head() {
    if (!head_) {
        return no_head();
    }
    head_->halt();
    take_by_hand(std::nullopt);
    return Reply(Done{});
}

Result<Reply> Pipeline::steer_head(const SteerHead& command) {
    if (!head_) {
        return no_head();
    }
    if (command.automatic && !rig_.pan_tilt) {
        return Error{"The rig file does not say where the pan-tilt camera is.",
                     "Calibrate it with the others, then hand over the steering."};
    }
    if (command.automatic) {
        head_->end_drive();
    } else {
        steering_.nothing_wanted();
    }
    steering_.set_automatic(command.automatic);
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::servo_head(const ServoHead& command) {
    if (command.on && !head_) {
        return no_head();
    }
    if (command.on && !images_.pan_tilt.picture) {
        return Error{"There are no pictures of the pan-tilt camera.",
                     "Connect it, or name it when starting."};
    }
    if (const auto done = servo_.set_on(command.on); !done) {
        return done.error();
    }
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::select_in_pan_tilt(const SelectInPanTilt& command) {
    if (!servo_.on() || !head_ || !images_.pan_tilt.picture) {
        return Error{"The pan-tilt picture is not followed.", "Switch that on first."};
    }
    const auto angles = angles_of_pan_tilt_picture();
    if (!angles) {
        return Error{"The head does not say where it looks.", "Check its line and its power."};
    }
    pan_tilt_grey_ = images_.pan_tilt;
    pan_tilt_grey_.picture = grey_from(pan_tilt_grey_.picture);
    if (const auto done =
            servo_.select(pan_tilt_grey_, *angles, magnified_now(), command.rectangle);
        !done) {
        return done.error();
    }
    look_through_head();
    steer();
    publish();
    return Reply(Done{});
}

Result<Reply> Pipeline::drive_head(const DriveHead& command) {
    if (!head_) {
        return no_head();
    }
    if (!std::isfinite(command.pan_rad_s) || !std::isfinite(command.tilt_rad_s)) {
        return Error{"The head can't turn at such a speed.", "Give numbers."};
    }
    const auto able = unless(head_->reading().abilities.drive, "can't be turned at a speed");
    if (!able) {
        return able.error();
    }
    const HeadLimits most = head_->limits();
    head_->drive({std::clamp(command.pan_rad_s, -most.pan_speed_rad_s, most.pan_speed_rad_s),
                  std::clamp(command.tilt_rad_s, -most.tilt_speed_rad_s, most.tilt_speed_rad_s)});
    if (steering_.automatic() || commanded_) {  // told again and again, it changes nothing more
        take_by_hand(std::nullopt);
    }
    return Reply(Done{});
}

Result<Reply> Pipeline::centre_head(const CentreHead& command) {
    if (!head_) {
        return no_head();
    }
    if (!rig_.pan_tilt) {
        return Error{"The rig file does not say where the pan-tilt camera is.",
                     "Calibrate it with the others first."};
    }
    const auto reading = head_->reading();
    const auto angles =
        angles_to_centre(rig_, head_->axes_at(command.seen_from.value_or(reading.status.angles)),
                         {command.x_px, command.y_px}, centred_range_mm, magnified_now());
    if (!angles) {
        return Error{"Nothing is seen at that place of the pan-tilt picture.",
                     "Choose one nearer to its middle."};
    }
    // What is seen may be beyond what the head can be turned to: it goes as far as it can.
    const HeadAngles nearest = head_->encoders_for(*angles);
    head_->command(nearest, true);
    take_by_hand(nearest);
    return Reply(Done{});
}

Result<Reply> Pipeline::turn_head(const HeadWorker::Turn& command) {
    if (!head_) {
        return no_head();
    }
    const HeadAbilities abilities = head_->reading().abilities;
    if (const auto possible = std::visit(TurnCheck{abilities}, command); !possible) {
        return possible.error();
    }
    head_->turn(command);
    take_by_hand(std::holds_alternative<HomeHead>(command) ? std::optional(HeadAngles{})
                                                           : std::nullopt);
    return Reply(Done{});
}

Result<Reply> Pipeline::set_head(const HeadWorker::Setting& command) {
    if (!head_) {
        return no_head();
    }
    const HeadAbilities abilities = head_->reading().abilities;
    if (const auto possible = std::visit(SettingCheck{abilities}, command); !possible) {
        return possible.error();
    }
    head_->set(command);
    publish();
    return Reply(Done{});
}

}  // namespace kambara
