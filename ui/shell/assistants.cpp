// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/assistants.h"

#include "ui/experiments/head_window.h"
#include "ui/experiments/levelling_window.h"
#include "ui/experiments/range_window.h"
#include "ui/experiments/zoom_window.h"

namespace kambara::ui {

Assistants::Assistants(const ExperimentPorts& ports, QWidget* main_window)
    : QObject(main_window), ports_(ports), main_window_(main_window) {}

void Assistants::show(AssistantWindow* window) {
    if (!windows_.contains(window)) {
        windows_ << window;
        window->set_source(rig_);
        connect(window, &AssistantWindow::command_asked, this, &Assistants::command_asked);
    }
    if (newest_ != nullptr) {
        window->show_snapshot(newest_);
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

void Assistants::show_range_experiment() {
    if (range_ == nullptr) {
        range_ = new RangeWindow(ports_, main_window_);
        range_->set_stations(stations_, simulated_);
        connect(range_, &RangeWindow::stations_asked, this,
                [this] { emit simulation_asked(QStringLiteral("sim:stations")); });
    }
    show(range_);
}

void Assistants::show_head_calibration() {
    if (head_ == nullptr) {
        head_ = new HeadWindow(ports_, main_window_);
        head_->set_hand(hand_, simulated_);
        connect(head_, &HeadWindow::simulated_target_asked, this, [this](const QString& target) {
            emit simulation_asked(QStringLiteral("sim:chessboard?target=") + target);
        });
    }
    show(head_);
}

void Assistants::show_zoom_calibration() {
    if (zoom_ == nullptr) {
        zoom_ = new ZoomWindow(ports_, main_window_);
    }
    show(zoom_);
}

void Assistants::set_source(const Rig& rig, const SimulatedStations& stations,
                            const TargetHand& hand, bool simulated) {
    rig_ = rig;
    stations_ = stations;
    hand_ = hand;
    simulated_ = simulated;
    newest_.reset();
    if (head_ != nullptr) {
        head_->set_hand(hand, simulated);
    }
    if (range_ != nullptr) {
        range_->set_stations(stations, simulated);
    }
    for (AssistantWindow* window : windows_) {
        window->set_source(rig);
    }
}

void Assistants::show_snapshot(const SnapshotPtr& snapshot) {
    newest_ = snapshot;
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

void Assistants::close_all() {
    for (AssistantWindow* window : windows_) {
        if (window->isVisible()) {
            window->close_unasked();
        }
    }
}

}  // namespace kambara::ui
