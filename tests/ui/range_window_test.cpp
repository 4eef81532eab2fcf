// SPDX-License-Identifier: GPL-3.0-or-later
// The range experiment's form: typed and read places, and the simulated stations by themselves.
#include <gtest/gtest.h>

#include <QApplication>
#include <QFile>
#include <QMessageBox>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

#include "app/kambara/experiment_ports.h"
#include "core/camera/nominal_rig.h"
#include "tests/ui/form_page.h"
#include "ui/experiments/place_table.h"
#include "ui/experiments/range_window.h"

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

// Presses the same button of every question about something unsaved, and counts them.
class Answers {
  public:
    explicit Answers(const QString& button) {
        QObject::connect(&timer_, &QTimer::timeout, &timer_, [this, button] {
            auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
            for (QAbstractButton* one :
                 box != nullptr ? box->buttons() : QList<QAbstractButton*>()) {
                if (one->text().remove(QLatin1Char('&')) == button) {
                    ++count_;
                    QTest::mouseClick(one, Qt::LeftButton);
                }
            }
        });
        timer_.start(50);
    }
    int count() const { return count_; }

  private:
    QTimer timer_;
    int count_ = 0;
};

TEST(RangeExperimentInTheWindow, QuittingAsksOnceAndTakesTheFormsAlong) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "rangeExperiment", "rangeWindow");
    auto& table = form.part<ui::PlaceTable>("placeTable");
    table.add_place(Eigen::Vector3d(100, 150, 1950));
    table.setCurrentCell(0, 0);
    page.drag(page.target());
    form.press("measurePlace");
    ASSERT_TRUE(WindowPage::until([&] { return table.measured() == 1; }, 30));
    {
        const Answers keep(QStringLiteral("Keep it"));
        page.action("quit").trigger();
        WindowPage::until([] { return false; }, 1);
        EXPECT_EQ(keep.count(), 1);
        EXPECT_TRUE(page.window().isVisible());
        EXPECT_TRUE(form.window().isVisible());
    }
    const Answers drop(QStringLiteral("Close without saving"));
    page.action("quit").trigger();
    WindowPage::until([] { return false; }, 1);
    EXPECT_EQ(drop.count(), 1);
    EXPECT_FALSE(page.window().isVisible());
    EXPECT_FALSE(form.window().isVisible());
}

TEST(RangeExperimentInTheWindow, TypedPlacesAreNotLostUnasked) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "rangeExperiment", "rangeWindow");
    form.press("addPlace");
    EXPECT_TRUE(form.window().unsaved().isEmpty()) << "an empty row holds nothing";
    // Each key goes to what has the keyboard: the first one opens a field.
    const auto type = [](const char* text) {
        for (const QChar c : QString(text)) {
            QTest::keyClick(QApplication::focusWidget(), c.toLatin1());
        }
    };
    for (const char* number : {"200", "150.5"}) {
        type(number);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    type("abc");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Enter);
    EXPECT_TRUE(WindowPage::until([&] { return form.said().contains("abc"); }, 5))
        << form.said().toStdString();
    EXPECT_FALSE(form.can_press("measurePlace"));
    form.take("range_no_number");
    // The third is still in its field, not in the table, when the program is left.
    type("2000");
    {
        const Answers keep(QStringLiteral("Keep it"));
        page.action("quit").trigger();
        EXPECT_EQ(keep.count(), 1);
        EXPECT_TRUE(page.window().isVisible());
    }
    EXPECT_EQ(form.part<ui::PlaceTable>("placeTable").known_mm(0),
              Eigen::Vector3d(200, 150.5, 2000));
    const Answers drop(QStringLiteral("Close without saving"));
    page.action("quit").trigger();
    EXPECT_EQ(drop.count(), 1);
    EXPECT_FALSE(page.window().isVisible());
}

TEST(RangeExperimentInTheWindow, EscapeInAFormStopsNothingAndCtrlWClosesIt) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    FormPage form(page, "rangeExperiment", "rangeWindow");
    ASSERT_TRUE(QTest::qWaitForWindowActive(&form.window()));
    form.press("addPlace");
    for (int i = 0; i < 2; ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    }
    const std::int64_t frame = page.shown().frame;
    ASSERT_TRUE(page.until([&] { return page.shown().frame > frame + 5; }));
    EXPECT_EQ(steered_estimate(page.shown()).state, TrackState::tracking);
    EXPECT_TRUE(page.shown().head->automatic);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_F12);
    EXPECT_TRUE(page.until([&] { return !page.shown().head->automatic; })) << "from anywhere";
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_W, Qt::ControlModifier);
    EXPECT_FALSE(form.window().isVisible());
    EXPECT_TRUE(page.window().isVisible());
    page.action("rangeExperiment").trigger();
    EXPECT_TRUE(form.window().isVisible());
    form.press("closeForm");
    EXPECT_FALSE(form.window().isVisible());
}

TEST(RangeExperimentInTheWindow, ATargetIsNotForgottenForTheSimulationUnasked) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.drag(page.target());
    ASSERT_TRUE(page.until_state(TrackState::tracking));
    FormPage form(page, "rangeExperiment", "rangeWindow");
    FormPage::answer("replaceQuestion", "Keep it");
    form.press("simulateStations");
    EXPECT_FALSE(form.part<QAbstractButton>("simulateStations").isChecked());
    EXPECT_TRUE(form.can_press("addPlace")) << "nothing was begun";
    const std::int64_t frame = page.shown().frame;
    ASSERT_TRUE(page.until([&] { return page.shown().frame > frame + 5; }));
    EXPECT_EQ(steered_estimate(page.shown()).state, TrackState::tracking);
    FormPage::answer("replaceQuestion", "Open the simulated rig");
    form.press("simulateStations");
    EXPECT_TRUE(page.until([&] { return page.shown().tracks.empty(); }));
}

// Tells the form where the target is, pair by pair.
void feed(ui::RangeWindow& window, std::int64_t frame, const Eigen::Vector3d& at_mm) {
    Snapshot snapshot;
    snapshot.frame = frame;
    snapshot.run = RunState::running;
    TrackSnapshot track{1, {}};
    track.estimate.state = TrackState::tracking;
    track.estimate.position = Position{};
    track.estimate.position->point_in_left_mm = at_mm;
    snapshot.tracks = {track};
    snapshot.steered_target = 1;
    window.show_snapshot(std::make_shared<const Snapshot>(snapshot));
}

TEST(RangeExperimentInTheWindow, ATargetThatMovesIsToldWhileOneThatStandsIsTaken) {
    ui::RangeWindow window(experiment_ports());
    window.set_source(nominal_rig());
    window.show();
    auto& table = *window.findChild<ui::PlaceTable*>();
    auto& measure = *window.findChild<QAbstractButton*>("measurePlace");
    const auto said = [&] { return window.findChild<QLabel*>("said")->text(); };
    const Eigen::Vector3d place(100, 150, 1500);
    table.add_place(place);
    table.add_place(place);
    std::int64_t frame = 0;
    const auto measure_moving = [&](int row, double step_mm) {
        table.setCurrentCell(row, 0);
        measure.click();
        for (int i = 0; i < 30; ++i) {
            feed(window, frame++, place + Eigen::Vector3d(step_mm * i, 0, 0));
        }
    };
    measure_moving(0, 5.0);
    EXPECT_TRUE(said().contains("moved while place 1")) << said().toStdString();
    EXPECT_EQ(table.currentRow(), 0) << "it is to be measured again";
    window.findChild<QAbstractButton*>("judgePlaces")->click();
    const auto verdict = [&] { return window.findChild<QLabel*>("rangeVerdict")->text(); };
    ASSERT_TRUE(WindowPage::until([&] { return verdict().startsWith("No verdict"); }))
        << verdict().toStdString();
    measure_moving(0, 0.0);
    EXPECT_TRUE(said().contains("Place 1 is measured")) << said().toStdString();
    EXPECT_EQ(table.currentRow(), 1);
}

TEST(RangeExperimentInTheWindowSlow, AllSeventyFivePlacesByItself) {
    WindowPage page(WindowPage::simulated(false), "stations");
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "rangeExperiment", "rangeWindow");
    form.press("simulateStations");
    auto& tabs = form.part<QTabWidget>("rangeTabs");
    ASSERT_TRUE(WindowPage::until([&] { return tabs.currentIndex() == 1; }, 150))
        << form.said().toStdString();
    form.take("range_all");
    std::printf("%s; %s\n", qPrintable(form.text("rangeVerdict")), qPrintable(form.said()));
    EXPECT_GE(form.part<ui::PlaceTable>("placeTable").measured(), 70);
    EXPECT_TRUE(form.text("rangeVerdict").startsWith("Good without"));
}

TEST(RangeExperimentInTheWindow, PlacesAreReadTypedMeasuredAndNotLostUnasked) {
    QTemporaryDir folder;
    ui::WindowOptions options = WindowPage::simulated(false);
    options.first.left = "sim:default";
    WindowPage page(options);
    ASSERT_TRUE(page.until_picture());
    FormPage form(page, "rangeExperiment", "rangeWindow");
    auto& table = form.part<ui::PlaceTable>("placeTable");
    form.window().show();
    auto* range = qobject_cast<ui::RangeWindow*>(&form.window());
    ASSERT_NE(range, nullptr);
    write(folder.filePath("bad.csv"), "x_mm,y_mm,z_mm\n1,two,3\n");
    range->load(folder.filePath("bad.csv"));
    ASSERT_TRUE(WindowPage::until([&] { return form.said().contains("Line 2"); }));
    write(folder.filePath("places.csv"), "x_mm,y_mm,z_mm\n300,220,1500\n");
    range->load(folder.filePath("places.csv"));
    ASSERT_TRUE(WindowPage::until([&] { return table.rowCount() == 1; }));
    EXPECT_EQ(table.known_mm(0), Eigen::Vector3d(300, 220, 1500));
    form.press("addPlace");
    ASSERT_EQ(table.rowCount(), 2);
    EXPECT_FALSE(form.can_press("measurePlace"));
    for (const char* number : {"200", "150.5", "2000"}) {
        for (const QChar c : QString(number)) {
            ASSERT_NE(QApplication::focusWidget(), nullptr);
            QTest::keyClick(QApplication::focusWidget(), c.toLatin1());
        }
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    }
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    EXPECT_EQ(table.known_mm(1), Eigen::Vector3d(200, 150.5, 2000));
    table.setCurrentCell(0, 0);
    ASSERT_TRUE(form.can_press("measurePlace"));
    form.press("measurePlace");
    EXPECT_TRUE(form.text("rangeLive").contains("waiting"));
    QTest::keyClick(&table, Qt::Key_Delete);
    EXPECT_EQ(table.rowCount(), 2) << "the place that is being measured stays";
    page.drag(page.target());
    ASSERT_TRUE(WindowPage::until([&] { return table.measured() == 1; }, 30));
    EXPECT_EQ(table.readings(0).size(), 30U);
    form.take("range_places");
    form.press("judgePlaces");
    auto& tabs = form.part<QTabWidget>("rangeTabs");
    ASSERT_TRUE(WindowPage::until([&] { return tabs.currentIndex() == 1; }));
    EXPECT_TRUE(form.said().contains("took no part")) << form.said().toStdString();
    EXPECT_FALSE(form.text("rangeVerdict").contains("Good after"))
        << "one place proves no baseline: " << form.text("rangeVerdict").toStdString();
    EXPECT_TRUE(form.text("rangeSentence").contains("rests on one place alone"));
    FormPage::answer("unsavedQuestion", "Keep it");
    form.window().close();
    EXPECT_TRUE(form.window().isVisible());
    FormPage::answer("unsavedQuestion", "Keep it");
    page.window().close();
    EXPECT_TRUE(page.window().isVisible());
    FormPage::answer("unsavedQuestion", "Close without saving");
    form.window().close();
    EXPECT_FALSE(form.window().isVisible());
}

}  // namespace
}  // namespace kambara
