// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/calibration_session.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "hardware/media/picture_file.h"
#include "tests/core/calibration/session/session_samples.h"

namespace kambara {
namespace {

using namespace testing_support;
namespace fs = std::filesystem;

// A folder that is there for one test.
class Folder {
  public:
    Folder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        path_ = fs::path(testing::TempDir()) / (std::string("session_") + test->name());
        fs::remove_all(path_);
    }
    ~Folder() {
        std::error_code code;
        fs::remove_all(path_, code);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

const Rig rig = built_rig(false);
const Target board = ChessboardTarget{9, 6, 30.0};
const PictureSet grey_pictures{std::make_shared<Image>(640, 480), std::make_shared<Image>(640, 480),
                               nullptr};

SessionSetup board_setup() {
    return setup_for(rig, board, LensModel::tsai);
}

// Views at random, each different.
std::vector<RigView> board_views(int count, unsigned seed = 3) {
    std::mt19937 random(seed);
    Showing how;
    how.views = count;
    how.nearest_mm = 500.0;
    how.pan_tilt = false;
    how.turn_deg = 35.0;
    how.noise_px = 0.1;
    return views_of(rig, board, how, random);
}

void show(CalibrationSession& session, const std::vector<RigView>& views) {
    for (const RigView& view : views) {
        const auto look = session.capture(view, grey_pictures);
        ASSERT_TRUE(look);
        ASSERT_TRUE(look->shot) << look->why_not;
    }
}

// Everything about a session that its user could see.
void expect_equal(const CalibrationSession& a, const CalibrationSession& b) {
    ASSERT_EQ(a.shots().size(), b.shots().size());
    for (std::size_t i = 0; i < a.shots().size(); ++i) {
        EXPECT_EQ(shot_to_text(a.shots()[i]), shot_to_text(b.shots()[i]));
        EXPECT_EQ(a.shots()[i].kept, b.shots()[i].kept);
    }
    EXPECT_EQ(a.setup().target, b.setup().target);
    EXPECT_EQ(a.setup().cameras, b.setup().cameras);
    EXPECT_EQ(a.setup().sensor, b.setup().sensor);
    EXPECT_EQ(a.can_undo(), b.can_undo());
    EXPECT_EQ(a.coverage().pictures[0].views, b.coverage().pictures[0].views);
    EXPECT_NEAR(a.coverage().farthest_mm, b.coverage().farthest_mm, 1e-6);
    EXPECT_NEAR(a.predicted_range_error(), b.predicted_range_error(), 1e-9);
    const auto next_a = a.what_next();
    const auto next_b = b.what_next();
    ASSERT_TRUE(next_a && next_b);
    EXPECT_TRUE(next_a->T_left_from_target.t_mm.isApprox(next_b->T_left_from_target.t_mm, 1e-9));
    EXPECT_EQ(a.problem().numbers, b.problem().numbers);
}

TEST(CalibrationSession, CapturesWhatIsHeldStillOnce) {
    auto session = CalibrationSession::begin(board_setup());
    ASSERT_TRUE(session);
    const auto views = board_views(2);
    int captured = 0;
    for (int picture = 0; picture < 10; ++picture) {
        const auto look = session->look(views[0]);
        ASSERT_TRUE(look);
        captured += look->shot ? 1 : 0;
        EXPECT_EQ(look->shot.has_value(), picture == 3) << look->why_not;
    }
    EXPECT_EQ(captured, 1);
    // Dropped by hand it is not taken again while the target stays there; moved, and back, it is.
    ASSERT_TRUE(session->drop(1));
    EXPECT_FALSE(session->look(views[0])->shot);
    for (const int which : {1, 1, 1, 1, 0, 0, 0, 0}) {
        ASSERT_TRUE(session->look(views[static_cast<std::size_t>(which)]));
    }
    EXPECT_EQ(session->shots().size(), 3U);
}

TEST(CalibrationSession, AnyCameraFailingRepeatsTheShot) {
    auto session = CalibrationSession::begin(board_setup());
    RigView view = board_views(1)[0];
    view.sights[1].corners.clear();
    view.sights[1].fault = "The board is cut off.";
    for (int picture = 0; picture < 6; ++picture) {
        const auto look = session->look(view);
        ASSERT_TRUE(look);
        EXPECT_FALSE(look->shot);
        EXPECT_NE(look->why_not.find("right camera"), std::string::npos);
        EXPECT_NE(look->why_not.find("cut off"), std::string::npos);
    }
    EXPECT_FALSE(session->capture(view)->shot);
    EXPECT_TRUE(session->shots().empty());
}

TEST(CalibrationSession, RefusesPicturesOfAnotherSize) {
    auto session = CalibrationSession::begin(board_setup());
    PictureSet pictures = grey_pictures;
    pictures[1] = std::make_shared<Image>(320, 240);
    const auto look = session->capture(board_views(1)[0], pictures);
    EXPECT_FALSE(look->shot);
    EXPECT_NE(look->why_not.find("size"), std::string::npos);
}

TEST(CalibrationSession, DropsKeepsAndUndoes) {
    auto session = CalibrationSession::begin(board_setup());
    show(*session, board_views(4));
    EXPECT_FALSE(session->undo());
    ASSERT_TRUE(session->drop(2));
    ASSERT_TRUE(session->drop(4));
    ASSERT_TRUE(session->drop(4));  // is so already: no decision
    ASSERT_TRUE(session->keep(2));
    EXPECT_EQ(session->problem().numbers, (std::vector<int>{1, 2, 3}));
    ASSERT_TRUE(session->undo());
    EXPECT_EQ(session->problem().numbers, (std::vector<int>{1, 3}));
    ASSERT_TRUE(session->undo());
    EXPECT_EQ(session->problem().numbers, (std::vector<int>{1, 3, 4}));
    ASSERT_TRUE(session->undo());
    EXPECT_EQ(session->problem().numbers, (std::vector<int>{1, 2, 3, 4}));
    EXPECT_FALSE(session->can_undo());
    EXPECT_FALSE(session->drop(9));
}

TEST(CalibrationSession, TellsWhatIsCovered) {
    auto session = CalibrationSession::begin(board_setup());
    EXPECT_EQ(session->coverage().pictures[0].share, 0.0);
    EXPECT_TRUE(session->coverage().poses.empty());
    const auto views = board_views(12);
    show(*session, views);
    const Coverage coverage = session->coverage();
    EXPECT_EQ(coverage.poses.size(), 12U);
    EXPECT_GT(coverage.pictures[0].share, 0.3);
    EXPECT_GT(coverage.pictures[1].share, 0.3);
    EXPECT_EQ(coverage.pictures[2].share, 0.0);
    EXPECT_LT(coverage.nearest_mm, coverage.farthest_mm);
    EXPECT_GT(coverage.widest_slant_deg, 15.0);
    EXPECT_LT(coverage.widest_slant_deg, 60.0);
    const double all = session->predicted_range_error();
    ASSERT_TRUE(session->drop(1));
    EXPECT_GT(session->predicted_range_error(), all);
}

TEST(CalibrationSession, ResumedItIsTheOneThatWasLeft) {
    const Folder folder;
    SessionSetup setup = board_setup();
    setup.baseline = KnownBaseline{466.0, 2.0};
    setup.expected = nominal_rig();
    auto session = CalibrationSession::begin(setup, {}, folder.path(), write_picture);
    ASSERT_TRUE(session);
    show(*session, board_views(10));
    ASSERT_TRUE(session->drop(3));
    ASSERT_TRUE(session->drop(5));
    const auto report = session->problem().solve();
    ASSERT_NE(report.verdict, Verdict::refused);
    ASSERT_TRUE(session->learn(report));

    auto again = CalibrationSession::resume(folder.path(), write_picture);
    ASSERT_TRUE(again) << again.error().text();
    expect_equal(*session, *again);
    EXPECT_EQ(again->setup().baseline->baseline_mm, 466.0);
    ASSERT_TRUE(again->setup().expected);
    const auto report_again = again->problem().solve();
    EXPECT_EQ(report_again.verdict, report.verdict);
    EXPECT_DOUBLE_EQ(report_again.rms_px, report.rms_px);
    // It goes on where it was.
    ASSERT_TRUE(again->undo());
    EXPECT_EQ(again->problem().numbers.back(), 10);
    EXPECT_EQ(again->problem().numbers.size(), 9U);
    const auto look = again->capture(board_views(1, 77)[0], grey_pictures);
    ASSERT_TRUE(look && look->shot);
    EXPECT_EQ(*look->shot, 11);
    for (const char* camera : {"left", "right"}) {
        const auto picture = read_picture(folder.path() / camera / "0011.png");
        ASSERT_TRUE(picture);
        EXPECT_EQ(*picture, *grey_pictures[0]);
    }
}

TEST(CalibrationSession, BeginsNoSessionOverAnother) {
    const Folder folder;
    ASSERT_TRUE(CalibrationSession::begin(board_setup(), {}, folder.path(), write_picture));
    const auto second = CalibrationSession::begin(board_setup(), {}, folder.path(), write_picture);
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().cause.find("already"), std::string::npos);
    EXPECT_FALSE(CalibrationSession::resume(folder.path() / "elsewhere", write_picture));
}

TEST(CalibrationSession, ADiskThatFailsCapturesNothing) {
    const Folder folder;
    const PictureWriter full = [](const fs::path& path, const Image&) -> Result<Done> {
        return Error{path.filename().string() + " can't be written: the disk is full.", ""};
    };
    auto session = CalibrationSession::begin(board_setup(), {}, folder.path(), full);
    ASSERT_TRUE(session);
    const auto view = board_views(1)[0];
    EXPECT_FALSE(session->capture(view, grey_pictures));
    EXPECT_TRUE(session->shots().empty());
    const auto again = CalibrationSession::resume(folder.path(), write_picture);
    ASSERT_TRUE(again);
    EXPECT_TRUE(again->shots().empty());
}

TEST(CalibrationSession, BrokenFilesAreRefusedByName) {
    const Folder folder;
    {
        auto session = CalibrationSession::begin(board_setup(), {}, folder.path(), write_picture);
        ASSERT_TRUE(session);
        show(*session, board_views(2));
    }
    const std::map<std::string, std::string> faults{
        {"session.yaml", "kambara_calibration_session: 1\nmodel: fisheye\n"},
        {"state.yaml", "decisions: 7\n"},
        {"target.yaml", "[]"},
        {"shots/0001.yaml",
         "kambara_calibration_shot: 1\nshot: 1\nleft: {corners: [[99, 1, 1, 1, 1]]}\n"},
        {"shots/0002.yaml", "{"}};
    for (const auto& [name, text] : faults) {
        std::string before;
        {
            std::ifstream file(folder.path() / name);
            before.assign(std::istreambuf_iterator<char>(file), {});
        }
        std::ofstream(folder.path() / name) << text;
        const auto resumed = CalibrationSession::resume(folder.path(), write_picture);
        ASSERT_FALSE(resumed) << name;
        EXPECT_NE(resumed.error().cause.find(name), std::string::npos) << resumed.error().cause;
        std::ofstream(folder.path() / name) << before;
    }
    EXPECT_TRUE(CalibrationSession::resume(folder.path(), write_picture));
}

TEST(CalibrationSession, RefusesWhatCanNotBeCalibrated) {
    SessionSetup setup = board_setup();
    setup.cameras[0].reset();
    EXPECT_FALSE(CalibrationSession::begin(setup));
    setup = board_setup();
    setup.target = PointTarget{{{0, 0, 0}, {1, 0, 0}}, {}};
    EXPECT_FALSE(CalibrationSession::begin(setup));
}

TEST(CalibrationSession, SolvesWithProgressAndStops) {
    auto session = CalibrationSession::begin(board_setup());
    show(*session, board_views(10));
    double last = 0.0;
    const auto report = session->problem().solve({}, [&last](double share) {
        EXPECT_GE(share, last);
        last = share;
    });
    EXPECT_NE(report.verdict, Verdict::refused);
    EXPECT_EQ(last, 1.0);
    std::stop_source stop;
    stop.request_stop();
    const auto stopped = session->problem().solve(stop.get_token());
    EXPECT_EQ(stopped.verdict, Verdict::refused);
    EXPECT_TRUE(session->learn(stopped));  // changes nothing
}

}  // namespace
}  // namespace kambara
