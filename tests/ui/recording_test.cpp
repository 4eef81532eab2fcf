// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QSlider>
#include <QUrl>
#include <QtTest>
#include <filesystem>

#include "tests/ui/recorded_rig.h"
#include "tests/ui/window_page.h"

namespace kambara {
namespace {

using testing_support::RecordedRig;
using testing_support::WindowPage;

constexpr int frames = 12;

class RecordingInTheWindow : public testing::Test {
  protected:
    const ui::SourceRequest& request() const { return recorded_.request(); }
    ui::WindowOptions opened() const {
        ui::WindowOptions options = WindowPage::simulated(false);
        options.first = request();
        return options;
    }
    static bool until_frame(WindowPage& page, std::int64_t frame) {
        return page.until([&] { return page.left().shown() && page.shown().frame == frame; });
    }

    const RecordedRig recorded_ =
        RecordedRig::as_pictures(*simulated_profile("default?rate=10"), frames, frames);
    const std::filesystem::path& folder_ = recorded_.folder();
};

TEST_F(RecordingInTheWindow, IsOpenedByTheDialogSteppedPlayedAndWound) {
    WindowPage page(WindowPage::simulated(false), "default?rate=10");
    ASSERT_TRUE(page.until_picture());
    page.key(Qt::Key_O, Qt::ControlModifier);
    auto* dialog = page.open_dialog();
    ASSERT_TRUE(dialog);
    auto* open = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open);
    EXPECT_FALSE(open->isEnabled());
    EXPECT_FALSE(open->toolTip().isEmpty());
    const auto type = [&](const char* name, const std::string& text) {
        auto* edit = dialog->findChild<QLineEdit*>(QLatin1String(name));
        QTest::keyClicks(edit, QString::fromStdString(text));
    };
    type("leftSource", request().left);
    type("rightSource", request().right);
    type("rigFile", request().rig);
    ASSERT_TRUE(open->isEnabled());
    QTest::keyClick(open, Qt::Key_Return);

    ASSERT_TRUE(until_frame(page, 0));
    ASSERT_TRUE(page.until([&] { return page.action("step").isEnabled(); }));
    EXPECT_EQ(page.shown().run, RunState::paused);
    EXPECT_EQ(page.shown().frames_total, frames);
    page.key(Qt::Key_Period);
    ASSERT_TRUE(until_frame(page, 1));
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    page.key(Qt::Key_Space);
    ASSERT_TRUE(page.until([&] { return page.shown().run == RunState::ended; }));
    EXPECT_EQ(page.shown().frame, frames - 1);
    EXPECT_EQ(page.shown().tracks.front().estimate.state, TrackState::tracking);
    ASSERT_TRUE(page.until([&] { return !page.action("play").isEnabled(); }));
    EXPECT_TRUE(page.action("play").toolTip().contains("over"));

    auto& slider = page.part<QSlider>("seekSlider");
    // A press beside the handle goes there; it is about 13 pixels wide.
    const int at = 6 + 5 * (slider.width() - 13) / (frames - 1);
    QTest::mouseClick(&slider, Qt::LeftButton, Qt::NoModifier, {at, slider.height() / 2});
    ASSERT_TRUE(until_frame(page, 5));
    EXPECT_EQ(page.shown().run, RunState::paused);
    EXPECT_TRUE(page.until([&] { return page.text("playbackPlace").contains("frame 5 of 12"); }));
    ASSERT_TRUE(page.until([&] { return page.action("play").isEnabled(); }));
    page.key(Qt::Key_Space);
    EXPECT_TRUE(page.until([&] { return page.shown().run == RunState::ended; }));
}

TEST_F(RecordingInTheWindow, IsRememberedAmongTheRecentOnes) {
    QSettings().clear();  // earlier tests of the same process opened theirs
    {
        WindowPage page(opened());
        ASSERT_TRUE(until_frame(page, 0));
    }
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    auto& recent = page.part<QMenu>("recentMenu");
    ASSERT_EQ(recent.actions().size(), 1);
    recent.actions().front()->trigger();
    EXPECT_TRUE(page.until([&] { return page.shown().frames_total == frames; }));
}

TEST_F(RecordingInTheWindow, ThatCannotBeOpenedLeavesTheOldOneAndAsksAgain) {
    WindowPage page(opened());
    ASSERT_TRUE(until_frame(page, 0));
    ui::SourceRequest wrong = request();
    wrong.rig = folder_ / "none.yaml";
    page.window().link().open(wrong);
    auto* dialog = page.open_dialog();
    ASSERT_TRUE(dialog);
    auto* failure = dialog->findChild<QLabel*>(QStringLiteral("openFailure"));
    EXPECT_TRUE(failure->text().contains("none.yaml")) << failure->text().toStdString();
    EXPECT_EQ(dialog->request(), wrong);
    dialog->close();
    page.key(Qt::Key_Period);
    EXPECT_TRUE(until_frame(page, 1));
}

TEST_F(RecordingInTheWindow, IsOpenedByDroppingItsFolders) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    QMimeData files;
    const auto url = [&](const char* name) {
        return QUrl::fromLocalFile(QString::fromStdString(folder_ / name));
    };
    files.setUrls({url("right"), url("rig.yaml"), url("left")});
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page.window(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent drop(QPointF(10, 10), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(&page.window(), &drop);
    EXPECT_TRUE(page.until([&] {
        return page.left().shown() && page.shown().frames_total == frames;
    })) << page.text("notice").toStdString();
    EXPECT_TRUE(page.shown_right().pictures.stereo.right.picture);
}

}  // namespace
}  // namespace kambara
