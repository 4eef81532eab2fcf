// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/sources.h"

#include <string_view>
#include <utility>

#include "app/sources/heads.h"
#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "hardware/media/open_media.h"
#include "hardware/media/picture_file.h"
#include "hardware/media/picture_pairs.h"
#include "hardware/simulated/held_target.h"
#include "hardware/simulated/simulated_grabber.h"
#include "hardware/simulated/simulated_head.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

constexpr std::string_view simulated = "sim:";

bool is_simulated(const std::string& source) {
    return source.starts_with(simulated);
}

Error no_such_head(const std::string& name) {
    return {"There is no driver for the pan-tilt head " + name + ".",
            "Give sim:default for a simulated one, visca:/dev/ttyS0 or visca-udp:HOST for a real "
            "one, or leave it out."};
}

// The real head that the options ask for; null where they ask for none.
Result<std::shared_ptr<PanTiltCamera>> real_head(const SourceOptions& options, const Clock& clock) {
    if (options.head || !names_a_real_head(options.pan_tilt)) {
        return std::shared_ptr<PanTiltCamera>(options.head);
    }
    return open_head(options.pan_tilt, clock);
}

// A name that means a device or a stream, for which there is no driver.
bool names_a_device(const std::string& source) {
    return source.starts_with("v4l2:") || source.starts_with("gst:") || source.starts_with("rtsp:");
}

// A clock that begins at zero when the simulation does.
class ClockFrom final : public Clock {
  public:
    ClockFrom(Clock& clock, std::int64_t start_ns) : clock_(clock), start_ns_(start_ns) {}
    std::int64_t now_ns() const override { return clock_.now_ns() - start_ns_; }
    bool sleep_until_ns(std::int64_t time_ns, std::stop_token stop) override {
        return clock_.sleep_until_ns(time_ns + start_ns_, stop);
    }

  private:
    Clock& clock_;
    const std::int64_t start_ns_;
};

Result<Sources> open_simulation(const SourceOptions& options, Clock& clock) {
    if (!options.right.empty() && options.right != options.left) {
        return Error{"The left pictures come from " + options.left + ", the right ones from " +
                         options.right + ".",
                     "Leave --right out: the simulated rig has both."};
    }
    const bool wants_real_head = options.head || names_a_real_head(options.pan_tilt);
    if (!options.pan_tilt.empty() && !is_simulated(options.pan_tilt) && !wants_real_head) {
        return no_such_head(options.pan_tilt);
    }
    if (wants_real_head && !options.live) {
        return Error{"A simulation that runs as fast as it can is too fast for a real head.",
                     "Use the command live, or the window."};
    }
    auto profile = simulated_profile(std::string_view(options.left).substr(simulated.size()));
    if (!profile) {
        return profile.error();
    }
    if (profile->frames >= 0 && options.start >= profile->frames) {
        return Error{"Frame " + std::to_string(options.start) + " does not exist: " + options.left +
                         " has " + std::to_string(profile->frames) + " frames.",
                     "Start earlier."};
    }
    Sources sources;
    if (options.live && profile->calibration_target) {
        HeldTarget::Options how;
        how.seed = profile->seed;
        sources.hand = std::make_shared<HeldTarget>(how);
    }
    auto world = std::make_shared<const SimulatedWorld>(*profile, sources.hand);
    sources.world = world;
    sources.every_frame = !options.live;
    sources.parts.rig = world->rig();
    sources.parts.rig.provenance.stereo_rms_px = 0.0;  // the simulated cameras are as told
    sources.parts.vehicle = make_simulated_feed(*profile);
    SimulatedPace pace;
    std::shared_ptr<const Clock> head_clock;
    if (options.live) {
        pace.clock = &clock;
        pace.start_ns = clock.now_ns();
        head_clock = std::make_shared<ClockFrom>(clock, pace.start_ns);
    } else {
        pace.driven = std::make_shared<ManualClock>();
        head_clock = pace.driven;
    }
    auto opened = real_head(options, clock);
    if (!opened) {
        return opened.error();
    }
    sources.real_head = *opened != nullptr;
    SimulatedHead::Options of_head;
    of_head.backlash = profile->head_backlash;
    const std::shared_ptr<PanTiltCamera> head =
        *opened ? *opened : std::make_shared<SimulatedHead>(head_clock, of_head);
    sources.parts.head = head;
    Grabbers& grabbers = sources.parts.grabbers;
    grabbers.left = make_simulated_grabber(world, FixedCamera::left, options.start, pace);
    grabbers.right = make_simulated_grabber(world, FixedCamera::right, options.start, pace);
    if (options.pan_tilt_pictures) {
        // Its whole picture changes with every move of the head and is drawn anew each time: live,
        // every other frame leaves the machine to the tracking.
        pace.every = options.live ? 2 : 1;
        grabbers.pan_tilt = make_simulated_grabber(world, head, options.start, pace);
    }
    return sources;
}

Result<Sources> open_recordings(const SourceOptions& options) {
    const MediaOptions media{options.start, options.pictures_rate_hz};
    for (const std::string& source : {options.left, options.right}) {
        if (names_a_device(source)) {
            return Error{"There is no driver for the source " + source + ".",
                         "Give a video file, a pattern of pictures, or sim:default."};
        }
    }
    Sources sources;
    auto left = open_media(options.left, media);
    if (!left) {
        return left.error();
    }
    sources.parts.grabbers.left = std::move(*left);
    if (!options.right.empty()) {
        auto right = open_media(options.right, media);
        if (!right) {
            return right.error();
        }
        sources.parts.grabbers.right = std::move(*right);
        const auto lefts = files_of_pattern(options.left);
        const auto rights = files_of_pattern(options.right);
        if (lefts && rights && lefts->size() > 1) {  // two videos are a pair by their place
            if (const auto pairs = check_pairs(*lefts, *rights); !pairs) {
                return pairs.error();
            }
        }
    }
    return sources;
}

// A simulated head beside recorded pictures: it moves by their time stamps, which it is told as
// frames are taken.
class TimedGrabber final : public GrabberBase {
  public:
    TimedGrabber(std::unique_ptr<GrabberBase> grabber, std::shared_ptr<ManualClock> time)
        : grabber_(std::move(grabber)), time_(std::move(time)) {}

    Result<std::optional<Frame>> grab(std::stop_token stop) override {
        auto frame = grabber_->grab(stop);
        if (frame && *frame) {
            time_->set_ns((*frame)->time_ns);
        }
        return frame;
    }
    GrabberInfo info() const override { return grabber_->info(); }
    Result<Done> seek(std::int64_t index) override { return grabber_->seek(index); }

  private:
    std::unique_ptr<GrabberBase> grabber_;
    std::shared_ptr<ManualClock> time_;
};

Result<Done> add_head(const SourceOptions& options, const Clock& clock, Sources& sources) {
    const bool wants_real_head = options.head || names_a_real_head(options.pan_tilt);
    if (!is_simulated(options.pan_tilt) && !wants_real_head) {
        return no_such_head(options.pan_tilt);
    }
    if (!sources.parts.rig.pan_tilt) {
        return Error{"The rig file does not say where the pan-tilt camera is.",
                     "Add cameras.pan_tilt to it, or leave --pan-tilt out."};
    }
    if (wants_real_head) {
        auto opened = real_head(options, clock);
        if (!opened) {
            return opened.error();
        }
        sources.parts.head = std::move(*opened);
        sources.real_head = true;
        return Done{};
    }
    auto time = std::make_shared<ManualClock>();
    sources.parts.grabbers.left =
        std::make_unique<TimedGrabber>(std::move(sources.parts.grabbers.left), time);
    sources.parts.head = std::make_shared<SimulatedHead>(time);
    return Done{};
}

}  // namespace

Result<Sources> open_sources(const SourceOptions& options, Clock& clock) {
    const bool simulation = is_simulated(options.left);
    if (!simulation && is_simulated(options.right)) {
        return Error{"The right pictures are simulated, the left ones are not.",
                     "Give both from the same kind of source."};
    }
    if (options.rig.empty() && !simulation && !options.right.empty()) {
        return Error{"There is no rig file.", "Name one with --rig."};
    }
    std::optional<Rig> rig;
    if (!options.rig.empty()) {
        auto read = read_rig_file(options.rig);
        if (!read) {
            return read.error();
        }
        rig = std::move(*read);
    }
    auto sources = simulation ? open_simulation(options, clock) : open_recordings(options);
    if (!sources) {
        return sources;
    }
    if (rig) {
        sources->parts.rig = std::move(*rig);
    } else if (!simulation) {
        const GrabberInfo info = sources->parts.grabbers.left->info();
        sources->parts.rig = unknown_camera(info.width_px, info.height_px);
    }
    if (!simulation && (!options.pan_tilt.empty() || options.head)) {
        if (const auto added = add_head(options, clock, *sources); !added) {
            return added.error();
        }
    }
    return sources;
}

}  // namespace kambara
