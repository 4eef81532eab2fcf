// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/language.h"

#include <gtest/gtest.h>

#include <QLocale>
#include <QMenuBar>

#include "tests/ui/window_page.h"
#include "ui/base/quantities.h"

namespace kambara {
namespace {

using testing_support::WindowPage;

class LanguageTest : public testing::Test {
  protected:
    void TearDown() override { QLocale::setDefault(QLocale::c()); }
};

TEST_F(LanguageTest, GermanReachesMenusActionsStatesAndNumbers) {
    const Language german(QStringLiteral("de"));
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    EXPECT_EQ(page.window().menuBar()->actions().constFirst()->text(), "&Datei");
    EXPECT_EQ(page.action("selectTarget").text(), "Ziel &wählen");
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    EXPECT_TRUE(page.until([&] { return page.text("trackState") == "Verfolgt"; }))
        << page.text("trackState").toStdString();
    EXPECT_EQ(ui::millimetres(1234.5), QString::fromUtf8("1.234,5\u202Fmm"));
}

TEST_F(LanguageTest, WithoutATranslationTheTextsStayEnglish) {
    const Language none(QStringLiteral("fr"));
    WindowPage page(WindowPage::simulated(false));
    EXPECT_EQ(page.window().menuBar()->actions().constFirst()->text(), "&File");
}

}  // namespace
}  // namespace kambara
