// SPDX-License-Identifier: GPL-3.0-or-later
// Bad input, as a user would give it to the program: a sentence with cause and remedy on standard
// error, exit code 1 (2 for wrong usage), and nothing half written.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/core.hpp>
#include <opencv2/videoio.hpp>
#include <set>
#include <string>
#include <vector>

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

class BadInputTest : public testing::Test {
  protected:
    // A short recording of the simulated rig, made once.
    static void SetUpTestSuite() {
        recording_ = fresh_folder("bad_input_recording");
        const SimulatedWorld world(*simulated_profile("default?particles=0"));
        for (const char* side : {"left", "right"}) {
            fs::create_directories(recording_ / side);
        }
        for (int i = 0; i < 4; ++i) {
            const std::string name = "00000" + std::to_string(i) + ".png";
            ASSERT_TRUE(
                write_picture(recording_ / "left" / name, world.picture(FixedCamera::left, i)));
            ASSERT_TRUE(
                write_picture(recording_ / "right" / name, world.picture(FixedCamera::right, i)));
        }
        good_template_ = to_string(world.suggested_template(31));
        ASSERT_TRUE(write_rig_file(recording_ / "rig.yaml", world.rig()));
    }
    static void TearDownTestSuite() { fs::remove_all(recording_); }

    void SetUp() override {
        folder_ = fresh_folder(testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::copy(recording_, folder_, fs::copy_options::recursive);
        before_ = names();
    }
    void TearDown() override { fs::remove_all(folder_); }

    std::set<std::string> names() const {
        std::set<std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
            all.insert(entry.path().string());
        }
        return all;
    }

    Finished run(const std::vector<std::string>& arguments) const {
        return run_program(KAMBARA_CLI, arguments, folder_);
    }

    std::vector<std::string> track(const std::string& templ, const std::string& rig = "rig.yaml",
                                   const std::string& left = "left/%06d.png",
                                   const std::string& right = "right/%06d.png") const {
        return {"track", "--rig",      rig,   "--left", left,     "--right",
                right,   "--template", templ, "--csv",  "out.csv"};
    }

    // Refused with both cause and remedy, and the folder is as it was.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& cause,
                        const std::string& remedy) {
        before_ = names();
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.exit_code, 1) << finished.errors;
        EXPECT_NE(finished.errors.find(cause), std::string::npos) << finished.errors;
        EXPECT_NE(finished.errors.find(remedy), std::string::npos) << finished.errors;
        EXPECT_EQ(std::count(finished.errors.begin(), finished.errors.end(), '\n'), 1)
            << finished.errors;
        EXPECT_EQ(names(), before_);
    }

    // Likewise midway: the table holds what was tracked before.
    void expect_cut_short(const std::vector<std::string>& arguments, const std::string& cause,
                          const std::string& remedy) {
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.exit_code, 1) << finished.errors;
        for (const std::string& part : {cause, remedy, std::string("is in out.csv")}) {
            EXPECT_NE(finished.errors.find(part), std::string::npos) << finished.errors;
        }
        EXPECT_FALSE(testing_support::rows_of_csv(folder_ / "out.csv").empty());
        EXPECT_TRUE(fs::remove(folder_ / "out.csv"));
    }

    static fs::path recording_;
    static std::string good_template_;
    fs::path folder_;
    std::set<std::string> before_;
};

fs::path BadInputTest::recording_;
std::string BadInputTest::good_template_;

TEST_F(BadInputTest, TheGoodCaseItselfWorks) {
    const Finished finished = run(track(good_template_));
    EXPECT_EQ(finished.exit_code, 0) << finished.errors;
    EXPECT_EQ(testing_support::rows_of_csv(folder_ / "out.csv").size(), 4U);
}

TEST_F(BadInputTest, SinglePicturesComeAtTheRateThatIsGiven) {
    auto arguments = track(good_template_);
    arguments.insert(arguments.end(), {"--rate", "4"});
    EXPECT_EQ(run(arguments).exit_code, 0);
    const auto rows = testing_support::rows_of_csv(folder_ / "out.csv");
    ASSERT_EQ(rows.size(), 4U);
    EXPECT_EQ(rows[3][1], "0.750000");
}

TEST_F(BadInputTest, WrongUsageIsTwo) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{},
          {"dance"},
          {"track"},
          {"track", "--no-such-option"},
          {"match", "only-one.png"},
          {"convert", "rig.yaml"},
          {"convert", "--from", "kitti", "calib.txt"},
          {"convert", "--from", "kitti", "--to", "ros", "calib.txt", "out"},
          {"simulate", "--out", "x", "--seconds", "-3"},
          {"match", "left/000000.png", "left/000001.png", "--measure", "ssd"},
          {"convert", "rig.yaml", "--to", "paper", "out"},
          {"convert", "--from", "opencv", "calib.txt", "--out", "x.yaml"},
          {"calibrate", "--left", "a", "--target", "chessboard:9x6:30", "--model", "tsai", "--out",
           "x.yaml"},
          {"calibrate", "--left", "a", "--target", "chessboard:9x6:30", "--baseline", "100",
           "--out", "x.yaml"},
          {"track", "--left", "a", "--template", "100,100,31", "--csv", "x"},
          {"track", "--left", "a", "--template", "100,100,-31,31", "--csv", "x"},
          {"track", "--left", "a", "--template", "1,2,31,31", "--csv", "x", "--steer", "3"},
          {"track", "--left", "a", "--template", "1,2,31,31", "--csv", "x", "--frame", "bogus"},
          {"track", "--left", "a", "--template", "1,2,31,31", "--csv", "x", "--measure", "hamming"},
          {"match", "a.png", "b.png", "--measure", "hamming"},
          {"track", "--left", "a", "--template", "auto", "--csv", "x", "--rate", "0"}}) {
        const Finished finished = run(arguments);
        EXPECT_EQ(finished.exit_code, 2) << finished.errors;
        EXPECT_FALSE(finished.errors.empty() && finished.output.empty());
    }
    EXPECT_EQ(run({"--help"}).exit_code, 0);
    EXPECT_EQ(run({"track", "--help"}).exit_code, 0);
}

TEST_F(BadInputTest, APictureThatIsMissingBetweenOthersIsNamed) {
    fs::remove(folder_ / "left" / "000002.png");
    expect_refused(track(good_template_), "left/000002.png is missing", "name them by *");
    expect_refused(track(good_template_, "rig.yaml", "left/*.png", "right/*.png"),
                   "right/000002.png has no partner", "Bring its partner");
}

TEST_F(BadInputTest, MissingFiles) {
    expect_refused(track(good_template_, "no.yaml"), "There is no file no.yaml", "Check the name");
    expect_refused(track(good_template_, "rig.yaml", "nowhere/%06d.png"), "No file fits",
                   "Check the folder");
    expect_refused(track(good_template_, "rig.yaml", "no.mkv"), "There is no file no.mkv", "Check");
    expect_refused(track(good_template_, "rig.yaml", "left"), "is a folder", "Name its pictures");
    expect_refused(track(good_template_, "rig.yaml", "v4l2:/dev/video0"),
                   "no driver for the source", "Give a video file");
    expect_refused({"track", "--left", "sim:default", "--template", "auto", "--pan-tilt",
                    "pelco:/dev/ttyS0", "--csv", "out.csv"},
                   "no driver for the pan-tilt head pelco:/dev/ttyS0", "visca:/dev/ttyS0");
    expect_refused({"track", "--left", "sim:default", "--template", "auto", "--pan-tilt",
                    "visca:/dev/ttyS0", "--csv", "out.csv"},
                   "too fast for a real head", "Use the command live");
    expect_refused({"match", "no.png", "left/000000.png"}, "There is no file no.png", "Check");
    expect_refused({"convert", "--from", "kitti", "no.txt", "--out", "x.yaml"},
                   "There is no file no.txt", "Check");
    expect_refused({"triangulate", "--rig", "rig.yaml", "--points", "no.txt"},
                   "There is no file no.txt", "Check");
    expect_refused(
        {"calibrate", "--left", "no*.png", "--target", "chessboard:9x6:30", "--out", "x.yaml"},
        "No file fits the pattern", "Check the folder");
}

TEST_F(BadInputTest, ATruncatedVideo) {
    const std::string whole = (folder_ / "whole.avi").string();
    {
        cv::VideoWriter writer(whole, cv::CAP_FFMPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                               30.0, {640, 480}, false);
        ASSERT_TRUE(writer.isOpened());
        for (int i = 0; i < 20; ++i) {
            const auto picture =
                read_picture(folder_ / "left" / ("00000" + std::to_string(i % 4) + ".png"));
            ASSERT_TRUE(picture);
            writer.write(cv::Mat(480, 640, CV_8UC1, const_cast<std::uint8_t*>(picture->row(0))));
        }
    }
    const std::string bytes = text_of(whole);
    std::ofstream(folder_ / "cut.avi", std::ios::binary)
        .write(bytes.data(), static_cast<std::streamsize>(bytes.size() / 2));
    EXPECT_EQ(run({"track", "--rig", "rig.yaml", "--left", "whole.avi", "--template",
                   good_template_, "--csv", "whole.csv"})
                  .exit_code,
              0);
    expect_cut_short({"track", "--rig", "rig.yaml", "--left", "cut.avi", "--template",
                      good_template_, "--csv", "out.csv"},
                     "cut short", "Copy it again");
    std::ofstream(folder_ / "stub.avi", std::ios::binary).write(bytes.data(), 40);
    expect_refused({"track", "--rig", "rig.yaml", "--left", "stub.avi", "--template",
                    good_template_, "--csv", "out.csv"},
                   "can't be read as a video", "Check that it plays");
}

TEST_F(BadInputTest, ATruncatedPicture) {
    const std::string bytes = text_of(folder_ / "left/000002.png");
    std::ofstream(folder_ / "left/000002.png", std::ios::binary).write(bytes.data(), 100);
    expect_cut_short(track(good_template_), "000002.png can't be read as a picture",
                     "Check the file");
}

TEST_F(BadInputTest, PicturesOfDifferentSizes) {
    ASSERT_TRUE(write_picture(folder_ / "left/000002.png", Image(320, 240, 1, 90)));
    expect_cut_short(track(good_template_), "320 x 240", "one size");
    for (int i = 0; i < 4; ++i) {
        ASSERT_TRUE(write_picture(folder_ / "right" / ("00000" + std::to_string(i) + ".png"),
                                  Image(320, 240, 1, 90)));
    }
    fs::copy_file(recording_ / "left/000002.png", folder_ / "left/000002.png",
                  fs::copy_options::overwrite_existing);
    expect_refused(track(good_template_), "the right ones 320 x 240", "same size");
}

TEST_F(BadInputTest, ARigFileWithAMissingOrAbsurdValue) {
    const std::string good = text_of(folder_ / "rig.yaml");
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string text = good;
        const auto at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        text.replace(at, what.size(), instead);
        std::ofstream(folder_ / "bad.yaml") << text;
        return track(good_template_, "bad.yaml");
    };
    expect_refused(with("f_mm:", "g_mm:"), "cameras.left.lens.f_mm is missing", "Mend the file");
    expect_refused(with("f_mm: 2.8", "f_mm: -2.8"), "f_mm", "Mend the file");
    expect_refused(with("sx: 1.03", "sx: 7.03"), "sx", "Mend the file");
    expect_refused(with("length: mm", "length: m"), "units.length", "Mend the file");
    expect_refused(with("medium: air", "medium: oil"), "medium", "Mend the file");
    expect_refused(with("kambara_rig: 1", "kambara_rig: 2"), "version", "Mend the file");
    expect_refused(with("model: tsai", "model: [tsai"), "not valid YAML", "Mend the file");
}

TEST_F(BadInputTest, TemplatesThatCannotBeFollowed) {
    expect_refused(track("620,10,31,31"), "not inside the picture", "wholly inside");
    expect_refused(track("40,20,31,31"), "no texture", "marks or edges");  // open water
    expect_refused(track("100,100,3,3"), "too small", "at least 7 x 7");
    expect_refused(track("auto"), "Only a simulated rig", "--template X,Y,W,H");
}

TEST_F(BadInputTest, LeftAndRightOfDifferentLength) {
    fs::remove(folder_ / "right/000003.png");
    expect_cut_short(track(good_template_), "different lengths",
                     "two recordings of the same instants");
    expect_refused({"calibrate", "--left", "left/*.png", "--right", "right/*.png", "--target",
                    "chessboard:9x6:30", "--out", "x.yaml"},
                   "4 left and 3 right pictures", "Give pairs");
}

TEST_F(BadInputTest, ACalibrationWithoutATargetInSight) {
    expect_refused({"calibrate", "--left", "left/000000.png", "--right", "right/000000.png",
                    "--target", "chessboard:9x6:30", "--out", "x.yaml"},
                   "refused", "No rig file was written");
    expect_refused(
        {"calibrate", "--left", "left/*.png", "--target", "chessboard:9", "--out", "x.yaml"},
        "chessboard:9", "chessboard:9x6:30");
}

TEST_F(BadInputTest, TheJsonIsWrittenAlsoWhenRefused) {
    const Finished finished =
        run({"calibrate", "--left", "left/000000.png", "--right", "right/000000.png", "--target",
             "chessboard:9x6:30", "--out", "x.yaml", "--json", "-"});
    EXPECT_EQ(finished.exit_code, 1);
    EXPECT_NE(finished.output.find("\"verdict\": \"refused\""), std::string::npos);
    EXPECT_NE(finished.output.find("\"accepted\": false"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder_ / "x.yaml"));
}

TEST_F(BadInputTest, EveryCommandsJsonSaysWhyItWasRefused) {
    for (const std::vector<std::string>& arguments :
         {track("620,10,31,31"),
          {"live", "--profile", "storm"},
          {"simulate", "--profile", "storm", "--out", "sim"},
          {"triangulate", "--rig", "no.yaml", "--points", "no.txt"},
          {"convert", "--from", "kitti", "no.txt", "--out", "x.yaml"},
          {"match", "no.png", "left/000000.png"}}) {
        auto with_json = arguments;
        with_json.insert(with_json.end(), {"--json", "-"});
        const Finished finished = run(with_json);
        EXPECT_EQ(finished.exit_code, 1);
        EXPECT_NE(finished.output.find("\"error\""), std::string::npos) << arguments.front();
    }
}

TEST_F(BadInputTest, ARefusedResultLeavesTheOldFile) {
    std::ofstream(folder_ / "x.yaml") << "old";
    std::ofstream(folder_ / "out.csv") << "old";
    EXPECT_EQ(run({"calibrate", "--left", "left/000000.png", "--right", "right/000000.png",
                   "--target", "chessboard:9x6:30", "--out", "x.yaml"})
                  .exit_code,
              1);
    EXPECT_EQ(run(track("620,10,31,31")).exit_code, 1);
    EXPECT_EQ(text_of(folder_ / "x.yaml"), "old");
    EXPECT_EQ(text_of(folder_ / "out.csv"), "old");
}

TEST_F(BadInputTest, AnInputIsNotOverwritten) {
    auto arguments = track(good_template_);
    arguments.back() = "./rig.yaml";
    const std::string before = text_of(folder_ / "rig.yaml");
    const Finished finished = run(arguments);
    EXPECT_EQ(finished.exit_code, 2);
    EXPECT_NE(finished.errors.find("would be overwritten"), std::string::npos) << finished.errors;
    EXPECT_EQ(text_of(folder_ / "rig.yaml"), before);
    arguments = track(good_template_);
    arguments.insert(arguments.end(), {"--json", "out.csv"});
    EXPECT_EQ(run(arguments).exit_code, 2);
}

// What came before a damaged picture was tracked and is kept.
TEST_F(BadInputTest, ADamagedPictureLeavesTheRowsBeforeIt) {
    std::ofstream(folder_ / "left" / "000002.png", std::ios::trunc);
    const Finished finished = run(track(good_template_));
    EXPECT_EQ(finished.exit_code, 1);
    EXPECT_NE(finished.errors.find("2 frames, is in out.csv"), std::string::npos)
        << finished.errors;
    EXPECT_EQ(testing_support::rows_of_csv(folder_ / "out.csv").size(), 2U);
}

TEST_F(BadInputTest, TablesThatCannotBeWritten) {
    auto arguments = track(good_template_);
    arguments.back() = "no/such/folder/out.csv";
    expect_refused(arguments, "can't be written", "folder exists");
}

TEST_F(BadInputTest, MalformedPointsAndProfiles) {
    std::ofstream(folder_ / "points.txt") << "1 2 3 4\n5 6 seven 8\n";
    expect_refused({"triangulate", "--rig", "rig.yaml", "--points", "points.txt"}, "Line 2",
                   "xl yl xr yr");
    expect_refused({"simulate", "--profile", "storm", "--out", "sim"}, "\"storm\"", "default");
    expect_refused({"simulate", "--profile", "default?noise=-1", "--out", "sim"}, "noise=-1",
                   "default");
    expect_refused({"simulate", "--out", "left"}, "not empty", "new folder");
    expect_refused({"match", "left/000000.png", "left/000001.png", "--map", "map.png"}, ".tiff",
                   "end in .tiff");
}

}  // namespace
}  // namespace kambara
