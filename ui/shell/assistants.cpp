// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/assistants.h"

#include "ui/experiments/levelling_window.h"

namespace kambara::ui {

Assistants::Assistants(QWidget* main_window) : QObject(main_window), main_window_(main_window) {}

void Assistants::show(AssistantWindow* window) {
    if (!windows_.contains(window)) {
        windows_ << window;
        window->set_source(rig_);
        connect(window, &AssistantWindow::command_asked, this, &Assistants::command_asked);
    }
    window->show();
    window->raise();
    window->activateWindow();
}

void Assistants::show_levelling() {
    if (levelling_ == nullptr) {
        levelling_ = new LevellingWindow(main_window_);
        connect(levelling_, &LevellingWindow::mount_found, this,
                [this](const Rig& rig) { emit mount_found(*rig.mount); });
    }
    show(levelling_);
}

void Assistants::set_source(const Rig& rig) {
    rig_ = rig;
    for (AssistantWindow* window : windows_) {
        window->set_source(rig);
    }
}

void Assistants::show_snapshot(const SnapshotPtr& snapshot) {
    for (AssistantWindow* window : windows_) {
        if (window->isVisible()) {
            window->show_snapshot(snapshot);
        }
    }
}

bool Assistants::may_close() {
    for (AssistantWindow* window : windows_) {
        if (window->isVisible() && !window->may_close()) {
            return false;
        }
    }
    return true;
}

}  // namespace kambara::ui
