// SPDX-License-Identifier: GPL-3.0-or-later
// compare-methods as a user runs it: what it writes, and what it refuses.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/cli/compare_run.h"
#include "tests/support/process.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;
using testing_support::run_program;
using testing_support::text_of;

class CompareMethods : public testing::Test {
  protected:
    void SetUp() override {
        folder_ = testing_support::fresh_folder(
            testing::UnitTest::GetInstance()->current_test_info()->name());
        const auto made = run_program(
            KAMBARA_CLI,
            {"simulate", "--profile", "default?particles=0", "--seconds", "0.2", "--out", "sea"},
            folder_);
        ASSERT_EQ(made.exit_code, 0) << made.errors;
        templ_ = text_of(folder_ / "sea" / "template.txt");
        templ_.erase(templ_.find_last_not_of(" \n\r") + 1);
    }
    void TearDown() override { fs::remove_all(folder_); }

    testing_support::Finished compare(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "compare-methods");
        return run_program(KAMBARA_CLI, arguments, folder_);
    }

    fs::path folder_;
    std::string templ_;
};

TEST_F(CompareMethods, TellsOfOneCameraWithoutATruth) {
    const auto finished = compare({"--left", "sea/left/*.png", "--template", templ_, "--report",
                                   "page.html", "--json", "result.json"});
    ASSERT_EQ(finished.exit_code, 0) << finished.errors;
    const auto json = nlohmann::json::parse(text_of(folder_ / "result.json"));
    EXPECT_EQ(json["default"]["measure"], to_string(default_method().measure));
    EXPECT_EQ(json["default"]["transform"], to_string(default_method().transform));
    ASSERT_EQ(json["scenes"].size(), 1U);
    const auto& scene = json["scenes"][0];
    EXPECT_EQ(scene["reference"], "median of all methods");
    EXPECT_EQ(scene["methods"].size(), 20U);
    const auto& first = scene["methods"][0];
    EXPECT_EQ(first["there_and_back_fraction"], 1.0);
    EXPECT_TRUE(first["range_error_mean_pct"].is_null());
    EXPECT_GT(first["ms_median"], 0.0);
    EXPECT_TRUE(json["attenuation"].empty());
    const std::string page = text_of(folder_ / "page.html");
    for (const char* part : {"The default is ", "There is no truth.", "there+back %", "<svg",
                             "hamming after census", "</html>"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
    EXPECT_NE(finished.output.find("The default is " + label_of(default_method())),
              std::string::npos);
}

TEST_F(CompareMethods, MeasuresARecordingByItsTruthAndWaterByAttenuation) {
    const auto finished =
        compare({"--left", "sea/left/*.png", "--right", "sea/right/*.png", "--rig", "sea/rig.yaml",
                 "--truth", "sea/truth.csv", "--template", templ_, "--scenes", "turbid-0.5",
                 "--seconds", "0.2", "--report", "page.html", "--json", "-"});
    ASSERT_EQ(finished.exit_code, 0) << finished.errors;
    const auto json = nlohmann::json::parse(finished.output);
    ASSERT_EQ(json["scenes"].size(), 2U);
    for (const auto& scene : json["scenes"]) {
        EXPECT_EQ(scene["reference"], "truth");
        EXPECT_EQ(scene["methods"][0]["on_reference_fraction"], 1.0);
        EXPECT_LT(scene["methods"][0]["range_error_mean_pct"], 0.3);
    }
    EXPECT_FALSE(json["attenuation"].empty());
    EXPECT_EQ(json["verdict"].size(), 4U);
    const std::string page = text_of(folder_ / "page.html");
    for (const char* part : {"range error %", "attenuation lengths", "are asked for", "<path"}) {
        EXPECT_NE(page.find(part), std::string::npos) << part;
    }
}

TEST_F(CompareMethods, RefusesWhatItCannotCompare) {
    const std::vector<std::string> recording{"--left", "sea/left/*.png", "--report", "page.html"};
    const auto expect_refused = [&](std::vector<std::string> more, const std::string& why) {
        const auto finished = compare(more);
        EXPECT_EQ(finished.exit_code, 1) << why;
        EXPECT_NE(finished.errors.find(why), std::string::npos) << finished.errors;
        EXPECT_FALSE(fs::exists(folder_ / "page.html"));
    };
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), recording.begin(), recording.end());
        return more;
    };
    expect_refused(recording, "--template X,Y,W,H");
    expect_refused(with({"--template", "5000,5,31,31"}), "5000");
    expect_refused(with({"--template", templ_, "--truth", "sea/rig.yaml"}), "first frame");
    expect_refused(with({"--template", "20,20,31,31", "--truth", "sea/truth.csv"}),
                   "px from the point");
    expect_refused({"--scenes", "lava"}, "lava");
    expect_refused({"--template", templ_, "--scenes", "air"}, "no recording");
}

}  // namespace
}  // namespace kambara::cli
