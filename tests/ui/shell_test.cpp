// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QToolButton>

#include "tests/ui/window_page.h"
#include "ui/scene3d/gl_probe.h"
#include "ui/shell/about_dialog.h"

namespace kambara {
namespace {

using testing_support::WindowPage;

TEST(Shell, ActionsSayTheirKeyOrWhyTheyAreGrey) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    ASSERT_TRUE(page.until([&] { return page.action("selectTarget").isEnabled(); }));
    EXPECT_TRUE(page.action("selectTarget").toolTip().contains("[T]"));
    EXPECT_FALSE(page.action("startTracking").isEnabled());
    EXPECT_TRUE(page.action("startTracking").toolTip().contains("Choose a target first"));
    EXPECT_FALSE(page.action("step").isEnabled());
    EXPECT_TRUE(page.action("step").toolTip().contains("Only a recording"));
    for (const QAction* action : page.window().findChildren<QAction*>()) {
        if (!action->objectName().isEmpty() && action->property("help").isValid()) {
            EXPECT_FALSE(action->toolTip().isEmpty()) << action->objectName().toStdString();
        }
    }
}

TEST(Shell, TheListOfKeysHoldsEveryKey) {
    WindowPage page(WindowPage::simulated(false));
    page.key(Qt::Key_F1);
    auto& list = *page.window().findChild<QTextBrowser*>();
    const QString text = list.toPlainText();
    for (const QAction* action : page.window().findChildren<QAction*>()) {
        if (action->property("help").isValid() && !action->shortcut().isEmpty()) {
            EXPECT_TRUE(text.contains(action->property("help").toString()))
                << action->objectName().toStdString();
            EXPECT_TRUE(text.contains(action->shortcut().toString(QKeySequence::NativeText)))
                << action->objectName().toStdString();
        }
    }
}

TEST(Shell, KeepsItsLayoutAndRestoresTheDefault) {
    auto options = WindowPage::simulated(false);
    options.keep_layout = true;
    {
        WindowPage page(options);
        page.part<QDockWidget>("plotsDock").hide();
        page.window().resize(1100, 700);
        page.window().close();
    }
    WindowPage page(options);
    EXPECT_FALSE(page.part<QDockWidget>("plotsDock").isVisible());
    EXPECT_EQ(page.window().size(), QSize(1100, 700));
    page.action("defaultLayout").trigger();
    EXPECT_TRUE(page.until([&] { return page.part<QDockWidget>("plotsDock").isVisible(); }));
}

TEST(Shell, TheDefaultLayoutHidesNoButton) {
    WindowPage page(WindowPage::simulated());
    ASSERT_TRUE(page.until_picture());
    if (page.window().width() < 1600) {
        GTEST_SKIP() << "skipped: the screen is too narrow";
    }
    for (const QToolButton* arrow :
         page.window().findChildren<QToolButton*>(QStringLiteral("qt_toolbar_ext_button"))) {
        EXPECT_FALSE(arrow->isVisible()) << "a tool bar hides some of its buttons";
    }
}

TEST(Shell, WorksWithoutGlAndSaysSo) {
    WindowPage page(WindowPage::simulated(false));
    EXPECT_FALSE(page.scene().works());
    EXPECT_TRUE(page.text("noScene").contains("OpenGL"));
}

TEST(Shell, SavesThe3dViewAsAPicture) {
    if (!ui::can_draw_with_gl()) {
        GTEST_SKIP() << "skipped: there is no OpenGL here";
    }
    WindowPage page(WindowPage::simulated());
    if (!page.scene().works()) {
        GTEST_SKIP() << "skipped: built without VTK";
    }
    ASSERT_TRUE(page.until_picture());
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("scene.png"));
    ASSERT_TRUE(page.scene().save_png(file));
    const QImage picture(file);
    ASSERT_GT(picture.width(), 100);
    int drawn = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            drawn += qGray(picture.pixel(x, y)) > 60 ? 1 : 0;
        }
    }
    EXPECT_GT(drawn, 200) << "the picture shows nothing";
    EXPECT_FALSE(page.scene().save_png(folder.filePath(QStringLiteral("none/scene.png"))));
}

TEST(Shell, AboutNamesVersionsAndLicences) {
    const QString text = ui::about_text();
    EXPECT_TRUE(text.contains("GNU General Public License"));
    for (const char* name : {"Qt", "QCustomPlot", "OpenCV", "Eigen", "Ceres Solver", "Highway",
                             "FFTW", "yaml-cpp", "nlohmann-json"}) {
        const QRegularExpression versioned(QLatin1String(name) + R"( \d+\.\d[\d.]* \()");
        EXPECT_TRUE(text.contains(versioned)) << name << " in " << text.toStdString();
    }
}

}  // namespace
}  // namespace kambara
