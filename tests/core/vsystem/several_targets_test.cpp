// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "core/vsystem/serialise.h"
#include "core/vsystem/vision_system.h"
#include "tests/support/instant_head.h"
#include "tests/support/list_grabber.h"
#include "tests/support/textured_plane.h"
#include "tests/support/wait_for_snapshot.h"

namespace kambara {
namespace {

using testing_support::InstantHead;
using testing_support::ListGrabber;
using testing_support::run_out;
using testing_support::TexturedPlane;

constexpr int pairs = 4;

// A plane that drifts across both pictures; drawn once for all tests.
const std::vector<StereoFrame>& recording() {
    static const std::vector<StereoFrame> drawn = [] {
        std::vector<StereoFrame> frames;
        for (int i = 0; i < pairs; ++i) {
            const TexturedPlane plane{{8.0 * i, 5.0 * i, 1400.0}};
            frames.push_back(testing_support::drawn_pair(plane, nominal_rig(), i));
        }
        return frames;
    }();
    return drawn;
}

// Sixteen places that both cameras see and the head reaches, a number from 1 on each.
Rectangle place(int id) {
    return {250 + 50 * ((id - 1) % 4), 240 + 50 * ((id - 1) / 4), 25, 25};
}

Eigen::Vector2d centre(const Rectangle& rectangle) {
    return {rectangle.centre_x_px(), rectangle.centre_y_px()};
}

// What a snapshot says, but for the time that it took.
std::string untimed(Snapshot snapshot) {
    snapshot.rate_hz = snapshot.processing_ms = snapshot.latency_ms = 0.0;
    return to_json(snapshot);
}

class SeveralTargets : public testing::Test {
  protected:
    std::unique_ptr<VsystemInterface> open(int threads = 0) {
        std::vector<Frame> lefts;
        std::vector<Frame> rights;
        for (const StereoFrame& pair : recording()) {
            lefts.push_back(pair.left);
            rights.push_back(pair.right);
        }
        VisionSystemParts parts{nominal_rig(), {}, std::make_shared<InstantHead>()};
        parts.grabbers.left = std::make_unique<ListGrabber>(lefts, 640, 480);
        parts.grabbers.right = std::make_unique<ListGrabber>(rights, 640, 480);
        VisionSystemOptions options;
        options.threads = threads;
        options.every_frame = true;
        options.start_paused = true;
        auto system = open_vision_system(std::move(parts), options, clock_);
        watch_ = (*system)->observe_events([this](const Event& e) { events_.push_back(e.text); });
        return std::move(*system);
    }

    std::unique_ptr<VsystemInterface> open_with(const std::vector<int>& ids, int threads = 0) {
        auto system = open(threads);
        for (const int id : ids) {
            const auto done = system->execute(SelectTemplate{place(id), std::nullopt, id});
            EXPECT_TRUE(done) << done.error().text();
        }
        return system;
    }

    static std::vector<int> ids_of(const VsystemInterface& system) {
        std::vector<int> ids;
        for (const TrackSnapshot& track : system.latest()->tracks) {
            ids.push_back(track.id);
        }
        return ids;
    }

    static bool looks_at(const VsystemInterface& system, int id) {
        const auto snapshot = system.latest();
        for (const TrackSnapshot& track : snapshot->tracks) {
            if (track.id == id && track.estimate.position) {
                return aiming_error_rad(system.rig(), snapshot->head->angles,
                                        track.estimate.position->point_in_left_mm) <
                       rad_from_deg(0.2);
            }
        }
        return false;
    }

    bool heard(const std::string& text) const {
        return std::find(events_.begin(), events_.end(), text) != events_.end();
    }

    SteadyClock clock_;
    std::vector<std::string> events_;
    std::unique_ptr<Observation> watch_;
};

TEST_F(SeveralTargets, AreFollowedAndListedByNumber) {
    auto system = open_with({1, 9, 4});
    EXPECT_EQ(ids_of(*system), (std::vector<int>{1, 4, 9}));
    ASSERT_TRUE(system->execute(StartTracking{}));
    const SnapshotPtr last = run_out(*system);
    EXPECT_EQ(last->steered_target, 1);
    for (const TrackSnapshot& track : last->tracks) {
        ASSERT_EQ(track.estimate.state, TrackState::tracking) << track.estimate.reason;
        ASSERT_TRUE(track.estimate.position);
        const Eigen::Vector2d moved = *track.estimate.left_px - centre(place(track.id));
        EXPECT_NEAR(track.estimate.position->point_in_left_mm.z(), 1400.0, 400.0);
        EXPECT_GT(moved.norm(), 5.0);
    }
    EXPECT_TRUE(looks_at(*system, 1));
    EXPECT_TRUE(heard("Target 9: TemplateSet -> Tracking"));
}

TEST_F(SeveralTargets, AreSteeredToOneAtATime) {
    auto system = open_with({1, 7, 16});
    ASSERT_TRUE(system->execute(StartTracking{}));
    EXPECT_TRUE(looks_at(*system, 1));
    ASSERT_TRUE(system->execute(SteerTo{16}));
    EXPECT_EQ(system->latest()->steered_target, 16);
    EXPECT_TRUE(looks_at(*system, 16)) << "at once, not with the next pair";
    EXPECT_EQ(events_.back(), "The head is steered to target 16 now.");
    EXPECT_EQ(steered_track(*system->latest())->id, 16);
    run_out(*system);
    EXPECT_TRUE(looks_at(*system, 16));

    ASSERT_TRUE(system->execute(ClearTemplate{16}));
    EXPECT_TRUE(heard("Target 16: Tracking -> Idle"));
    EXPECT_EQ(events_.back(), "The head is steered to target 1 now.");
    EXPECT_EQ(system->latest()->steered_target, 1);
    ASSERT_TRUE(system->execute(ClearTemplate{}));
    EXPECT_TRUE(system->latest()->tracks.empty());
    EXPECT_EQ(system->latest()->steered_target, std::nullopt);
    EXPECT_EQ(steered_track(*system->latest()), nullptr);
}

TEST_F(SeveralTargets, WithoutANumberTheSteeredOneIsMeant) {
    auto system = open_with({1, 2});
    ASSERT_TRUE(system->execute(SteerTo{2}));
    ASSERT_TRUE(system->execute(SelectTemplate{place(12), std::nullopt}));
    EXPECT_EQ(ids_of(*system), (std::vector<int>{1, 2}));
    EXPECT_EQ(*system->latest()->tracks.at(1).estimate.left_px, centre(place(12)));
    ASSERT_TRUE(system->execute(StartTracking{}));
    ASSERT_TRUE(system->execute(UpdateTemplate{}));
    EXPECT_EQ(events_.back(), "Target 2: The template was updated by command.");
    EXPECT_EQ(system->latest()->tracks.at(0).estimate.template_updates, 0);
    EXPECT_EQ(system->latest()->tracks.at(1).estimate.template_updates, 1);
    ASSERT_TRUE(system->execute(UpdateTemplate{1}));
    EXPECT_EQ(system->latest()->tracks.at(0).estimate.template_updates, 1);
}

TEST_F(SeveralTargets, AreStartedAndStoppedOneByOne) {
    auto system = open_with({3, 5});
    EXPECT_EQ(system->latest()->steered_target, 3) << "the first one chosen";
    const auto states = [&] {
        std::vector<TrackState> list;
        for (const TrackSnapshot& track : system->latest()->tracks) {
            list.push_back(track.estimate.state);
        }
        return list;
    };
    using enum TrackState;
    ASSERT_TRUE(system->execute(StartTracking{5}));
    EXPECT_EQ(states(), (std::vector{template_set, tracking}));
    EXPECT_EQ(system->latest()->head->commanded, std::nullopt) << "the steered one stands still";
    ASSERT_TRUE(system->execute(StartTracking{}));
    EXPECT_EQ(states(), (std::vector{tracking, tracking}));
    ASSERT_TRUE(system->execute(StopTracking{3}));
    EXPECT_EQ(states(), (std::vector{template_set, tracking}));
    ASSERT_TRUE(system->execute(StopTracking{}));
    EXPECT_EQ(states(), (std::vector{template_set, template_set}));
}

TEST_F(SeveralTargets, RefusalsChangeNothing) {
    auto system = open_with({1, 2});
    const std::string before = untimed(*system->latest());
    const std::vector<std::pair<Command, std::string>> refused{
        {SelectTemplate{place(3), std::nullopt, 17}, "can't be a target 17"},
        {SelectTemplate{place(3), std::nullopt, 0}, "can't be a target 0"},
        {SelectTemplate{{630, 0, 25, 25}, std::nullopt, 3}, "not inside"},
        {SelectTemplate{{630, 0, 25, 25}, std::nullopt, 2}, "not inside"},
        {StartTracking{3}, "no target 3"},
        {StopTracking{4}, "no target 4"},
        {UpdateTemplate{5}, "no target 5"},
        {ClearTemplate{6}, "no target 6"},
        {SteerTo{7}, "no target 7"},
    };
    for (const auto& [command, why] : refused) {
        const auto reply = system->execute(command);
        ASSERT_FALSE(reply) << to_json(command);
        EXPECT_NE(reply.error().cause.find(why), std::string::npos) << reply.error().cause;
        EXPECT_FALSE(reply.error().remedy.empty());
        EXPECT_EQ(untimed(*system->latest()), before) << to_json(command);
    }
}

TEST_F(SeveralTargets, OneAloneIsSpokenOfWithoutItsNumber) {
    auto system = open_with({2});
    ASSERT_TRUE(system->execute(StartTracking{}));
    ASSERT_TRUE(system->execute(ClearTemplate{2}));
    EXPECT_EQ(events_, (std::vector<std::string>{"Idle -> TemplateSet", "TemplateSet -> Tracking",
                                                 "Tracking -> Idle"}));
}

// Every snapshot of sixteen targets, on one thread and on several; each as if it were alone.
TEST_F(SeveralTargets, GiveTheSameOnAnyNumberOfThreads) {
    std::vector<int> all;
    for (int id = 1; id <= most_targets; ++id) {
        all.push_back(id);
    }
    const auto run = [this](const std::vector<int>& ids, int threads) {
        auto system = open_with(ids, threads);
        std::vector<Snapshot> snapshots;
        const auto seen =
            system->observe([&](const SnapshotPtr& snapshot) { snapshots.push_back(*snapshot); });
        EXPECT_TRUE(system->execute(StartTracking{}));
        run_out(*system);
        return snapshots;
    };
    const auto serial = run(all, 1);
    const auto parallel = run(all, 5);
    const auto alone = run({11}, 1);
    ASSERT_EQ(serial.size(), parallel.size());
    ASSERT_EQ(serial.size(), alone.size());
    for (std::size_t i = 0; i < serial.size(); ++i) {
        EXPECT_EQ(untimed(serial[i]), untimed(parallel[i]));
        const TrackEstimate& of_many = parallel[i].tracks.at(10).estimate;
        const TrackEstimate& of_one = alone[i].tracks.at(0).estimate;
        EXPECT_EQ(of_many.state, of_one.state);
        EXPECT_EQ(of_many.left_px, of_one.left_px);
        EXPECT_EQ(of_many.right_px, of_one.right_px);
        EXPECT_EQ(of_many.search->map.scores, of_one.search->map.scores);
    }
}

}  // namespace
}  // namespace kambara
