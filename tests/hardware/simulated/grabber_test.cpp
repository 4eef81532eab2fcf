// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/simulated_grabber.h"

#include <gtest/gtest.h>

#include <string>

#include "core/base/angles.h"

namespace kambara {
namespace {

std::shared_ptr<const SimulatedWorld> world_of(const char* profile) {
    return std::make_shared<const SimulatedWorld>(simulated_profile(profile).value());
}

Frame next(GrabberBase& grabber) {
    return grabber.grab({}).value().value();
}

TEST(SimulatedGrabber, DrivesTheClockThroughEveryFrameToTheEnd) {
    const auto world = world_of("default?frames=20&particles=0");
    const auto clock = std::make_shared<ManualClock>();
    const auto grabber = make_simulated_grabber(world, FixedCamera::right, 0, {nullptr, 0, clock});
    EXPECT_FALSE(grabber->info().live);
    EXPECT_EQ(grabber->info().rate_hz, 30.0);
    EXPECT_EQ(grabber->info().width_px, 640);
    for (std::int64_t i = 0; i < 20; ++i) {
        const Frame frame = next(*grabber);
        EXPECT_EQ(frame.index, i);
        EXPECT_TRUE(frame.valid);
        EXPECT_EQ(frame.time_ns, (i * 1'000'000'000 + 15) / 30);
        EXPECT_EQ(clock->now_ns(), frame.time_ns);
        // The device's counter passes its last value on the way.
        EXPECT_EQ(frame.sequence,
                  static_cast<std::uint32_t>(0xFFFFFFF0ULL + static_cast<std::uint64_t>(i)));
        if (i == 17) {
            EXPECT_EQ(*frame.picture, world->picture(FixedCamera::right, 17));
            EXPECT_EQ(frame.sequence, 1U);
        }
    }
    EXPECT_FALSE(grabber->grab({}).value());
    EXPECT_FALSE(grabber->grab({}).value()) << "it stays at its end";
}

TEST(SimulatedGrabber, LiveFramesComeInTheirTimeAndWhoIsLateGetsTheNewest) {
    const auto world = world_of("default?particles=0");
    constexpr std::int64_t start_ns = 5'000'000'000;
    ManualClock clock(start_ns);
    const auto grabber =
        make_simulated_grabber(world, FixedCamera::left, 0, {&clock, start_ns, nullptr});
    EXPECT_TRUE(grabber->info().live);
    EXPECT_EQ(next(*grabber).index, 0);
    // Exactly at a frame's time that frame is the newest, whatever the rounding of its time.
    for (const std::int64_t newest : {7, 8, 31, 100}) {
        clock.set_ns(start_ns + world->time_ns(newest));
        const Frame frame = next(*grabber);
        EXPECT_EQ(frame.index, newest);
        EXPECT_EQ(frame.time_ns, world->time_ns(newest));
        EXPECT_EQ(frame.sequence, 0xFFFFFFF0U + static_cast<std::uint32_t>(newest));
    }
    clock.set_ns(start_ns + world->time_ns(200) - 1);
    EXPECT_EQ(next(*grabber).index, 199);
}

TEST(SimulatedGrabber, AWaitForALiveFrameEndsWithTheStop) {
    const auto world = world_of("default?particles=0");
    ManualClock clock;
    const auto grabber = make_simulated_grabber(world, FixedCamera::left, 3, {&clock, 0, nullptr});
    std::stop_source stop;
    stop.request_stop();
    EXPECT_FALSE(grabber->grab(stop.get_token()).value());
    clock.set_ns(world->time_ns(3));
    EXPECT_EQ(next(*grabber).index, 3) << "a stop takes no frame away";
}

// Answers once, not the next time, and then again.
class UnpluggedHead final : public PanTiltCamera {
  public:
    std::string name() const override { return "unplugged"; }
    HeadLimits limits() const override { return {}; }
    Result<Done> move_to(const HeadAngles&) override { return failure(); }
    Result<Done> halt() override { return failure(); }
    Result<HeadStatus> status() override {
        if (asked_++ != 1) {
            return HeadStatus{{rad_from_deg(20.0), rad_from_deg(-5.0)}, false, 0};
        }
        return failure();
    }

  private:
    static Error failure() { return {"The head does not answer.", "Check its cable."}; }
    int asked_ = 0;
};

TEST(SimulatedGrabber, ThePanTiltCameraLooksWhereTheHeadDoes) {
    const auto world = world_of("default?particles=0");
    const auto grabber = make_simulated_grabber(world, std::make_shared<UnpluggedHead>(), 4, {});
    EXPECT_EQ(*next(*grabber).picture,
              world->pan_tilt_picture(4, {rad_from_deg(20.0), rad_from_deg(-5.0)}));
    const Frame without = next(*grabber);
    EXPECT_FALSE(without.valid);
    EXPECT_EQ(without.picture, nullptr);
    const Frame after = next(*grabber);
    EXPECT_TRUE(after.valid) << "the head answers again";
    EXPECT_EQ(after.index, 6);
}

}  // namespace
}  // namespace kambara
