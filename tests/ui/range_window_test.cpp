// SPDX-License-Identifier: GPL-3.0-or-later
// The range experiment's form: typed and read places, and the simulated stations by themselves.
#include <gtest/gtest.h>

#include <QFile>
#include <QTabWidget>
#include <QTemporaryDir>

#include "tests/ui/form_page.h"
#include "ui/experiments/place_table.h"

namespace kambara {
namespace {

using testing_support::FormPage;
using testing_support::WindowPage;

void write(const QString& path, const char* text) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
}

QString read(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

TEST(RangeExperimentInTheWindow, GoesByItselfOnTheSimulatedStations) {
    QTemporaryDir folder;
    WindowPage page(WindowPage::simulated(false), "stations");
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "rangeExperiment", "rangeWindow");
    EXPECT_TRUE(form.shows("rangeEmpty"));
    EXPECT_FALSE(form.can_press("measurePlace"));
    form.take("range_empty");
    form.press("simulateStations");
    auto& table = form.part<ui::PlaceTable>("placeTable");
    ASSERT_TRUE(WindowPage::until([&] { return table.measured() >= 6; }, 40))
        << form.said().toStdString();
    form.take("range_running");
    EXPECT_TRUE(form.text("rangeLive").contains("estimate less truth"));
    form.press("simulateStations");  // now Stop
    auto& tabs = form.part<QTabWidget>("rangeTabs");
    ASSERT_TRUE(WindowPage::until([&] { return tabs.currentIndex() == 1; }));
    form.take("range_result");
    EXPECT_TRUE(form.text("rangeVerdict").startsWith("Good"))
        << form.text("rangeVerdict").toStdString();
    EXPECT_FALSE(form.window().unsaved().isEmpty());
    form.type("saveRangeTableFile", folder.filePath("table.csv"));
    form.press("saveRangeTable");
    ASSERT_TRUE(WindowPage::until([&] { return form.said().contains("table.csv"); }));
    form.type("saveRangePageFile", folder.filePath("page.html"));
    form.press("saveRangePage");
    ASSERT_TRUE(WindowPage::until([&] { return form.said().contains("page.html"); }));
    EXPECT_TRUE(form.window().unsaved().isEmpty());
    EXPECT_EQ(read(folder.filePath("table.csv")).count('\n'), 1 + table.measured());
    EXPECT_TRUE(read(folder.filePath("page.html")).contains("Range error against depth z"));
}

}  // namespace
}  // namespace kambara
