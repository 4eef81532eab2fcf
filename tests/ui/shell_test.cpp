// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QDockWidget>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>

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

TEST(Shell, AboutNamesTheLicences) {
    for (const char* name : {"GNU General Public License", "Qt", "VTK", "QCustomPlot", "OpenCV"}) {
        EXPECT_TRUE(ui::about_text().contains(QLatin1String(name))) << name;
    }
}

}  // namespace
}  // namespace kambara
