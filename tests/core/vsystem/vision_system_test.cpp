// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/vision_system.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "tests/support/instant_head.h"
#include "tests/support/list_grabber.h"
#include "tests/support/textured_plane.h"
#include "tests/support/wait_for_snapshot.h"

namespace kambara {
namespace {

using testing_support::drawn_pair;
using testing_support::InstantHead;
using testing_support::ListGrabber;
using testing_support::run_out;
using testing_support::TexturedPlane;
using testing_support::wait_for;

constexpr Rectangle rectangle{300, 230, 31, 31};

// The plane's pictures are drawn once for all tests.
const std::vector<StereoFrame>& recording() {
    static const std::vector<StereoFrame> pairs = [] {
        std::vector<StereoFrame> drawn_pairs;
        for (int i = 0; i < 5; ++i) {
            TexturedPlane plane{{10.0 * i, 6.0 * i, 1400.0}};
            drawn_pairs.push_back(drawn_pair(plane, nominal_rig(), i));
        }
        return drawn_pairs;
    }();
    return pairs;
}

class VisionSystemTest : public testing::Test {
  protected:
    Result<std::unique_ptr<VsystemInterface>> open(std::size_t left, std::size_t right,
                                                   std::optional<Error> failure = std::nullopt,
                                                   bool paused = true) {
        std::vector<Frame> lefts;
        std::vector<Frame> rights;
        for (std::size_t i = 0; i < left; ++i) {
            lefts.push_back(recording()[i].left);
        }
        for (std::size_t i = 0; i < right; ++i) {
            rights.push_back(recording()[i].right);
        }
        head_ = std::make_shared<InstantHead>();
        VisionSystemParts parts{nominal_rig(), {}, head_};
        parts.grabbers.left = std::make_unique<ListGrabber>(lefts, 640, 480, failure);
        auto of_right = std::make_unique<ListGrabber>(rights, 640, 480, failure);
        right_ = of_right.get();
        parts.grabbers.right = std::move(of_right);
        VisionSystemOptions options;
        options.every_frame = true;
        options.start_paused = paused;
        return open_vision_system(std::move(parts), options, clock_);
    }

    SteadyClock clock_;
    std::shared_ptr<InstantHead> head_;
    ListGrabber* right_ = nullptr;  // the system's
};

TEST_F(VisionSystemTest, HoldsTheFirstPairUntilToldToRun) {
    auto system = open(5, 5);
    ASSERT_TRUE(system);
    EXPECT_EQ((*system)->latest()->frame, 0);
    EXPECT_EQ((*system)->latest()->run, RunState::paused);
    EXPECT_TRUE((*system)->latest()->tracks.empty());
    const auto images = (*system)->images();
    ASSERT_TRUE(images);
    EXPECT_EQ(images->stereo.left.picture, recording()[0].left.picture);
}

TEST_F(VisionSystemTest, TracksPositionsAndSteersFromTheFirstPairOn) {
    auto opened = open(5, 5);
    ASSERT_TRUE(opened);
    VsystemInterface& system = **opened;
    std::vector<std::int64_t> frames;
    std::vector<TrackEstimate> estimates;
    std::vector<std::string> events;
    ASSERT_TRUE(system.execute(SelectTemplate{rectangle, std::nullopt}));
    EXPECT_EQ(system.latest()->tracks.at(0).estimate.state, TrackState::template_set);
    const auto seen = system.observe([&](const SnapshotPtr& snapshot) {
        if (snapshot->run != RunState::ended &&
            (frames.empty() || snapshot->frame != frames.back())) {
            frames.push_back(snapshot->frame);
            estimates.push_back(snapshot->tracks.at(0).estimate);
        }
    });
    const auto heard =
        system.observe_events([&](const Event& event) { events.push_back(event.text); });
    ASSERT_TRUE(system.execute(StartTracking{}));
    const SnapshotPtr last = run_out(system);
    EXPECT_EQ(last->run, RunState::ended);
    EXPECT_EQ(frames, (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
    for (const TrackEstimate& estimate : estimates) {
        EXPECT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
        EXPECT_TRUE(estimate.position);
    }
    ASSERT_GE(events.size(), 2U);
    EXPECT_EQ(events.front(), "TemplateSet -> Tracking");
    ASSERT_TRUE(last->head && last->tracks[0].estimate.position);
    EXPECT_LT(aiming_error_rad(system.rig(), last->head->angles,
                               last->tracks[0].estimate.position->point_in_left_mm),
              rad_from_deg(0.2));
    EXPECT_GT(head_->moves(), 0);
    EXPECT_FALSE(system.execute(Flow{Flow::Kind::run}));  // the source is over
}

TEST_F(VisionSystemTest, RefusesCommandsAndChangesNothing) {
    auto opened = open(2, 2);
    ASSERT_TRUE(opened);
    VsystemInterface& system = **opened;
    EXPECT_FALSE(system.execute(StartTracking{}));
    EXPECT_FALSE(system.execute(UpdateTemplate{}));
    EXPECT_FALSE(system.execute(SelectTemplate{{630, 0, 31, 31}, std::nullopt}));
    EXPECT_FALSE(system.execute(SelectTemplate{rectangle, 99}));
    EXPECT_FALSE(system.execute(MoveHead{{3.0, 0.0}}));
    EXPECT_FALSE(system.execute(Calibrate{"chessboard:9x6:30"}));
    EXPECT_FALSE(system.execute(Calibrate{"no such target"}));
    EXPECT_TRUE(system.latest()->tracks.empty());
    EXPECT_EQ(head_->moves(), 0);
}

TEST_F(VisionSystemTest, TheOperatorTakesTheHeadAndHandsItBack) {
    auto opened = open(5, 5);
    ASSERT_TRUE(opened);
    VsystemInterface& system = **opened;
    ASSERT_TRUE(system.execute(SelectTemplate{rectangle, std::nullopt}));
    ASSERT_TRUE(system.execute(MoveHead{{0.5, 0.1}}));
    ASSERT_TRUE(system.execute(StartTracking{}));
    EXPECT_FALSE(system.latest()->head->automatic);
    EXPECT_EQ(system.latest()->head->angles, (HeadAngles{0.5, 0.1}));
    ASSERT_TRUE(system.execute(SteerHead{true}));
    run_out(system);
    EXPECT_NE(system.latest()->head->angles, (HeadAngles{0.5, 0.1}));
}

TEST_F(VisionSystemTest, SelectsInAPairThatWasShownEarlier) {
    auto opened = open(5, 5);
    ASSERT_TRUE(opened);
    VsystemInterface& system = **opened;
    run_out(system);
    ASSERT_TRUE(system.execute(SelectTemplate{rectangle, 1}));
    ASSERT_TRUE(system.execute(StartTracking{}));
    const TrackEstimate& estimate = system.latest()->tracks.at(0).estimate;
    EXPECT_EQ(estimate.state, TrackState::tracking) << estimate.reason;
    EXPECT_GT((*estimate.left_px - Eigen::Vector2d(315, 245)).norm(), 5.0);  // it has moved since
}

TEST_F(VisionSystemTest, SelectsInAPairThatIsHeldForHoweverLong) {
    auto system = *open(recording().size(), recording().size());
    ASSERT_TRUE(system->execute(HoldFrame{0}));
    for (std::size_t i = 1; i < recording().size(); ++i) {
        ASSERT_TRUE(system->execute(Flow{Flow::Kind::step}));
    }
    run_out(*system);
    EXPECT_TRUE(system->execute(SelectTemplate{rectangle, 0}));
    EXPECT_NE(system->execute(HoldFrame{-5}).error().cause.find("no longer remembered"),
              std::string::npos);
}

TEST_F(VisionSystemTest, WindsARecordingAndGoesOnAfterItsEnd) {
    auto system = *open(recording().size(), recording().size());
    EXPECT_EQ(system->latest()->frames_total, static_cast<std::int64_t>(recording().size()));
    ASSERT_TRUE(system->execute(SelectTemplate{rectangle, 0}));
    ASSERT_TRUE(system->execute(StartTracking{}));
    EXPECT_EQ(run_out(*system)->run, RunState::ended);
    EXPECT_FALSE(system->execute(Flow{Flow::Kind::run}));

    ASSERT_TRUE(system->execute(Seek{2}));
    const SnapshotPtr there = wait_for(*system, [](const Snapshot& s) { return s.frame == 2; });
    EXPECT_EQ(there->run, RunState::paused);
    ASSERT_EQ(there->tracks.size(), 1U);
    EXPECT_EQ(there->tracks.front().estimate.state, TrackState::template_set);

    EXPECT_FALSE(system->execute(Seek{static_cast<std::int64_t>(recording().size())}));
    EXPECT_FALSE(system->execute(Seek{-1}));
    EXPECT_EQ(system->latest()->frame, 2);
    ASSERT_TRUE(system->execute(Flow{Flow::Kind::step}));
    EXPECT_EQ(wait_for(*system, [](const Snapshot& s) { return s.frame == 3; })->frame, 3);
}

TEST_F(VisionSystemTest, RefusesToStartWhileNoPictureIsRemembered) {
    auto system = *open(5, 5);
    run_out(*system);
    ASSERT_TRUE(system->execute(SelectTemplate{rectangle, 1}));
    std::optional<Result<Reply>> started;
    const auto heard = system->observe_events([&](const Event& event) {
        if (event.text == "Tracking -> TemplateSet") {
            started = system->execute(StartTracking{});  // wound, and nothing taken since
        }
    });
    ASSERT_TRUE(system->execute(StartTracking{}));
    ASSERT_TRUE(system->execute(Seek{1}));
    wait_for(*system, [](const Snapshot& s) { return s.frame == 1; });
    ASSERT_TRUE(started);
    ASSERT_FALSE(*started);
    EXPECT_NE(started->error().cause.find("no picture"), std::string::npos);
}

TEST_F(VisionSystemTest, AFailedSeekLeavesBothCamerasWhereTheyWere) {
    auto system = *open(5, 5);
    ASSERT_TRUE(system->execute(Flow{Flow::Kind::step}));
    wait_for(*system, [](const Snapshot& s) { return s.frame == 1; });
    right_->refuse_seeks_from(4);  // the left one is wound first, and goes there
    const auto refused = system->execute(Seek{4});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().cause, "The tape is torn.");
    ASSERT_TRUE(system->execute(Flow{Flow::Kind::step}));
    const SnapshotPtr next = wait_for(*system, [](const Snapshot& s) { return s.frame > 1; });
    EXPECT_EQ(next->pictures.stereo.left.index, 2);
    EXPECT_EQ(next->pictures.stereo.right.index, 2);
}

TEST_F(VisionSystemTest, ARecordingWhoseCamerasWerePartedIsOver) {
    auto system = *open(5, 5);
    right_->refuse_seeks_from(0);
    ASSERT_FALSE(system->execute(Seek{3}));
    ASSERT_TRUE(system->execute(Flow{Flow::Kind::step}));
    const SnapshotPtr last =
        wait_for(*system, [](const Snapshot& s) { return s.run == RunState::failed; });
    EXPECT_EQ(last->failure->cause, "The tape is torn.");
    EXPECT_EQ(last->frame, 0);
}

TEST_F(VisionSystemTest, AMoveThatTheHeadRefusedIsCommandedAgain) {
    auto system = *open(5, 5);
    head_->refusals = 1;
    ASSERT_TRUE(system->execute(SelectTemplate{rectangle, std::nullopt}));
    ASSERT_TRUE(system->execute(StartTracking{}));
    EXPECT_EQ(head_->moves(), 0);
    EXPECT_NE(system->latest()->head->fault.find("does not answer"), std::string::npos);
    run_out(*system);
    EXPECT_GT(head_->moves(), 0);
    EXPECT_TRUE(system->latest()->head->fault.empty()) << system->latest()->head->fault;
}

TEST_F(VisionSystemTest, ObserversSeeWhatTheyCausedAfterWhatCausedIt) {
    auto system = *open(5, 5);
    ASSERT_TRUE(system->execute(SelectTemplate{rectangle, std::nullopt}));
    ASSERT_TRUE(system->execute(StartTracking{}));
    std::vector<TrackState> second;
    const auto first = system->observe([&](const SnapshotPtr& snapshot) {
        if (snapshot->frame == 2 && snapshot->tracks.at(0).estimate.state == TrackState::tracking) {
            EXPECT_TRUE(system->execute(StopTracking{}));
        }
    });
    const auto later = system->observe([&](const SnapshotPtr& snapshot) {
        if (snapshot->frame == 2) {
            second.push_back(snapshot->tracks.at(0).estimate.state);
        }
    });
    run_out(*system);
    EXPECT_EQ(second, (std::vector<TrackState>{TrackState::tracking, TrackState::template_set}));
}

TEST_F(VisionSystemTest, ShowsHowItSearched) {
    auto system = *open(recording().size(), recording().size());
    ASSERT_TRUE(system->execute(SelectTemplate{rectangle, 0}));
    const auto chosen = system->latest()->tracks.front().estimate.search;
    ASSERT_TRUE(chosen);
    EXPECT_TRUE(chosen->map.empty());
    EXPECT_FALSE(chosen->epipolar_px.empty());
    ASSERT_TRUE(system->execute(StartTracking{}));
    const auto& estimate = system->latest()->tracks.front().estimate;
    ASSERT_TRUE(estimate.search);
    const SearchDetail& search = *estimate.search;
    ASSERT_FALSE(search.map.empty());
    const double best = *std::max_element(search.map.scores.begin(), search.map.scores.end());
    EXPECT_NEAR(search.likeness(best), 1.0, 0.05);
    const Rectangle window = search.window();
    EXPECT_LE(window.x, rectangle.x);
    EXPECT_GE(window.x + window.width, rectangle.x + rectangle.width);
    ASSERT_GE(search.epipolar_px.size(), 2U);
    // The match lies on the curve that is shown.
    double nearest_px = 1e9;
    for (std::size_t i = 1; i < search.epipolar_px.size(); ++i) {
        const Eigen::Vector2d a = search.epipolar_px[i - 1];
        const Eigen::Vector2d along = search.epipolar_px[i] - a;
        const double t =
            std::clamp((*estimate.right_px - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
        nearest_px = std::min(nearest_px, (*estimate.right_px - a - t * along).norm());
    }
    EXPECT_LT(nearest_px, 0.5);
}

TEST_F(VisionSystemTest, HaltsTheHeadAndLeavesItToTheOperator) {
    auto system = *open(2, 2);
    ASSERT_TRUE(system->execute(MoveHead{{0.1, 0.05}}));
    const int halts = head_->halts;
    ASSERT_TRUE(system->execute(HaltHead{}));
    EXPECT_EQ(head_->halts, halts + 1);
    EXPECT_FALSE(system->latest()->head->automatic);
    EXPECT_FALSE(system->latest()->head->commanded);
}

TEST_F(VisionSystemTest, SaysWhichRecordingEndedFirst) {
    auto opened = open(5, 3);
    ASSERT_TRUE(opened);
    const SnapshotPtr last = run_out(**opened);
    EXPECT_EQ(last->run, RunState::failed);
    ASSERT_TRUE(last->failure);
    EXPECT_NE(last->failure->cause.find("different lengths"), std::string::npos);
    EXPECT_NE(last->failure->cause.find("3 frames"), std::string::npos);
}

TEST_F(VisionSystemTest, PassesOnASourcesFailure) {
    const Error failure{"The disk is gone.", "Find it."};
    auto opened = open(2, 2, failure);
    ASSERT_TRUE(opened);
    EXPECT_EQ(run_out(**opened)->failure, failure);
    EXPECT_EQ(open(0, 0, failure).error(), failure);
    EXPECT_NE(open(0, 0).error().cause.find("no pictures"), std::string::npos);
}

TEST_F(VisionSystemTest, AnObserverMayExecuteCommands) {
    auto opened = open(5, 5);
    ASSERT_TRUE(opened);
    VsystemInterface& system = **opened;
    ASSERT_TRUE(system.execute(SelectTemplate{rectangle, std::nullopt}));
    std::atomic<int> stopped{0};
    const auto observation = system.observe([&](const SnapshotPtr& snapshot) {
        if (snapshot->frame == 2 && stopped++ == 0) {
            EXPECT_TRUE(system.execute(StopTracking{}));
        }
    });
    ASSERT_TRUE(system.execute(StartTracking{}));
    const SnapshotPtr last = run_out(system);
    EXPECT_EQ(last->tracks.at(0).estimate.state, TrackState::template_set);
}

// Many hands at once: for the thread sanitizer as much as for the result.
TEST_F(VisionSystemTest, BearsCommandsAndReadersFromManyThreads) {
    auto opened = open(5, 5);
    ASSERT_TRUE(opened);
    VsystemInterface& system = **opened;
    std::vector<std::jthread> hands;
    for (int i = 0; i < 4; ++i) {
        hands.emplace_back([&system, i] {
            for (int k = 0; k < 6; ++k) {
                (void)system.execute(SelectTemplate{rectangle, std::nullopt}).ok();
                (void)system.execute(StartTracking{}).ok();
                (void)system.execute(Flow{Flow::Kind::step}).ok();
                (void)system.execute(MoveHead{{0.01 * i, 0.01 * k}}).ok();
                const auto watch = system.observe([](const SnapshotPtr&) {});
                EXPECT_TRUE(system.latest());
                EXPECT_TRUE(system.images());
            }
        });
    }
    hands.clear();
    EXPECT_GE(system.latest()->frame, 0);
}

}  // namespace
}  // namespace kambara
