// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QWheelEvent>
#include <QtTest>

#include "tests/ui/window_page.h"

namespace kambara {
namespace {

using testing_support::WindowPage;

TEST(VideoViewInTheWindow, ZoomsAboutTheCursorFitsAndShowsPixelForPixel) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    ui::VideoView& view = page.left();
    const double fitted = view.view().zoom();
    const QPointF at(0.3 * view.width(), 0.6 * view.height());
    const QPointF pixel = view.view().pixel_from_widget(at);
    QWheelEvent wheel(at, view.mapToGlobal(at.toPoint()), {}, {0, 240}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &wheel);
    EXPECT_NEAR(view.view().zoom() / fitted, 1.25 * 1.25, 1e-9);
    EXPECT_NEAR(view.view().pixel_from_widget(at).x(), pixel.x(), 1e-9);
    EXPECT_NEAR(view.view().pixel_from_widget(at).y(), pixel.y(), 1e-9);
    QTest::keyClick(&view, Qt::Key_1);
    EXPECT_NEAR(view.view().zoom(), 1.0, 1e-12);
    QTest::keyClick(&view, Qt::Key_0);
    EXPECT_NEAR(view.view().zoom(), fitted, 1e-12);
    QTest::mousePress(&view, Qt::MiddleButton, Qt::NoModifier, {50, 50});
    const QPointF before = view.view().widget_from_pixel({0, 0});
    QTest::mouseMove(&view, {70, 40});
    QMouseEvent move(QEvent::MouseMove, QPointF(70, 40), view.mapToGlobal(QPoint(70, 40)),
                     Qt::NoButton, Qt::MiddleButton, Qt::NoModifier);
    QApplication::sendEvent(&view, &move);
    EXPECT_EQ(view.view().widget_from_pixel({0, 0}) - before, QPointF(20, -10));
    QTest::mouseRelease(&view, Qt::MiddleButton, Qt::NoModifier, {70, 40});
}

TEST(VideoViewInTheWindow, EscapeDropsARectangleAndAClickAsksForNothing) {
    WindowPage page(WindowPage::simulated(false));
    ASSERT_TRUE(page.until_picture());
    page.key(Qt::Key_T);
    ASSERT_TRUE(page.left().selecting());
    page.key(Qt::Key_Escape);
    EXPECT_FALSE(page.left().selecting());
    QTest::mouseClick(&page.left(), Qt::LeftButton, Qt::NoModifier, page.left().rect().center());
    EXPECT_FALSE(page.left().selecting());
    const std::int64_t frame = page.shown().frame;
    EXPECT_TRUE(page.until([&] { return page.shown().frame > frame + 3; }));
    EXPECT_TRUE(page.shown().tracks.empty());
}

TEST(VideoViewInTheWindow, APictureAgesWithThePairsThatComeWithoutIt) {
    ui::VideoView view(ui::ViewedCamera::pan_tilt, QStringLiteral("Pan-tilt"));
    view.resize(320, 240);
    Snapshot snapshot;
    snapshot.run = RunState::running;
    snapshot.time_ns = 10'000'000'000;
    snapshot.pictures.pan_tilt.picture = std::make_shared<const Image>(32, 24, 1);
    snapshot.pictures.pan_tilt.time_ns = snapshot.time_ns;
    view.show_snapshot(std::make_shared<const Snapshot>(snapshot));
    EXPECT_LT(view.age_ms(), 500);
    snapshot.time_ns += 3'000'000'000;
    view.show_snapshot(std::make_shared<const Snapshot>(snapshot));
    EXPECT_GE(view.age_ms(), 3000);
    snapshot.pictures.pan_tilt.time_ns = snapshot.time_ns + 40'000'000;  // newer than the pair
    view.show_snapshot(std::make_shared<const Snapshot>(snapshot));
    EXPECT_LT(view.age_ms(), 500);
}

}  // namespace
}  // namespace kambara
