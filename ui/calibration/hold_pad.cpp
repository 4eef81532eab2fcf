// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/hold_pad.h"

#include <Eigen/Geometry>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>

#include "core/base/angles.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr double mm_a_pixel = 2.0;
constexpr double rad_a_pixel = rad_from_deg(0.5);
constexpr double mm_a_notch = 40.0;
constexpr double mm_a_key = 20.0;
constexpr double rad_a_key = rad_from_deg(4.0);
constexpr double degrees_a_notch = 120.0;  // Qt's, in eighths

}  // namespace

HoldPad::HoldPad(QWidget* parent) : QWidget(parent) {
    setObjectName(QStringLiteral("holdPad"));
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::OpenHandCursor);
    setAccessibleName(tr("Hold the target"));
    setToolTip(
        tr("Drag: move. Shift + drag: turn and tilt. Ctrl + drag: roll. Wheel: nearer and "
           "farther. Keys: arrows, with Shift or Ctrl as above; Page up and down"));
}

void HoldPad::set_pose(const RigidTransform& T_left_from_target, const Eigen::Vector3d& middle_mm) {
    pose_ = T_left_from_target;
    middle_mm_ = middle_mm;
    update();
}

void HoldPad::move_by(const Eigen::Vector3d& by_mm) {
    if (pose_) {
        pose_->t_mm += by_mm;
        emit held_at(*pose_);
    }
}

// About the target's middle, so that it stays in sight.
void HoldPad::turn_by(double turn_rad, double tilt_rad, double roll_rad) {
    if (!pose_) {
        return;
    }
    const Eigen::Vector3d middle = *pose_ * middle_mm_;
    const Eigen::Matrix3d R =
        Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
        rotation_about_y(turn_rad) * rotation_about_x(tilt_rad) * pose_->R;
    pose_ = RigidTransform{nearest_rotation(R), Eigen::Vector3d::Zero()};
    pose_->t_mm = middle - pose_->R * middle_mm_;
    emit held_at(*pose_);
}

void HoldPad::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        from_ = event->pos();
        setCursor(Qt::ClosedHandCursor);
    }
}

void HoldPad::mouseMoveEvent(QMouseEvent* event) {
    if (!from_) {
        return;
    }
    const QPointF by = event->pos() - *from_;
    from_ = event->pos();
    if (event->modifiers().testFlag(Qt::ShiftModifier)) {
        turn_by(-rad_a_pixel * by.x(), rad_a_pixel * by.y(), 0.0);
    } else if (event->modifiers().testFlag(Qt::ControlModifier)) {
        turn_by(0.0, 0.0, rad_a_pixel * by.x());
    } else {
        move_by({mm_a_pixel * by.x(), mm_a_pixel * by.y(), 0.0});
    }
}

void HoldPad::mouseReleaseEvent(QMouseEvent*) {
    from_.reset();
    setCursor(Qt::OpenHandCursor);
}

void HoldPad::wheelEvent(QWheelEvent* event) {
    move_by({0.0, 0.0, mm_a_notch * event->angleDelta().y() / degrees_a_notch});
    event->accept();
}

void HoldPad::keyPressEvent(QKeyEvent* event) {
    const bool turns = event->modifiers().testFlag(Qt::ShiftModifier);
    const bool rolls = event->modifiers().testFlag(Qt::ControlModifier);
    const auto step = [&](double across, double down) {
        if (rolls) {
            turn_by(0.0, 0.0, rad_a_key * across);
        } else if (turns) {
            turn_by(-rad_a_key * across, rad_a_key * down, 0.0);
        } else {
            move_by({mm_a_key * across, mm_a_key * down, 0.0});
        }
    };
    switch (event->key()) {
        case Qt::Key_Left:
            return step(-1.0, 0.0);
        case Qt::Key_Right:
            return step(1.0, 0.0);
        case Qt::Key_Up:
            return step(0.0, -1.0);
        case Qt::Key_Down:
            return step(0.0, 1.0);
        case Qt::Key_PageUp:
            return move_by({0.0, 0.0, mm_a_key});
        case Qt::Key_PageDown:
            return move_by({0.0, 0.0, -mm_a_key});
        default:
            QWidget::keyPressEvent(event);
    }
}

void HoldPad::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setPen(hasFocus() ? theme::accent : theme::line);
    painter.setBrush(theme::panel);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.setPen(pose_ ? theme::text : theme::faint);
    painter.drawText(rect().adjusted(8, 4, -8, -4), Qt::AlignCenter | Qt::TextWordWrap,
                     pose_ ? tr("Drag here to hold the target.\nShift: turn, wheel: nearer")
                           : tr("Nothing to hold yet"));
}

}  // namespace kambara::ui
