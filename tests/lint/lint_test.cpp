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

TEST_F(LintTest, RefusesWaysRoundTheDirections) {
    for (const char* include : {"\"../stereo/position.h\"", "\"position.h\"", "POSITION_HEADER"}) {
        EXPECT_NE(only_fault("core/camera/bad.h", head + "#include " + include + "\n")
                      .find("named from the project's root"),
                  std::string::npos);
    }
    fs::remove(root_ / "core/camera/bad.h");
    EXPECT_NE(only_fault("core/camera/bad.inl", head).find("end in .h or .cpp"), std::string::npos);
}

TEST_F(LintTest, LetsTheFrontEndSeeTheDoorAndTheSnapshotsOnly) {
    write("ui/good.h", head + "#include \"core/vsystem/vsystem_interface.h\"\n");
    write("ui/good.h", head + "#include \"core/vsystem/snapshot.h\"\n");
    EXPECT_TRUE(faults_of_sources(root_).empty());
    for (const char* include : {"core/vsystem/pipeline.h", "core/tracking/stereo_tracker.h"}) {
        EXPECT_NE(only_fault("ui/bad.h", head + "#include \"" + include + "\"\n"), "");
    }
}

TEST_F(LintTest, LetsTheCalibrationWindowAloneSeeCalibration) {
    const std::string text = head + "#include \"core/calibration/target.h\"\n";
    write("ui/calibration/good.h", text);
    EXPECT_TRUE(faults_of_sources(root_).empty());
    EXPECT_NE(only_fault("ui/video/bad.h", text), "");
    fs::remove(root_ / "ui/video/bad.h");
    EXPECT_NE(
        only_fault("ui/calibration/bad.h", head + "#include \"core/vsystem/vision_system.h\"\n"),
        "");
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
                         head + "#include \"core/calibration/rig_calibrator.h\"\n"),
              "");
}

TEST_F(LintTest, RefusesQtAndVtkInCoreAndHardware) {
    for (const char* include :
         {"<QString>", "<QtGlobal>", "<QtWidgets>", "<QtCore/QString>", "<qglobal.h>",
          "<QVTKOpenGLStereoWidget.h>", "<vtkActor.h>", "<vtk-9.1/vtkActor.h>"}) {
        for (const char* file : {"core/base/bad.h", "hardware/media/bad.h"}) {
            EXPECT_NE(only_fault(file, head + "#include " + include + "\n").find("Qt and VTK"),
                      std::string::npos)
                << include;
            fs::remove(root_ / file);
        }
    }
    write("ui/good.h", head + "#include <QWidget>\n");
    EXPECT_TRUE(faults_of_sources(root_).empty());
}

TEST_F(LintTest, RefusesVtkOutsideThe3dView) {
    write("ui/scene3d/good.h", head + "#include <vtkActor.h>\n");
    EXPECT_TRUE(faults_of_sources(root_).empty());
    EXPECT_NE(only_fault("ui/plots/bad.h", head + "#include <vtkActor.h>\n").find("ui/scene3d"),
              std::string::npos);
}

TEST_F(LintTest, RefusesOperatingSystemHeadersInCoreOnly) {
    for (const char* include : {"unistd.h", "sys/mman.h", "ifaddrs.h", "csignal"}) {
        EXPECT_NE(only_fault("core/base/bad.h", head + "#include <" + include + ">\n")
                      .find("no operating system"),
                  std::string::npos)
            << include;
    }
    fs::remove(root_ / "core/base/bad.h");
    write("hardware/v4l2/good.h", head + "#include <sys/ioctl.h>\n#include <unistd.h>\n");
    write("core/base/good.h", head + "#include <vector>\n#include <yaml-cpp/yaml.h>\n");
    EXPECT_TRUE(faults_of_sources(root_).empty());
}

TEST_F(LintTest, RefusesAFilePastSixHundredLines) {
    std::string text = head;
    for (int i = 0; i < 599; ++i) {
        text += "//\n";
    }
    EXPECT_NE(only_fault("core/base/long.h", text).find("601 lines"), std::string::npos);
}

TEST_F(LintTest, RefusesAFileOfTheFrontEndPastFourHundredLines) {
    std::string text = head;
    for (int i = 0; i < 399; ++i) {
        text += "//\n";
    }
    EXPECT_NE(only_fault("ui/long.h", text).find("401 lines"), std::string::npos);
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
