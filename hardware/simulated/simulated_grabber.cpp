// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_grabber.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "hardware/simulated/simulated_head.h"

namespace kambara {
namespace {

constexpr std::uint32_t first_sequence = 0xFFFFFFF0U;

class SimulatedGrabber final : public GrabberBase {
  public:
    /// Empty: there is no picture of that moment, though there may be of later ones.
    using Draw = std::function<std::optional<Image>(std::int64_t frame)>;

    SimulatedGrabber(std::shared_ptr<const SimulatedWorld> world, GrabberInfo info, Draw draw,
                     std::int64_t start, const SimulatedPace& pace)
        : world_(std::move(world)),
          info_(std::move(info)),
          draw_(std::move(draw)),
          pace_(pace),
          next_(start) {}

    Result<std::optional<Frame>> grab(std::stop_token stop) override {
        if (pace_.clock != nullptr) {
            const std::int64_t now_ns = pace_.clock->now_ns() - pace_.start_ns;
            auto newest =
                static_cast<std::int64_t>(static_cast<double>(now_ns) * 1e-9 * info_.rate_hz);
            // Frames' times are rounded to nanoseconds, so the quotient may be just short of one.
            if (world_->time_ns(newest + 1) <= now_ns) {
                ++newest;
            }
            next_ = std::max(next_, newest);
            next_ += (pace_.every - next_ % pace_.every) % pace_.every;
        }
        const std::int64_t frames = world_->profile().frames;
        if (stop.stop_requested() || (frames >= 0 && next_ >= frames)) {
            return std::optional<Frame>();
        }
        const std::int64_t time_ns = world_->time_ns(next_);
        if (pace_.clock != nullptr &&
            !pace_.clock->sleep_until_ns(pace_.start_ns + time_ns, stop)) {
            return std::optional<Frame>();
        }
        if (pace_.driven) {
            pace_.driven->set_ns(time_ns);
        }
        auto picture = draw_(next_);
        Frame frame;
        frame.valid = picture.has_value();
        if (picture) {
            frame.picture = std::make_shared<const Image>(std::move(*picture));
        }
        frame.time_ns = time_ns;
        frame.index = next_;
        frame.sequence = first_sequence + static_cast<std::uint32_t>(next_);
        ++next_;
        return std::optional<Frame>(std::move(frame));
    }

    GrabberInfo info() const override { return info_; }

  private:
    const std::shared_ptr<const SimulatedWorld> world_;
    const GrabberInfo info_;
    const Draw draw_;
    const SimulatedPace pace_;
    std::int64_t next_;
};

GrabberInfo info_of(const SimulatedWorld& world, const Camera& camera, const char* which,
                    const SimulatedPace& pace) {
    return {"sim:" + world.profile().name + " " + which, camera.width_px, camera.height_px,
            world.profile().rate_hz, pace.clock != nullptr};
}

}  // namespace

std::unique_ptr<GrabberBase> make_simulated_grabber(
    const std::shared_ptr<const SimulatedWorld>& world, FixedCamera camera, std::int64_t start,
    const SimulatedPace& pace) {
    const bool left = camera == FixedCamera::left;
    const Camera& lens = left ? world->rig().left : *world->rig().right;
    auto info = info_of(*world, lens, left ? "left" : "right", pace);
    auto draw = [world, camera](std::int64_t frame) -> std::optional<Image> {
        return world->picture(camera, frame);
    };
    return std::make_unique<SimulatedGrabber>(world, std::move(info), std::move(draw), start, pace);
}

std::unique_ptr<GrabberBase> make_simulated_grabber(
    const std::shared_ptr<const SimulatedWorld>& world, std::shared_ptr<PanTiltCamera> head,
    std::int64_t start, const SimulatedPace& pace) {
    auto info = info_of(*world, *world->rig().pan_tilt, "pan-tilt", pace);
    const auto simulated = std::dynamic_pointer_cast<SimulatedHead>(head);
    auto draw = [world, head = std::move(head),
                 simulated](std::int64_t frame) -> std::optional<Image> {
        const auto status = head->status();
        if (!status) {
            return std::nullopt;  // an unplugged head is plugged in again
        }
        const auto lens = head->lens();
        return world->pan_tilt_picture(frame, simulated ? simulated->axes() : status->angles,
                                       lens ? lens->magnification() : 1.0);
    };
    return std::make_unique<SimulatedGrabber>(world, std::move(info), std::move(draw), start, pace);
}

}  // namespace kambara
