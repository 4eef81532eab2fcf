// SPDX-License-Identifier: GPL-3.0-or-later
// Rig files to other programs' formats and back, through the program itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/camera/rig_file.h"
#include "tests/support/process.h"

namespace kambara {
namespace {

namespace fs = std::filesystem;
using testing_support::Finished;
using testing_support::fresh_folder;
using testing_support::run_program;
using testing_support::text_of;

struct Files {
    const char* format;
    std::vector<std::string> names;
};
const std::vector<Files> formats{{"opencv", {"out/intrinsics.yml", "out/extrinsics.yml"}},
                                 {"ros", {"out/left.yaml", "out/right.yaml"}},
                                 {"kalibr", {"out/camchain.yaml"}}};

class ConvertTest : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = fresh_folder(testing::UnitTest::GetInstance()->current_test_info()->name());
    }
    void TearDown() override { fs::remove_all(folder_); }

    Finished convert(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "convert");
        return run_program(KAMBARA_CLI, arguments, folder_);
    }

    // To the format and back, read again.
    Result<Rig> there_and_back(const Files& files) {
        const Finished to = convert({"rig.yaml", "--to", files.format, "out", "--json", "to.json"});
        EXPECT_EQ(to.exit_code, 0) << to.errors;
        std::vector<std::string> from{"--from", files.format};
        from.insert(from.end(), files.names.begin(), files.names.end());
        from.insert(from.end(), {"--out", "back.yaml"});
        const Finished back = convert(from);
        EXPECT_EQ(back.exit_code, 0) << back.errors;
        return read_rig_file(folder_ / "back.yaml");
    }

    fs::path folder_;
};

// How far the right camera has what the left one sees, over the left picture, 1.5 m away.
double worst_difference_px(const Rig& a, const Rig& b) {
    double worst = 0.0;
    for (int y = 0; y < a.left.height_px; y += 20) {
        for (int x = 0; x < a.left.width_px; x += 20) {
            const auto ray = unproject(a.left.lens, {x, y});
            const Eigen::Vector3d point = 1500.0 * ray.value().direction;
            worst = std::max(worst, (project(b.left.lens, point).value_or(Eigen::Vector2d(1e9, 0)) -
                                     Eigen::Vector2d(x, y))
                                        .norm());
            const auto right = project(a.right->lens, T_right_from_left(a) * point);
            if (right && a.right->sees(*right)) {
                const auto other = project(b.right->lens, T_right_from_left(b) * point);
                worst = std::max(worst, (other.value_or(Eigen::Vector2d(1e9, 0)) - *right).norm());
            }
        }
    }
    return worst;
}

TEST_F(ConvertTest, ABrownRigComesBackFromEveryFormat) {
    const Camera left{
        BrownLens(533.0, 534.0, 341.0, 235.0, {-0.28, 0.09, 0.001, -0.0003, 0.0}), 640, 480, {}};
    const Camera right{
        BrownLens(536.0, 537.0, 326.0, 250.0, {-0.27, 0.08, -0.002, 0.0004, 0.0}), 640, 480, {}};
    const Rig rig = rig_from_pair(left, right, {rotation_about_y(0.06), {-99.8, 1.1, -2.0}});
    ASSERT_TRUE(write_rig_file(folder_ / "rig.yaml", rig));
    for (const Files& files : formats) {
        const auto back = there_and_back(files);
        ASSERT_TRUE(back) << files.format << back.error().text();
        EXPECT_LT(worst_difference_px(rig, *back), 1e-6) << files.format;
    }
}

TEST_F(ConvertTest, ATsaiRigIsFittedAndTheResidualAndWhatIsLeftOutAreTold) {
    const Rig rig = nominal_rig(Medium::water);
    ASSERT_TRUE(write_rig_file(folder_ / "rig.yaml", rig));
    for (const Files& files : {formats[0], formats[1]}) {
        const auto back = there_and_back(files);
        ASSERT_TRUE(back) << files.format << back.error().text();
        const auto told = nlohmann::json::parse(text_of(folder_ / "to.json"));
        const double residual_px = told["worst_residual_px"];
        EXPECT_GT(residual_px, 0.0);
        EXPECT_LT(residual_px, 0.05);
        EXPECT_LT(worst_difference_px(rig, *back), 1.1 * residual_px + 1e-6);
        EXPECT_EQ(told["left_out"], nlohmann::json({"pan_tilt", "medium"}));
    }
}

TEST_F(ConvertTest, MoreThanATwentiethOfAPixelIsRefusedAndNothingIsWritten) {
    ASSERT_TRUE(write_rig_file(folder_ / "rig.yaml", nominal_rig()));
    const Finished refused = convert({"rig.yaml", "--to", "kalibr", "out"});
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.errors.find("px remain"), std::string::npos) << refused.errors;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
}

}  // namespace
}  // namespace kambara
