// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/serialise.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>
#include <vector>

namespace kambara {
namespace {

const std::vector<Command> all_commands{
    SelectTemplate{{3, 4, 21, 31}, std::nullopt},
    SelectTemplate{{0, 0, 7, 7}, 9'000'000'000'000},
    SelectTemplate{{0, 0, 7, 7}, std::nullopt, 16},
    StartTracking{},
    StartTracking{2},
    StopTracking{},
    StopTracking{3},
    UpdateTemplate{},
    UpdateTemplate{4},
    ClearTemplate{},
    ClearTemplate{5},
    SteerTo{6},
    MoveHead{{0.1, -1.0 / 3.0}},
    HaltHead{},
    Seek{0},
    Seek{123456789012},
    HoldFrame{7},
    SteerHead{false},
    SteerHead{true},
    ServoHead{},
    ServoHead{false},
    SelectInPanTilt{{5, 6, 41, 31}},
    CaptureView{},
    Calibrate{"chessboard:9x6:30"},
    Flow{Flow::Kind::run},
    Flow{Flow::Kind::pause},
    Flow{Flow::Kind::step},
    DriveHead{-0.25, 1.0 / 3.0},
    HomeHead{},
    ResetHead{},
    CentreHead{12.5, 400.0},
    CentreHead{0.0, 1.0 / 3.0, HeadAngles{-0.1, 0.2}},
    ZoomHead{1.0 / 3.0},
    FocusHead{0.75},
    AutofocusHead{},
    KeepPreset{5},
    RecallPreset{3},
    TellVehicleMotion{{123, {1.0 / 3.0, -2.0, 3.0}, {0.1, -0.2, 1e-3}, 5.0, 0.02}},
};

TEST(Serialise, EveryCommandComesBackAsItWas) {
    ASSERT_EQ(std::variant_size_v<Command>, 26U) << "add the new command to the list above";
    for (const Command& command : all_commands) {
        const auto back = command_from_json(to_json(command));
        ASSERT_TRUE(back) << back.error().text();
        EXPECT_EQ(*back, command) << to_json(command);
    }
}

TEST(Serialise, RepliesAndEventsComeBackAsTheyWere) {
    const CalibrationOutcome outcome{
        "usable", {"one \"reason\"", "another"}, 9, 0.21, 99.8, "kambara_rig: 1\n"};
    for (const Reply& reply : {Reply(Done{}), Reply(outcome)}) {
        const auto back = reply_from_json(to_json(reply));
        ASSERT_TRUE(back);
        EXPECT_EQ(*back, reply);
    }
    const Event event{Event::Kind::warning, 12, -5, "Tracking -> Lost: why"};
    const auto back = event_from_json(to_json(event));
    ASSERT_TRUE(back);
    EXPECT_EQ(*back, event);
}

Snapshot full_snapshot() {
    Snapshot snapshot;
    snapshot.frame = 77;
    snapshot.time_ns = 2'566'666'667;
    snapshot.run = RunState::failed;
    snapshot.failure = Error{"The cause.", "The remedy."};
    snapshot.rate_hz = 29.97;
    snapshot.rig_watch = RigWatchState{120, -0.33, 0.05, -8e-4, true};
    snapshot.processing_ms = 1.25;
    snapshot.latency_ms = 12.25;
    snapshot.frames_total = 1801;
    snapshot.frames_lost = std::numeric_limits<std::uint64_t>::max();
    TrackSnapshot track{1, {}};
    track.estimate.state = TrackState::doubtful;
    track.estimate.reason = "the match is right with a probability of only 65 %";
    track.estimate.left_px = Eigen::Vector2d(1.0 / 3.0, 2.5);
    track.estimate.right_px = Eigen::Vector2d(-4.25, 1e-17);
    track.estimate.quality = 0.65;
    track.estimate.template_size_px = {21, 31};
    track.estimate.template_updates = 3;
    Position position;
    position.point_in_left_mm = {1.1, -2.2, 1500.7};
    position.covariance_mm2 << 1, 0.1, 0.2, 0.1, 2, 0.3, 0.2, 0.3, 3;
    position.residual_px = 0.04;
    position.parallax_rad = 0.3;
    position.calibration_covariance_mm2 = 2.0 * position.covariance_mm2;
    position.method = PositionMethod::midpoint;
    position.epipolar = {-0.3, 0.02, 0.1};
    track.estimate.position = position;
    MotionEstimate motion;
    motion.point_mm = {1.0, -2.0, 1500.0};
    motion.velocity_mm_s = {100.0, 1.0 / 3.0, -7.0};
    motion.velocity_covariance_mm2_s2 << 9, 1, 2, 1, 8, 3, 2, 3, 7;
    motion.acceleration_mm_s2 = {0.0, 10.0, 0.0};
    motion.model = MotionModel::constant_acceleration;
    motion.innovation = 2.5;
    motion.consistent = false;
    motion.by_vehicle = true;
    track.estimate.motion = motion;
    snapshot.tracks = {track, TrackSnapshot{2, {}}};
    snapshot.steered_target = 2;
    snapshot.head = HeadSnapshot{{0.2, -0.1}, HeadAngles{0.3, -0.2}, true, false, true, "cable"};
    snapshot.head->lens = LensStatus{0.25, 1.0 / 3.0, 0.8, 0.75, false};
    snapshot.head->abilities = {true, false, true, false, true, 6};
    snapshot.head->limits = {1.0, 0.5, 0.7, 1.0 / 3.0};
    snapshot.head->axes = {0.19, -0.11};
    snapshot.servo = ServoSnapshot{
        true, TrackState::doubtful,         "dim", Eigen::Vector2d(319.5, 1.0 / 3.0), {41, 31},
        0.4,  HeadAngles{-0.01, 1.0 / 7.0}, true};
    return snapshot;
}

TEST(Serialise, ASnapshotComesBackAsItWas) {
    for (const Snapshot& snapshot : {full_snapshot(), Snapshot{}}) {
        const std::string text = to_json(snapshot);
        const auto back = snapshot_from_json(text);
        ASSERT_TRUE(back) << back.error().text();
        EXPECT_EQ(to_json(*back), text);  // every field that is written
        EXPECT_EQ(back->frame, snapshot.frame);
        EXPECT_EQ(back->run, snapshot.run);
        EXPECT_EQ(back->failure, snapshot.failure);
        EXPECT_EQ(back->head, snapshot.head);
        EXPECT_EQ(back->servo, snapshot.servo);
        EXPECT_EQ(back->steered_target, snapshot.steered_target);
        EXPECT_EQ(back->frames_lost, snapshot.frames_lost);
        EXPECT_EQ(back->latency_ms, snapshot.latency_ms);
        EXPECT_EQ(back->rig_watch, snapshot.rig_watch);
        EXPECT_EQ(back->frames_total, snapshot.frames_total);
        ASSERT_EQ(back->tracks.size(), snapshot.tracks.size());
        if (!snapshot.tracks.empty()) {
            const TrackEstimate& a = back->tracks[0].estimate;
            const TrackEstimate& b = snapshot.tracks[0].estimate;
            EXPECT_EQ(a.state, b.state);
            EXPECT_EQ(*a.left_px, *b.left_px);
            EXPECT_EQ(a.position->covariance_mm2, b.position->covariance_mm2);
            EXPECT_EQ(a.position->calibration_covariance_mm2,
                      b.position->calibration_covariance_mm2);
            EXPECT_EQ(a.position->method, b.position->method);
            EXPECT_EQ(a.position->epipolar.offset_px, b.position->epipolar.offset_px);
            EXPECT_EQ(a.position->epipolar.noise_sigma_px, b.position->epipolar.noise_sigma_px);
            EXPECT_EQ(a.position->epipolar.calibration_sigma_px,
                      b.position->epipolar.calibration_sigma_px);
            EXPECT_EQ(a.motion->velocity_mm_s, b.motion->velocity_mm_s);
            EXPECT_EQ(a.motion->model, b.motion->model);
        }
    }
}

TEST(Serialise, RefusesWhatIsMissingMistypedOrUnknown) {
    const std::pair<const char*, const char*> bad[] = {
        {"", "not valid JSON"},
        {"[]", "command"},
        {R"({"command":"dance"})", "dance"},
        {R"({"command":"select_template","rectangle_px":[1,2,3]})", "rectangle_px"},
        {R"({"command":"select_template","rectangle_px":[1,2,3,4.5]})", "wrong type"},
        {R"({"command":"select_template","rectangle_px":[1,2,3,4000000000]})", "wrong type"},
        {R"({"command":"move_head","pan_rad":"left","tilt_rad":0})", "pan_rad"},
        {R"({"command":"move_head","pan_rad":0})", "tilt_rad"},
        {R"({"command":"steer_to"})", "target"},
        {R"({"command":"drive_head","pan_rad_s":1})", "tilt_rad_s"},
        {R"({"command":"zoom_head","share":"tele"})", "share"},
        {R"({"command":"keep_preset","number":1.5})", "number"},
        {R"({"command":"centre_head","x_px":1,"y_px":2,"seen_from_pan_rad":0})",
         "seen_from_tilt_rad"},
        {R"({"command":"start_tracking","target":"all"})", "target"},
        {R"({"command":"flow","kind":"sideways"})", "kind"},
    };
    for (const auto& [text, named] : bad) {
        const auto command = command_from_json(text);
        ASSERT_FALSE(command) << text;
        EXPECT_NE(command.error().cause.find(named), std::string::npos) << command.error().cause;
        EXPECT_FALSE(command.error().remedy.empty());
    }
}

// Any damage to a good text is either refused or read; it never crashes.
TEST(Serialise, SurvivesDamagedTexts) {
    std::mt19937 random(1);
    const std::string good = to_json(full_snapshot());
    for (int round = 0; round < 3000; ++round) {
        std::string text = good;
        for (int i = 0; i < 3; ++i) {
            text[random() % text.size()] = static_cast<char>(random() % 256);
        }
        const auto back = snapshot_from_json(text);
        if (!back) {
            EXPECT_FALSE(back.error().cause.empty());
        }
        (void)command_from_json(text).ok();
    }
}

}  // namespace
}  // namespace kambara
