// SPDX-License-Identifier: GPL-3.0-or-later
// `calibrate --expected` and `--medium`, through the program: pictures in air of a rig whose
// nominal numbers in air and water are known.
#include <gtest/gtest.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "hardware/media/picture_file.h"
#include "hardware/simulated/simulated_world.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;
using testing_support::Finished;
using testing_support::fresh_folder;
using testing_support::run_program;
using testing_support::text_of;

class CalibrateExpectedTest : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = fresh_folder("calibrate_expected");
        const SimulatedWorld world(*simulated_profile("chessboard"));
        for (int i = 0; i < 10; ++i) {
            for (const auto& [camera, side] :
                 {std::pair{FixedCamera::left, 'l'}, std::pair{FixedCamera::right, 'r'}}) {
                char name[24];
                std::snprintf(name, sizeof name, "%c%02d.png", side, i);
                ASSERT_TRUE(write_picture(folder_ / name, world.picture(camera, 15 + 30 * i)));
            }
        }
        ASSERT_TRUE(write_rig_file(folder_ / "air.yaml", nominal_rig(Medium::air)));
        ASSERT_TRUE(write_rig_file(folder_ / "water.yaml", nominal_rig(Medium::water)));
    }
    static void TearDownTestSuite() { fs::remove_all(folder_); }

    static Finished calibrated(const std::string& expected, const std::string& medium) {
        fs::remove(folder_ / "rig.yaml");
        return run_program(
            KAMBARA_CLI,
            {"calibrate", "--left", "l*.png", "--right", "r*.png", "--target", "chessboard:9x6:30",
             "--model", "tsai", "--sensor", "0.00635,0.0074,768,640", "--expected", expected,
             "--medium", medium, "--out", "rig.yaml", "--json", "result.json"},
            folder_);
    }

    static fs::path folder_;
};

fs::path CalibrateExpectedTest::folder_;

TEST_F(CalibrateExpectedTest, PicturesInAirFitTheDryAndTheWetRig) {
    for (const char* expected : {"air.yaml", "water.yaml"}) {
        const Finished run = calibrated(expected, "air");
        EXPECT_EQ(run.exit_code, 0) << run.errors;
        EXPECT_EQ(text_of(folder_ / "result.json").find("focal length is"), std::string::npos);
        const auto rig = read_rig_file(folder_ / "rig.yaml");
        ASSERT_TRUE(rig) << rig.error().text();
        EXPECT_EQ(rig->medium, Medium::air);
    }
}

TEST_F(CalibrateExpectedTest, PicturesInAirSaidToBeInWaterAreRefused) {
    for (const char* expected : {"air.yaml", "water.yaml"}) {
        const Finished run = calibrated(expected, "water");
        EXPECT_EQ(run.exit_code, 1);
        EXPECT_NE(run.errors.find("the pictures look taken in the other medium"), std::string::npos)
            << run.errors;
        EXPECT_FALSE(fs::exists(folder_ / "rig.yaml"));
        const auto told = nlohmann::json::parse(text_of(folder_ / "result.json"));
        EXPECT_EQ(told["verdict"], "refused");
        EXPECT_FALSE(told["accepted"]);
    }
}

TEST_F(CalibrateExpectedTest, AnotherLensIsRefused) {
    Rig other = nominal_rig();
    std::get<TsaiLens>(other.right->lens).f_mm *= 0.85;
    ASSERT_TRUE(write_rig_file(folder_ / "other.yaml", other));
    const Finished run = calibrated("other.yaml", "air");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_NE(run.errors.find("The right camera's focal length"), std::string::npos) << run.errors;
    EXPECT_NE(run.errors.find("another lens, zoom or target size"), std::string::npos);
}

TEST_F(CalibrateExpectedTest, AMediumThatIsNoneIsRefused) {
    const Finished run = calibrated("air.yaml", "oil");
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.errors.find("oil"), std::string::npos) << run.errors;
}

}  // namespace
}  // namespace kambara
