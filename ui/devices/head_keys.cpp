// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/head_keys.h"

#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>
#include <QTextEdit>
#include <utility>

#include "ui/devices/hand_drive.h"

namespace kambara::ui {
namespace {

bool is_arrow(int key) {
    return key >= Qt::Key_Left && key <= Qt::Key_Down;
}

template <class... Parts>
bool is_one_of(const QWidget* part) {
    return ((qobject_cast<const Parts*>(part) != nullptr) || ...);
}

}  // namespace

HeadKeys::HeadKeys(HandDrive* drive, QWidget* window, std::function<bool(QWidget*)> in_use)
    : QObject(window), drive_(drive), window_(window), in_use_(std::move(in_use)) {
    qApp->installEventFilter(this);
    connect(qApp, &QGuiApplication::applicationStateChanged, this, &HeadKeys::let_go);
    connect(drive_, &HandDrive::dropped, this, [this] { pressed_.clear(); });
}

bool HeadKeys::takes(QWidget* part) const {
    const bool elsewhere = part->window() != window_ ||
                           QApplication::activeModalWidget() != nullptr ||
                           QApplication::activePopupWidget() != nullptr;
    const bool has_own_use =
        is_one_of<QAbstractSlider, QAbstractSpinBox, QComboBox, QLineEdit, QAbstractItemView,
                  QTabBar, QTextEdit, QMenu, QMenuBar>(part) ||
        in_use_(part);
    return !elsewhere && !has_own_use;
}

bool HeadKeys::eventFilter(QObject* watched, QEvent* event) {
    switch (event->type()) {
        case QEvent::KeyPress:
            return press(*static_cast<QKeyEvent*>(event), watched);
        case QEvent::KeyRelease:
            return release(*static_cast<QKeyEvent*>(event));
        case QEvent::WindowDeactivate:
            if (watched == window_) {
                let_go();
            }
            break;
        case QEvent::FocusOut:
            let_go();
            break;
        default:
            break;
    }
    return false;
}

bool HeadKeys::press(const QKeyEvent& event, QObject* watched) {
    auto* part = qobject_cast<QWidget*>(watched);
    const auto others = event.modifiers() & ~Qt::KeypadModifier;
    if (part == nullptr || !is_arrow(event.key()) || others != Qt::NoModifier || !takes(part)) {
        return false;
    }
    if (!event.isAutoRepeat()) {
        pressed_.insert(event.key());
        apply();
    }
    return true;
}

bool HeadKeys::release(const QKeyEvent& event) {
    if (!pressed_.contains(event.key())) {
        return false;
    }
    if (!event.isAutoRepeat()) {
        pressed_.remove(event.key());
        apply();
    }
    return true;
}

void HeadKeys::let_go() {
    if (!pressed_.isEmpty()) {
        pressed_.clear();
        apply();
    }
}

void HeadKeys::apply() {
    const auto way = [this](Qt::Key more, Qt::Key less) {
        return (pressed_.contains(more) ? 1.0 : 0.0) - (pressed_.contains(less) ? 1.0 : 0.0);
    };
    if (pressed_.isEmpty()) {
        drive_->release(HandDrive::Source::keys);
    } else {
        drive_->hold(HandDrive::Source::keys,
                     {way(Qt::Key_Right, Qt::Key_Left), way(Qt::Key_Up, Qt::Key_Down)});
    }
}

}  // namespace kambara::ui
