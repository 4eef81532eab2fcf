// SPDX-License-Identifier: GPL-3.0-or-later
// STR-5: the target is followed in the pan-tilt camera's own picture, through the whole pipeline.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/sources/sources.h"
#include "core/pointing/aim.h"
#include "hardware/simulated/simulated_world.h"
#include "hardware/simulated/station_path.h"
#include "tests/support/stepped_run.h"

namespace kambara {
namespace {

struct Sample {
    std::int64_t frame = 0;
    double error_deg = 0.0;  // of the head's axis from the target's centre
    TrackState stereo = TrackState::idle;
    HeadAngles angles;
    HeadAngles wanted;  // by the truth
    ServoSnapshot servo;
};

// A run in step with the simulation, from the template's choice to the end.
struct Scene {
    std::string profile;
    double mount_off_deg = 0.0;          // of the rig file, about the camera's x and y axes each
    std::vector<Command> commands = {};  // before it runs
    std::function<void(VsystemInterface&, const Sample&)> each = {};
    bool select_in_pan_tilt = false;  // instead of in the left picture
};

std::vector<Sample> samples_of(const Scene& run) {
    SteadyClock clock;
    SourceOptions options;
    options.left = "sim:" + run.profile;
    options.pan_tilt_pictures = true;
    auto sources = open_sources(options, clock);
    EXPECT_TRUE(sources.ok()) << sources.error().text();
    const auto world = sources->world;
    const double off_rad = rad_from_deg(run.mount_off_deg) / std::sqrt(2.0);
    Camera& pan_tilt = *sources->parts.rig.pan_tilt;
    pan_tilt.T_camera_from_rig =
        RigidTransform{(Eigen::AngleAxisd(off_rad, Eigen::Vector3d::UnitY()) *
                        Eigen::AngleAxisd(off_rad, Eigen::Vector3d::UnitX()))
                           .toRotationMatrix(),
                       Eigen::Vector3d::Zero()} *
        pan_tilt.T_camera_from_rig;
    const auto system = testing_support::opened_in_step(std::move(sources->parts), clock);
    std::vector<Sample> samples;
    const auto look = [&](const Snapshot& snapshot) {
        if (samples.empty() || samples.back().frame != snapshot.frame) {
            const Eigen::Vector3d truth = world->T_left_from_target(snapshot.frame).t_mm;
            samples.push_back(
                {snapshot.frame,
                 deg_from_rad(aiming_error_rad(world->rig(), snapshot.head->angles, truth)),
                 steered_estimate(snapshot).state, snapshot.head->angles,
                 angles_towards(world->rig(), truth), snapshot.servo.value_or(ServoSnapshot{})});
            if (run.each) {
                run.each(*system, samples.back());
            }
        }
    };
    std::vector<Command> commands;
    if (run.select_in_pan_tilt) {
        const Rig& rig = world->rig();
        const Eigen::Vector2d at = *rig.pan_tilt->project(rig.left.T_camera_from_rig.inverse() *
                                                          world->T_left_from_target(0).t_mm);
        const Rectangle about_it{static_cast<int>(std::lround(at.x())) - 20,
                                 static_cast<int>(std::lround(at.y())) - 20, 41, 41};
        commands = {ServoHead{}, SelectInPanTilt{about_it}};
    } else {
        commands = {SelectTemplate{world->suggested_template(31), 0}};
        commands.insert(commands.end(), run.commands.begin(), run.commands.end());
        commands.push_back(StartTracking{});
    }
    testing_support::run_to_end(*system, commands, look);
    return samples;
}

// Degrees; NaN never.
struct Errors {
    double mean = 0.0;
    double worst = 0.0;
    std::size_t count = 0;
};

Errors errors_of(const std::vector<Sample>& samples,
                 const std::function<bool(const Sample&)>& counts) {
    Errors errors;
    for (const Sample& sample : samples) {
        if (counts(sample)) {
            errors.mean += sample.error_deg;
            errors.worst = std::max(errors.worst, sample.error_deg);
            ++errors.count;
        }
    }
    errors.mean /= static_cast<double>(std::max<std::size_t>(1, errors.count));
    return errors;
}

// Where the target stands still, within the head's reach, and has done so for some frames.
bool settled_on_station(const Sample& sample) {
    constexpr double rate_hz = 30.0;
    const double time_s = static_cast<double>(sample.frame) / rate_hz;
    const bool still =
        station_path::station_at(time_s) >= 0 &&
        station_path::station_at(time_s - 5.0 / rate_hz) == station_path::station_at(time_s);
    const bool reached = std::abs(deg_from_rad(sample.wanted.tilt_rad)) < 24.5;
    return sample.frame > 30 && still && reached;
}

TEST(PanTiltServoSlow, AWrongMountIsMadeUpForInThePicture) {
    const std::string profile = "stations?frames=360";
    const Errors by_pair = errors_of(samples_of({profile, 1.0}), settled_on_station);
    const Errors with = errors_of(samples_of({profile, 1.0, {ServoHead{}}}), settled_on_station);
    std::printf(
        "mount 1 degree off, %zu frames: stereo aim alone %.2f degrees off (worst %.2f), "
        "with the pan-tilt picture %.2f (worst %.2f)\n",
        with.count, by_pair.mean, by_pair.worst, with.mean, with.worst);
    EXPECT_GT(with.count, 20U);
    EXPECT_GT(by_pair.mean, 0.8);
    EXPECT_LE(with.worst, 0.2);
}

TEST(PanTiltServoSlow, ATargetThatMovesIsCentredAsWithARightMount) {
    const std::string profile = "default?frames=300";
    const auto later = [](const Sample& sample) { return sample.frame > 30; };
    const Errors right = errors_of(samples_of({profile}), later);
    const Errors wrong = errors_of(samples_of({profile, 1.0}), later);
    const Errors with = errors_of(samples_of({profile, 1.0, {ServoHead{}}}), later);
    std::printf(
        "moving target: mount right %.2f degrees (worst %.2f), mount 1 degree off %.2f "
        "(%.2f), with the pan-tilt picture %.2f (%.2f)\n",
        right.mean, right.worst, wrong.mean, wrong.worst, with.mean, with.worst);
    EXPECT_GT(wrong.mean, 0.8);
    EXPECT_LE(with.mean, right.mean + 0.05);
    EXPECT_LE(with.worst, right.worst + 0.3);
}

// As above through a lens that enlarges twice and four fifths.
TEST(PanTiltServoSlow, AWrongMountIsMadeUpForZoomedIn) {
    const std::string profile = "stations?frames=360";
    const std::vector<Command> zoomed_in{ServoHead{}, ZoomHead{0.41}};
    const Errors by_pair =
        errors_of(samples_of({profile, 1.0, {ZoomHead{0.41}}}), settled_on_station);
    const Errors with = errors_of(samples_of({profile, 1.0, zoomed_in}), settled_on_station);
    std::printf(
        "zoomed in 2.8 times, mount 1 degree off, %zu frames: stereo aim alone %.2f degrees off "
        "(worst %.2f), with the pan-tilt picture %.2f (worst %.2f)\n",
        with.count, by_pair.mean, by_pair.worst, with.mean, with.worst);
    EXPECT_GT(with.count, 20U);
    EXPECT_GT(by_pair.mean, 0.8);
    EXPECT_LE(with.worst, 0.2);
}

// The vehicle swings so far that the target leaves the fixed cameras' pictures.
TEST(PanTiltServoSlow, FollowsAloneWhereTheStereoPairDoesNotSeeTheTarget) {
    const std::string profile = "default?frames=240&turn=72&swing=5";
    const auto unseen = [](const Sample& sample) {
        return sample.frame > 30 && sample.stereo != TrackState::tracking;
    };
    const auto pair_only = samples_of({profile});
    const auto with = samples_of({profile, 0.0, {ServoHead{}}});
    const Errors lost = errors_of(pair_only, unseen);
    const Errors kept = errors_of(with, unseen);
    const auto alone = std::count_if(with.begin(), with.end(),
                                     [](const Sample& sample) { return sample.servo.alone; });
    std::printf(
        "of %zu frames the pair does not see the target in %zu: the head is off by %.1f "
        "degrees then (worst %.1f), with the pan-tilt picture in %zu frames by %.1f "
        "(%.1f); alone in %ld\n",
        with.size(), lost.count, lost.mean, lost.worst, kept.count, kept.mean, kept.worst,
        static_cast<long>(alone));
    EXPECT_GT(lost.count, 30U);
    EXPECT_GT(alone, 30);
    EXPECT_GT(lost.worst, 10.0);
    EXPECT_LE(kept.worst, 5.0);
}

// No stereo target: what the operator chose in the pan-tilt picture is followed; when the head has
// been turned away from it, it stays where it is, whatever else it sees.
TEST(PanTiltServoSlow, FollowsTheOperatorsChoiceAndRestsWhenItIsLost) {
    constexpr std::int64_t by_hand_at = 60;
    constexpr std::int64_t automatic_at = 110;
    Scene scene{"default?frames=200"};
    scene.select_in_pan_tilt = true;
    scene.each = [&](VsystemInterface& system, const Sample& sample) {
        if (sample.frame == by_hand_at) {
            EXPECT_TRUE(system.execute(MoveHead{{rad_from_deg(-90.0), 0.0}}));
        } else if (sample.frame == automatic_at) {
            EXPECT_TRUE(system.execute(SteerHead{true}));
        }
    };
    const auto samples = samples_of(scene);
    ASSERT_EQ(samples.size(), 200U);
    const Errors followed = errors_of(samples, [](const Sample& sample) {
        return sample.frame > 20 && sample.frame < by_hand_at;
    });
    double moved_deg = 0.0;
    int doubtful = 0;
    for (const Sample& sample : samples) {
        if (sample.frame > automatic_at) {
            const HeadAngles& then = samples[static_cast<std::size_t>(automatic_at)].angles;
            moved_deg =
                std::max({moved_deg, deg_from_rad(std::abs(sample.angles.pan_rad - then.pan_rad)),
                          deg_from_rad(std::abs(sample.angles.tilt_rad - then.tilt_rad))});
            doubtful += sample.servo.state != TrackState::tracking ? 1 : 0;
        }
    }
    std::printf(
        "alone: %.2f degrees off (worst %.2f); lost in %d of 89 frames, the head moved by "
        "%.2f degrees\n",
        followed.mean, followed.worst, doubtful, moved_deg);
    EXPECT_LE(followed.mean, 0.5);
    EXPECT_LE(followed.worst, 1.0);
    EXPECT_EQ(doubtful, 89);
    EXPECT_EQ(moved_deg, 0.0);
}

TEST(PanTiltServo, IsRefusedWithoutPictures) {
    SteadyClock clock;
    SourceOptions options;
    options.left = "sim:default?frames=3";
    auto sources = open_sources(options, clock);
    ASSERT_TRUE(sources.ok());
    const auto system = testing_support::opened_in_step(std::move(sources->parts), clock);
    ASSERT_TRUE(system);
    const auto on = system->execute(ServoHead{});
    ASSERT_FALSE(on.ok());
    EXPECT_NE(on.error().cause.find("no pictures of the pan-tilt camera"), std::string::npos);
    const auto select = system->execute(SelectInPanTilt{{10, 10, 31, 31}});
    ASSERT_FALSE(select.ok());
    EXPECT_NE(select.error().cause.find("is not followed"), std::string::npos);
    EXPECT_FALSE(system->latest()->servo);
}

}  // namespace
}  // namespace kambara
