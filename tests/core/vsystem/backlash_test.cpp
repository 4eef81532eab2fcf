// SPDX-License-Identifier: GPL-3.0-or-later
// A head whose axes lag behind its encoders is steered so that they end where they should.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "core/camera/nominal_rig.h"
#include "core/pointing/aim.h"
#include "core/pointing/head_calibration.h"
#include "core/vsystem/head_worker.h"
#include "core/vsystem/vision_system.h"
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

constexpr HeadAngles backlash{rad_from_deg(0.8), rad_from_deg(0.6)};

Rig rig_with(const HeadAngles& told_backlash) {
    HeadModel head;
    head.T_base_from_rig = nominal_rig().pan_tilt->T_camera_from_rig;
    head.T_base_from_rig.t_mm += Eigen::Vector3d(0.0, 0.0, 50.0);
    head.T_camera_from_tilt.t_mm = {0.0, 0.0, -50.0};
    head.pan_backlash_rad = told_backlash.pan_rad;
    head.tilt_backlash_rad = told_backlash.tilt_rad;
    return with_head_model(nominal_rig(), head);
}

// The plane's pictures are drawn once.
const std::vector<StereoFrame>& recording() {
    static const std::vector<StereoFrame> pairs = [] {
        std::vector<StereoFrame> drawn_pairs;
        for (int i = 0; i < 3; ++i) {
            const TexturedPlane plane{{4.0 * i, 2.0 * i, 1000.0}};
            drawn_pairs.push_back(drawn_pair(plane, nominal_rig(), i));
        }
        return drawn_pairs;
    }();
    return pairs;
}

// By how much the axes miss the target after the head came from those angles.
double missed_deg(const HeadAngles& from, const HeadAngles& told_backlash) {
    std::vector<Frame> lefts;
    std::vector<Frame> rights;
    for (const StereoFrame& pair : recording()) {
        lefts.push_back(pair.left);
        rights.push_back(pair.right);
    }
    const auto head = std::make_shared<InstantHead>();
    head->backlash = backlash;
    VisionSystemParts parts{rig_with(told_backlash), {}, head};
    parts.grabbers.left = std::make_unique<ListGrabber>(lefts, 640, 480, std::nullopt);
    parts.grabbers.right = std::make_unique<ListGrabber>(rights, 640, 480, std::nullopt);
    VisionSystemOptions options;
    options.every_frame = true;
    options.start_paused = true;
    options.steering.dead_band_rad = 0.0;
    SteadyClock clock;
    const auto opened = open_vision_system(std::move(parts), options, clock);
    EXPECT_TRUE(opened);
    VsystemInterface& system = **opened;
    EXPECT_TRUE(system.execute(SelectTemplate{{300, 230, 31, 31}, std::nullopt}));
    EXPECT_TRUE(system.execute(MoveHead{from}));
    EXPECT_TRUE(system.execute(StartTracking{}));
    EXPECT_TRUE(system.execute(SteerHead{true}));
    const SnapshotPtr last = run_out(system);
    EXPECT_TRUE(last->head && last->tracks.at(0).estimate.position);
    if (told_backlash == backlash) {  // the operator is shown where it really looks
        EXPECT_NEAR(last->head->axes.pan_rad, head->axes().pan_rad, 1e-12);
        EXPECT_NEAR(last->head->axes.tilt_rad, head->axes().tilt_rad, 1e-12);
        EXPECT_EQ(last->head->commanded, last->head->angles);
    }
    return deg_from_rad(aiming_error_rad(system.rig(), head->axes(),
                                         last->tracks[0].estimate.position->point_in_left_mm));
}

TEST(Backlash, TheAxesEndOnTheTargetFromEverySide) {
    for (const double pan : {-0.7, 0.7}) {
        for (const double tilt : {-0.4, 0.4}) {
            const double with_deg = missed_deg({pan, tilt}, backlash);
            const double without_deg = missed_deg({pan, tilt}, {});
            std::printf("from pan %.1f, tilt %.1f: missed by %.4f degrees, by %.3f without\n", pan,
                        tilt, with_deg, without_deg);
            EXPECT_LT(with_deg, 0.1);
            EXPECT_GT(without_deg, 0.2);
        }
    }
}

// On a thread of its own, too, where it learns of the head's moves by asking.
TEST(Backlash, TheWorkerFollowsTheAxesOfALiveHead) {
    const auto head = std::make_shared<InstantHead>();
    head->backlash = backlash;
    ManualClock clock;
    HeadWorker worker(head, HeadWorker::Threading::own_thread, clock);
    worker.use_backlash(backlash);
    const auto comes_to = [&](const HeadAngles& encoders) {
        worker.command(encoders);
        for (int i = 0; i < 1000 && worker.reading().status.angles != encoders; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        const HeadAngles axes = worker.reading().axes;
        EXPECT_NEAR(axes.pan_rad, head->axes().pan_rad, 1e-12);
        EXPECT_NEAR(axes.tilt_rad, head->axes().tilt_rad, 1e-12);
        return worker.reading().status.angles == encoders;
    };
    ASSERT_TRUE(comes_to({0.2, 0.1}));
    ASSERT_TRUE(comes_to({0.197, 0.2}));  // the pan axis stands, the encoder crosses the play
    EXPECT_NEAR(worker.reading().axes.pan_rad, 0.2 - 0.5 * backlash.pan_rad, 1e-12);
    const HeadAngles wanted{-0.3, 0.25};
    ASSERT_TRUE(comes_to(worker.encoders_for(wanted)));
    EXPECT_NEAR(head->axes().pan_rad, wanted.pan_rad, 1e-12);
    EXPECT_NEAR(head->axes().tilt_rad, wanted.tilt_rad, 1e-12);
    EXPECT_FALSE(worker.astray(wanted));
    EXPECT_TRUE(worker.astray({wanted.pan_rad, wanted.tilt_rad + backlash.tilt_rad}));
    // Never told to go beyond what it reaches.
    const HeadAngles edge = worker.encoders_for({HeadLimits{}.pan_rad, HeadLimits{}.tilt_rad});
    EXPECT_EQ(edge, (HeadAngles{HeadLimits{}.pan_rad, HeadLimits{}.tilt_rad}));
}

}  // namespace
}  // namespace kambara
