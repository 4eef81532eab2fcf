// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated head with lever arms, skew and backlash: calibrated by the command from the simulated
// rig's pictures, then pointed at things 0.7 m away, from both sides.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/cli/calibrate_head_command.h"
#include "core/base/digits.h"
#include "core/base/text_file.h"
#include "core/camera/rig_file.h"
#include "core/pointing/aim.h"
#include "core/pointing/head_axes.h"
#include "hardware/media/picture_file.h"
#include "hardware/simulated/simulated_head.h"
#include "hardware/simulated/simulated_world.h"
#include "tests/support/process.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

// The world, its head, and the time that passes while it turns.
class Bench {
  public:
    Bench()
        : world_(simulated_profile("chessboard?arm=50&ahead=12&skew=0.4&backlash=0.4&particles=0")
                     .value()) {
        SimulatedHead::Options options;
        options.backlash = world_.profile().head_backlash;
        head_ = std::make_unique<SimulatedHead>(clock_, options);
    }

    const SimulatedWorld& world() const { return world_; }
    HeadAngles encoders() { return head_->status().value().angles; }
    HeadAngles axes() { return head_->axes(); }
    void go(const HeadAngles& angles) {
        ASSERT_TRUE(head_->move_to(within_limits(angles, head_->limits())));
        clock_->set_ns(clock_->now_ns() + 5'000'000'000);
    }
    /// From below where a side is 1, from above where it is -1.
    void come(const HeadAngles& goal, const HeadApproach& from) {
        const double away = rad_from_deg(3.0);
        go({goal.pan_rad - from.pan * away, goal.tilt_rad - from.tilt * away});
        go(goal);
    }

  private:
    SimulatedWorld world_;
    std::shared_ptr<ManualClock> clock_ = std::make_shared<ManualClock>();
    std::unique_ptr<SimulatedHead> head_;
};

// Six poses of the board, each from four positions of the head, about as the window goes through.
void record(Bench& bench, const fs::path& folder) {
    const SimulatedWorld& world = bench.world();
    const HeadAngles limits{rad_from_deg(90.0), rad_from_deg(21.0)};
    std::string table = "left,right,pan_tilt,pan_deg,tilt_deg,pan_from,tilt_from\n";
    int number = 0;
    for (int pose = 0; pose < 6; ++pose) {
        const std::int64_t frame = 30 * pose + 15;
        const HeadAngles middle = angles_towards(
            world.rig(), world.T_left_from_target(frame) * Eigen::Vector3d(120.0, 75.0, 0.0));
        for (const auto& [pan_deg, tilt_deg] : {std::pair(-13.0, -8.0), std::pair(-5.0, 5.0),
                                                std::pair(6.0, -3.0), std::pair(13.0, 8.0)}) {
            const HeadApproach from{(number + pose) % 2 == 0 ? 1 : -1, number % 4 < 2 ? 1 : -1};
            const double tilt = middle.tilt_rad + rad_from_deg(tilt_deg);
            bench.come({middle.pan_rad + rad_from_deg(pan_deg),
                        std::clamp(tilt, -limits.tilt_rad, limits.tilt_rad)},
                       from);
            const std::string name = std::to_string(number++) + ".png";
            ASSERT_TRUE(
                write_picture(folder / ("l" + name), world.picture(FixedCamera::left, frame)));
            ASSERT_TRUE(
                write_picture(folder / ("r" + name), world.picture(FixedCamera::right, frame)));
            ASSERT_TRUE(
                write_picture(folder / ("h" + name), world.pan_tilt_picture(frame, bench.axes())));
            const HeadAngles told = bench.encoders();
            table += "l" + name + ",r" + name + ",h" + name + "," +
                     digits(deg_from_rad(told.pan_rad)) + "," +
                     digits(deg_from_rad(told.tilt_rad)) + (from.pan > 0 ? ",below" : ",above") +
                     (from.tilt > 0 ? ",below" : ",above") + "\n";
        }
    }
    ASSERT_TRUE(write_text_file_atomically(folder / "views.csv", table));
}

struct Missed {
    double worst_deg = 0.0;
    double squares = 0.0;
    int count = 0;
    void add(double rad) {
        worst_deg = std::max(worst_deg, deg_from_rad(rad));
        squares += std::pow(deg_from_rad(rad), 2);
        ++count;
    }
    double rms_deg() const { return std::sqrt(squares / count); }
};

TEST(HeadAtArmsLengthSlow, PointsWithinATenthOfADegreeFromBothSides) {
    const auto folder = testing_support::fresh_folder("head_at_arms_length");
    Bench bench;
    record(bench, folder);
    const Rig plain = bench.world().rig();
    ASSERT_TRUE(write_rig_file(folder / "rig.yaml", plain));
    CalibrateHeadOptions options;
    options.rig = folder / "rig.yaml";
    options.views = (folder / "views.csv").string();
    options.target = "chessboard:9x6:30";
    options.out = folder / "with_head.yaml";
    const Outcome outcome = run_calibrate_head(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    std::printf("%s", outcome.summary.c_str());
    const auto json = nlohmann::json::parse(outcome.json);
    EXPECT_GT(json["missed_at_700_mm_without_model_worst_deg"].get<double>(), 0.5);
    const auto found = read_rig_file(options.out);
    ASSERT_TRUE(found) << found.error().text();
    ASSERT_TRUE(found->head);
    const HeadAngles backlash{found->head->pan_backlash_rad, found->head->tilt_backlash_rad};

    const Rig truth = bench.world().true_rig();
    HeadAxes axes(backlash);
    axes.see(bench.encoders());
    const auto go = [&](const HeadAngles& encoders) {
        bench.go(encoders);
        axes.see(bench.encoders());
    };
    Missed with;
    Missed without_backlash;
    Missed without;
    for (double pan_deg = -40.0; pan_deg <= 40.0; pan_deg += 10.0) {
        for (double tilt_deg = -20.0; tilt_deg <= 20.0; tilt_deg += 8.0) {
            const RigidTransform T =
                T_camera_from_rig(*truth.head, {rad_from_deg(pan_deg), rad_from_deg(tilt_deg)});
            const Eigen::Vector3d point =
                truth.left.T_camera_from_rig * (T.inverse() * Eigen::Vector3d(0, 0, 700));
            const auto missed = [&] { return aiming_error_rad(truth, bench.axes(), point); };
            for (const double side_deg : {-4.0, 4.0}) {
                const HeadAngles wanted = angles_towards(*found, point);
                const HeadAngles start{wanted.pan_rad + rad_from_deg(side_deg),
                                       wanted.tilt_rad + rad_from_deg(side_deg)};
                go(start);
                go(axes.encoders_for(wanted));
                with.add(missed());
                go(start);
                go(wanted);
                without_backlash.add(missed());
                go(start);
                go(angles_towards(plain, point));
                without.add(missed());
            }
        }
    }
    std::printf(
        "at 0.7 m, %d times: missed by %.4f degrees RMS, %.4f at most; %.3f, %.3f with the "
        "backlash left out; %.2f, %.2f without the model\n",
        with.count, with.rms_deg(), with.worst_deg, without_backlash.rms_deg(),
        without_backlash.worst_deg, without.rms_deg(), without.worst_deg);
    EXPECT_LT(with.worst_deg, 0.1);
    EXPECT_GT(without_backlash.worst_deg, 0.2);
    EXPECT_GT(without.worst_deg, 1.0);
    fs::remove_all(folder);
}

}  // namespace
}  // namespace kambara::cli
