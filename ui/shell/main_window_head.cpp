// SPDX-License-Identifier: GPL-3.0-or-later
// The head in the window: what turns it, and what stops it.
#include <QAction>

#include "ui/devices/hand_drive.h"
#include "ui/devices/head_keys.h"
#include "ui/devices/pan_tilt_pad.h"
#include "ui/devices/pan_tilt_panel.h"
#include "ui/shell/main_window.h"
#include "ui/shell/status_fields.h"
#include "ui/shell/window_actions.h"
#include "ui/video/video_view.h"

namespace kambara::ui {

void MainWindow::connect_head() {
    connect(actions_->steer, &QAction::triggered, this, [this](bool automatic) {
        drive_->drop_all();
        link_->send(SteerHead{automatic});
    });
    connect(actions_->servo, &QAction::triggered, this,
            [this](bool on) { link_->send(ServoHead{on}); });
    connect(actions_->home, &QAction::triggered, this, [this] { link_->send(HomeHead{}); });
    connect(actions_->reset_head, &QAction::triggered, this, [this] { link_->send(ResetHead{}); });
    connect(actions_->halt, &QAction::triggered, this, &MainWindow::halt_head);
    connect(head_, &PanTiltPanel::asked, this, [this](const Command& command) {
        // Sliders ask faster than a line to a head can tell.
        const bool slides =
            std::holds_alternative<ZoomHead>(command) || std::holds_alternative<FocusHead>(command);
        slides ? link_->send_newest(command) : link_->send(command);
    });
    connect(head_->pad(), &PanTiltPad::asked_for, this, [this](double pan_rad, double tilt_rad) {
        link_->send_newest(MoveHead{{pan_rad, tilt_rad}});
    });
    connect(pan_tilt_, &VideoView::pointed_at, this, [this](double x_px, double y_px) {
        const auto& head = pan_tilt_->shown()->head;
        if (head) {
            link_->send(CentreHead{x_px, y_px, head->angles});
        }
    });
    connect(drive_, &HandDrive::drive, this, [this](double pan_rad_s, double tilt_rad_s) {
        link_->send_newest(DriveHead{pan_rad_s, tilt_rad_s});
    });
    connect(drive_, &HandDrive::halt, this, [this] { link_->send(HaltHead{}); });
    connect(drive_, &HandDrive::zoom, this,
            [this](double share) { link_->send_newest(ZoomHead{share}); });
    connect(drive_, &HandDrive::pad_changed, status_, &StatusFields::show_gamepad);
    drive_->set_gamepad(options_.gamepad);
    new HeadKeys(drive_, this, [](QWidget* part) {
        const auto* view = qobject_cast<VideoView*>(part);
        return view != nullptr && view->selecting();
    });
}

void MainWindow::halt_head() {
    link_->send(HaltHead{});
    drive_->drop_all();
}

}  // namespace kambara::ui
