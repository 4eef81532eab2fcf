// SPDX-License-Identifier: GPL-3.0-or-later
// Somebody who knows nothing of calibration follows the screen on the simulated rig.
#include <gtest/gtest.h>

#include <QElapsedTimer>
#include <QFile>
#include <QTabWidget>
#include <QTemporaryDir>

#include "core/camera/rig_file.h"
#include "tests/ui/calibration_page.h"
#include "ui/calibration/setup_page.h"

namespace kambara {
namespace {

using testing_support::CalibrationPage;
using testing_support::WindowPage;

constexpr int two_minutes = 120;

TEST(CalibrationInTheWindow, FollowingTheScreenMakesAGoodRigWithinTwoMinutes) {
    QTemporaryDir folder;
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    CalibrationPage calibration(page);
    ASSERT_TRUE(calibration.until([&] { return calibration.can_press("beginSession"); }, 10));
    calibration.take("setup");
    QElapsedTimer since_begin;
    since_begin.start();
    calibration.choose_folder(folder.filePath("session"));
    calibration.press("beginSession");
    ASSERT_TRUE(calibration.until([&] { return calibration.shots() >= 3; }, two_minutes))
        << calibration.text("captureBanner").toStdString();
    calibration.take("capture");
    ASSERT_TRUE(calibration.until([&] { return calibration.shots() >= 12; }, two_minutes))
        << calibration.text("captureBanner").toStdString();
    calibration.take("enough");
    calibration.press("solve");
    ASSERT_TRUE(
        calibration.until([&] { return calibration.shows("calibrationVerdict"); }, two_minutes));
    std::printf("guided session: %.1f s\n", 1e-3 * static_cast<double>(since_begin.elapsed()));
    EXPECT_LT(since_begin.elapsed(), 1000 * two_minutes);
    calibration.take("result");
    for (const char* plot : {"residuals0", "residuals1", "rangeMap"}) {
        EXPECT_NO_THROW(calibration.part<QWidget>(plot)) << plot;
    }
    calibration.part<QTabWidget>("resultTabs").setCurrentIndex(1);
    calibration.take("ranges");
    calibration.part<QTabWidget>("resultTabs").setCurrentIndex(2);
    calibration.take("numbers");
    EXPECT_EQ(calibration.text("calibrationVerdict"), "Verdict: good")
        << calibration.text("calibrationReasons").toStdString();
    calibration.press("saveRig");
    ASSERT_TRUE(
        calibration.until([&] { return calibration.text("savedNote").contains("rig.yaml"); }, 20));
    calibration.press("saveReport");
    ASSERT_TRUE(calibration.until(
        [&] { return calibration.text("savedNote").contains("report.html"); }, 20));
    const auto rig = read_rig_file(folder.filePath("session/result/rig.yaml").toStdString());
    ASSERT_TRUE(rig);
    EXPECT_NEAR(baseline_mm(*rig), baseline_mm(page.world().rig()), 1.0);
    EXPECT_GE(rig->provenance.pictures.size(), 24U);
    EXPECT_FALSE(rig->provenance.created.empty());
    QFile report(folder.filePath("session/result/report.html"));
    ASSERT_TRUE(report.open(QIODevice::ReadOnly));
    const QString html = QString::fromUtf8(report.readAll());
    for (const char* part : {"<svg", "Coverage", "Shots", "How far ranges are open"}) {
        EXPECT_TRUE(html.contains(part)) << part;
    }
    const QString copies = qEnvironmentVariable("KAMBARA_SCREENSHOTS");
    if (!copies.isEmpty()) {
        QFile::remove(copies + "/report.html");
        QFile::copy(report.fileName(), copies + "/report.html");
    }
}

TEST(CalibrationInTheWindow, DropsUndoesLeavesAndResumes) {
    QTemporaryDir folder;
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    CalibrationPage calibration(page);
    ASSERT_TRUE(calibration.until([&] { return calibration.can_press("beginSession"); }, 10));
    calibration.choose_folder(folder.filePath("session"));
    calibration.press("beginSession");
    ASSERT_TRUE(calibration.until([&] { return calibration.shots() >= 2; }, two_minutes));
    calibration.press("pauseCapture");
    EXPECT_FALSE(calibration.can_press("undoDecision"));
    calibration.tick_shot(0, false);
    ASSERT_TRUE(calibration.until([&] { return calibration.can_press("undoDecision"); }, 20));
    const int shots = calibration.shots();
    EXPECT_EQ(calibration.shots_kept(), shots - 1);
    calibration.press("undoDecision");
    ASSERT_TRUE(calibration.until([&] { return calibration.shots_kept() == shots; }, 20));
    calibration.press("leaveSession");
    ASSERT_TRUE(calibration.shows("beginSession"));
    calibration.window().resume(folder.filePath("session"));
    ASSERT_TRUE(calibration.until([&] { return calibration.shows("shotList"); }, 20));
    EXPECT_GE(calibration.shots(), shots);
}

// Without the helper the target stays where it is; the hand moves it.
TEST(CalibrationInTheWindow, TheTargetIsHeldByMouseAndKeys) {
    QTemporaryDir folder;
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    CalibrationPage calibration(page);
    ASSERT_TRUE(calibration.until([&] { return calibration.can_press("beginSession"); }, 10));
    calibration.choose_folder(folder.filePath("session"));
    calibration.press("beginSession");
    ASSERT_TRUE(calibration.until([&] { return calibration.shots() >= 1; }, two_minutes));
    calibration.press("helperFollows");
    ASSERT_TRUE(calibration.until(
        [&] { return calibration.text("captureBanner").contains("shows it already"); }, 60));
    const int shots = calibration.shots();
    for (int i = 0; i < 3; ++i) {
        calibration.hold_key(Qt::Key_Left, Qt::NoModifier);
    }
    EXPECT_TRUE(calibration.until([&] { return calibration.shots() > shots; }, 60))
        << calibration.text("captureBanner").toStdString();
}

TEST(CalibrationInTheWindow, ThreeCamerasTakePartAndSolvingCanBeCancelled) {
    QTemporaryDir folder;
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    CalibrationPage calibration(page);
    ASSERT_TRUE(calibration.until([&] { return calibration.can_press("beginSession"); }, 10));
    ASSERT_TRUE(calibration.until([&] { return calibration.can_press("camera2"); }, 10));
    calibration.press("camera2");
    calibration.choose_folder(folder.filePath("session"));
    calibration.press("beginSession");
    ASSERT_TRUE(calibration.until([&] { return calibration.shots() >= 5; }, two_minutes))
        << calibration.text("captureBanner").toStdString();
    calibration.take("three");
    EXPECT_TRUE(calibration.shows("guideView2"));
    calibration.press("pauseCapture");
    calibration.press("solve");
    ASSERT_TRUE(calibration.shows("solvingBar"));
    calibration.press("solve");  // now Cancel
    // Where the computer was quicker than the hand, there is a result instead.
    ASSERT_TRUE(calibration.until(
        [&] { return calibration.shows("calibrationVerdict") || !calibration.shows("solvingBar"); },
        60));
    EXPECT_GE(calibration.shots(), 5);
}

TEST(CalibrationInTheWindow, SavesTheTargetToPrint) {
    QTemporaryDir folder;
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    CalibrationPage calibration(page);
    calibration.choose_target("two-plane-24");
    EXPECT_TRUE(calibration.can_press("printTarget"));
    auto* setup = calibration.window().findChild<ui::SetupPage*>();
    ASSERT_NE(setup, nullptr);
    const QString file = folder.filePath("target.pdf");
    setup->save_pdf(file);
    QFile saved(file);
    ASSERT_TRUE(saved.open(QIODevice::ReadOnly));
    EXPECT_TRUE(saved.read(5).startsWith("%PDF-"));
    EXPECT_TRUE(calibration.text("targetNote").contains("pages: 2"))
        << calibration.text("targetNote").toStdString();
    calibration.take("printed");
    setup->save_pdf(folder.filePath("no/such/folder/target.pdf"));
    EXPECT_TRUE(calibration.shows("setupFailure"));
    calibration.choose_target("chessboard:60x40:30");
    setup->save_pdf(file);
    EXPECT_TRUE(calibration.text("setupFailure").contains("does not fit"))
        << calibration.text("setupFailure").toStdString();
    calibration.choose_target("cube");
    EXPECT_FALSE(calibration.can_press("printTarget"));
}

TEST(CalibrationInTheWindow, RefusesAFolderThatCantBeWrittenInAPlainSentence) {
    QTemporaryDir folder;
    QFile file(folder.filePath("file"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    CalibrationPage calibration(page);
    ASSERT_TRUE(calibration.until([&] { return calibration.can_press("beginSession"); }, 10));
    calibration.choose_target("no-such-target");
    EXPECT_FALSE(calibration.can_press("beginSession"));
    EXPECT_FALSE(calibration.text("targetNote").isEmpty());
    calibration.choose_target("two-plane-24");
    calibration.choose_folder(folder.filePath("file/session"));
    calibration.press("beginSession");
    ASSERT_TRUE(calibration.until([&] { return calibration.shows("setupFailure"); }, 20));
    EXPECT_TRUE(calibration.text("setupFailure").contains("can't be made"))
        << calibration.text("setupFailure").toStdString();
}

}  // namespace
}  // namespace kambara
