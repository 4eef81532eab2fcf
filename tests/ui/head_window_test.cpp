// SPDX-License-Identifier: GPL-3.0-or-later
// The head's calibration by itself on the simulated rig, whose head turns about its camera's
// centre and has no backlash.
#include <gtest/gtest.h>

#include <QTableWidget>
#include <QTemporaryDir>

#include "app/cli/calibrate_head_command.h"
#include "core/camera/rig_file.h"
#include "tests/ui/form_page.h"
#include "ui/experiments/head_window.h"

namespace kambara {
namespace {

using testing_support::FormPage;
using testing_support::WindowPage;

TEST(HeadCalibrationInTheWindowSlow, GoesThroughThePositionsSolvesAndSaves) {
    QTemporaryDir folder;
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "calibrateHead", "headWindow");
    EXPECT_TRUE(form.shows("headEmpty"));
    ASSERT_TRUE(WindowPage::until([&] { return form.can_press("headGo"); }));
    form.take("head_empty");
    form.press("headGo");
    auto& table = form.part<QTableWidget>("headViews");
    ASSERT_TRUE(WindowPage::until([&] { return table.rowCount() >= 4; }, 90))
        << form.said().toStdString() << form.text("headState").toStdString();
    form.take("head_going");
    ASSERT_TRUE(WindowPage::until([&] { return form.text("headRms") != QChar(0x2013); }, 180))
        << form.said().toStdString() << form.text("headState").toStdString();
    form.take("head_result");
    EXPECT_LT(form.number("headRms"), 0.3);
    EXPECT_NEAR(form.number("headPanBacklash"), 0.0, 0.05);
    EXPECT_NEAR(form.number("headTiltBacklash"), 0.0, 0.05);
    EXPECT_FALSE(form.window().unsaved().isEmpty());
    form.type("saveHeadRigFile", folder.filePath("rig.yaml"));
    form.press("saveHeadRig");
    ASSERT_TRUE(WindowPage::until([&] { return form.said().contains("rig.yaml"); }));
    const auto rig = read_rig_file(folder.filePath("rig.yaml").toStdString());
    ASSERT_TRUE(rig);
    EXPECT_TRUE(rig->head);
    // The command line makes the same of the record.
    form.type("saveHeadRecordFile", folder.filePath("record/views.csv"));
    form.press("saveHeadRecord");
    ASSERT_TRUE(WindowPage::until([&] { return form.said().contains("views.csv"); }, 60));
    ASSERT_TRUE(write_rig_file(folder.filePath("plain.yaml").toStdString(), page.world().rig()));
    cli::CalibrateHeadOptions options;
    options.rig = folder.filePath("plain.yaml").toStdString();
    options.views = folder.filePath("record/views.csv").toStdString();
    options.target = "chessboard:9x6:30";
    options.out = folder.filePath("again.yaml").toStdString();
    const cli::Outcome outcome = cli::run_calibrate_head(options);
    ASSERT_FALSE(outcome.failure) << outcome.failure->text();
    std::printf("%s", outcome.summary.c_str());
    const auto again = read_rig_file(options.out);
    ASSERT_TRUE(again);
    EXPECT_NEAR(again->head->tilt_axis_ahead_mm, rig->head->tilt_axis_ahead_mm, 0.01);
}

}  // namespace
}  // namespace kambara
