// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window_page.h"

#include <QApplication>
#include <QMouseEvent>
#include <QtTest>

#include "app/kambara/calibration_ports.h"
#include "app/kambara/experiment_ports.h"
#include "app/kambara/open_system.h"
#include "ui/scene3d/gl_probe.h"

namespace kambara::testing_support {

WindowPage::WindowPage(const ui::WindowOptions& options, const std::string& profile)
    : world_(std::make_unique<SimulatedWorld>(*simulated_profile(profile))),
      window_(std::make_unique<ui::MainWindow>(system_opener(clock_), options)) {
    window_->show();
    if (!QTest::qWaitForWindowExposed(window_.get())) {
        throw std::runtime_error("the window does not appear");
    }
    window_->activateWindow();
}

ui::WindowOptions WindowPage::simulated(bool with_gl) {
    ui::WindowOptions options;
    options.with_gl = with_gl && ui::can_draw_with_gl();
    options.keep_layout = false;
    options.calibration = calibration_ports();
    options.experiments = experiment_ports();
    options.first.left = "sim:default";
    options.simulation.left = "sim:default";
    return options;
}

bool WindowPage::until(const std::function<bool()>& is_so, int seconds) {
    return QTest::qWaitFor(is_so, 1000 * seconds);
}

bool WindowPage::until_picture() {
    return until([this] { return left().shown() != nullptr; });
}

bool WindowPage::until_state(TrackState state) {
    return until(
        [this, state] { return left().shown() && steered_estimate(shown()).state == state; });
}

QAction& WindowPage::action(const char* object_name) {
    return part<QAction>(object_name);
}

ui::OpenRecordingDialog* WindowPage::open_dialog() {
    ui::OpenRecordingDialog* dialog = nullptr;
    until([&] {
        dialog = window_->findChild<ui::OpenRecordingDialog*>();
        return dialog != nullptr && dialog->isVisible();
    });
    return dialog;
}

void WindowPage::key(Qt::Key key, Qt::KeyboardModifiers modifiers, int times) {
    for (int i = 0; i < times; ++i) {
        if (QApplication::activeWindow() != window_.get()) {
            window_->activateWindow();
            if (!QTest::qWaitForWindowActive(window_.get())) {
                throw std::runtime_error("the window gets no keys");
            }
        }
        if (!until([] { return QApplication::focusWidget() != nullptr; })) {
            throw std::runtime_error("nothing in the window has the keyboard");
        }
        QWidget* focus = QApplication::focusWidget();
        QTest::keyClick(focus != nullptr ? focus : window_.get(), key, modifiers);
    }
}

void WindowPage::click(const Eigen::Vector2d& left_px, Qt::KeyboardModifiers modifiers) {
    const QPointF place = left().view().widget_from_pixel({left_px.x(), left_px.y()});
    QTest::mouseClick(&left(), Qt::LeftButton, modifiers, place.toPoint());
}

void WindowPage::drag(const Rectangle& rectangle, Qt::KeyboardModifiers modifiers) {
    ui::VideoView& view = left();
    const auto place = [&](double x, double y) {
        return view.view().widget_from_pixel({x, y}).toPoint();
    };
    const QPoint from = place(rectangle.x, rectangle.y);
    const QPoint to = place(rectangle.x + rectangle.width - 1, rectangle.y + rectangle.height - 1);
    QTest::mousePress(&view, Qt::LeftButton, modifiers, from);
    QMouseEvent move(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::LeftButton,
                     modifiers);
    QApplication::sendEvent(&view, &move);
    QTest::mouseRelease(&view, Qt::LeftButton, modifiers, to);
}

Rectangle WindowPage::target() const {
    auto* view = window_->findChild<ui::VideoView*>(QStringLiteral("leftView"));
    return world_->suggested_template(31, view->shown()->frame);
}

}  // namespace kambara::testing_support
