// SPDX-License-Identifier: GPL-3.0-or-later
// The lint itself: every rule must fail on a file that breaks it, and only then.
#include "tests/lint/lint.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace kambara::lint {
namespace {

namespace fs = std::filesystem;

const std::string head = "// SPDX-License-Identifier: GPL-3.0-or-later\n#pragma once\n";

class LintTest : public testing::Test {
  protected:
    LintTest() {
        root_ =
            fs::path(testing::TempDir()) /
            (std::string("lint_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(root_);
        write("core/base/good.h", head + "#include <vector>\ninline int one() { return 1; }\n");
    }
    ~LintTest() override { fs::remove_all(root_); }

    void write(const std::string& file, const std::string& text) const {
        fs::create_directories((root_ / file).parent_path());
        std::ofstream(root_ / file) << text;
    }

    // The one fault that a file with this text gives.
    std::string only_fault(const std::string& file, const std::string& text) const {
        write(file, text);
        const auto faults = faults_of_sources(root_);
        EXPECT_EQ(faults.size(), 1U) << file;
        return faults.empty() ? "" : to_string(faults.front());
    }

    fs::path root_;
};

TEST_F(LintTest, AcceptsAGoodTree) {
    EXPECT_TRUE(faults_of_sources(root_).empty());
}

TEST_F(LintTest, RefusesAnIncludeAgainstTheDirection) {
    EXPECT_NE(only_fault("core/camera/bad.h", head + "#include \"core/stereo/position.h\"\n")
                  .find("core/camera may not include core/stereo/position.h"),
              std::string::npos);
}

TEST_F(LintTest, RefusesHardwareInCore) {
    EXPECT_NE(only_fault("core/vsystem/bad.h", head + "#include \"hardware/media/open_media.h\"\n"),
              "");
}

TEST_F(LintTest, RefusesHardwareInTheFrontEnd) {
    EXPECT_NE(only_fault("ui/bad.h", head + "#include \"hardware/media/open_media.h\"\n"), "");
}

TEST_F(LintTest, RefusesOneDeviceFamilyInAnother) {
    EXPECT_NE(
        only_fault("hardware/media/bad.h", head + "#include \"hardware/simulated/scene.h\"\n"), "");
}

TEST_F(LintTest, LetsTheSimulationSeeTheTargetButNoMoreOfCalibration) {
    write("hardware/simulated/good.h", head + "#include \"core/calibration/target.h\"\n");
    EXPECT_TRUE(faults_of_sources(root_).empty());
    EXPECT_NE(only_fault("hardware/simulated/bad.h",
                         head + "#include \"core/calibration/calibrator.h\"\n"),
              "");
}

TEST_F(LintTest, RefusesQtAndVtkInCoreAndHardware) {
    EXPECT_NE(only_fault("core/base/bad.h", head + "#include <QString>\n").find("Qt"),
              std::string::npos);
    fs::remove(root_ / "core/base/bad.h");
    EXPECT_NE(only_fault("hardware/media/bad.h", head + "#include <vtkActor.h>\n").find("VTK"),
              std::string::npos);
    fs::remove(root_ / "hardware/media/bad.h");
    write("ui/good.h", head + "#include <QWidget>\n");
    EXPECT_TRUE(faults_of_sources(root_).empty());
}

TEST_F(LintTest, RefusesOperatingSystemHeadersInCoreOnly) {
    EXPECT_NE(only_fault("core/base/bad.h", head + "#include <unistd.h>\n"), "");
    fs::remove(root_ / "core/base/bad.h");
    EXPECT_NE(only_fault("core/base/bad.h", head + "#include <sys/mman.h>\n"), "");
    fs::remove(root_ / "core/base/bad.h");
    write("hardware/v4l2/good.h", head + "#include <sys/ioctl.h>\n");
    EXPECT_TRUE(faults_of_sources(root_).empty());
}

TEST_F(LintTest, RefusesAFilePastSixHundredLines) {
    std::string text = head;
    for (int i = 0; i < 599; ++i) {
        text += "//\n";
    }
    EXPECT_NE(only_fault("core/base/long.h", text).find("601 lines"), std::string::npos);
}

TEST_F(LintTest, RefusesAMissingLicenceOrGuard) {
    EXPECT_NE(only_fault("app/bad.h", "#pragma once\n").find("licence"), std::string::npos);
    fs::remove(root_ / "app/bad.h");
    EXPECT_NE(only_fault("app/bad.h", "// SPDX-License-Identifier: GPL-3.0-or-later\n")
                  .find("#pragma once"),
              std::string::npos);
}

TEST_F(LintTest, RefusesARoomThatIsNotInTheTable) {
    EXPECT_NE(only_fault("core/attic/bad.h", head + "#include \"core/base/good.h\"\n")
                  .find("not in the table"),
              std::string::npos);
}

TEST_F(LintTest, RefusesAHeaderThatDoesNotCompileAlone) {
    const std::string compiler = std::string(KAMBARA_CXX) + " -std=c++20 2>/dev/null";
    EXPECT_TRUE(faults_of_headers(root_, compiler).empty());
    write("core/base/bad.h", head + "inline std::vector<int> none() { return {}; }\n");
    const auto faults = faults_of_headers(root_, compiler);
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults.front().file, "core/base/bad.h");
}

}  // namespace
}  // namespace kambara::lint
