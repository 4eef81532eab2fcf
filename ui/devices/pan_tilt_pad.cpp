// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/pan_tilt_pad.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr double margin = 8.0;
constexpr double mark_px = 8.0;  // its radius

}  // namespace

PanTiltPad::PanTiltPad(QWidget* parent) : QWidget(parent) {
    setToolTip(
        tr("Press or drag to look there. The dot is where the head looks, the ring where it was "
           "told to."));
    setAccessibleName(tr("Pan-tilt pad"));
}

void PanTiltPad::show_head(const std::optional<HeadSnapshot>& head) {
    if (head != head_) {
        head_ = head;
        update();
    }
}

void PanTiltPad::set_limits(const HeadLimits& limits) {
    if (limits != limits_) {
        limits_ = limits;
        update();
    }
}

QRectF PanTiltPad::field() const {
    return QRectF(rect()).adjusted(margin, margin, -margin, -margin);
}

QPointF PanTiltPad::point_of(const HeadAngles& angles) const {
    const QRectF area = field();
    return {area.center().x() + 0.5 * area.width() * angles.pan_rad / limits_.pan_rad,
            area.center().y() - 0.5 * area.height() * angles.tilt_rad / limits_.tilt_rad};
}

HeadAngles PanTiltPad::angles_at(const QPointF& point) const {
    const QRectF area = field();
    const double across = (point.x() - area.center().x()) / (0.5 * area.width());
    const double up = (area.center().y() - point.y()) / (0.5 * area.height());
    return {std::clamp(across, -1.0, 1.0) * limits_.pan_rad,
            std::clamp(up, -1.0, 1.0) * limits_.tilt_rad};
}

void PanTiltPad::ask(const QPointF& point) {
    const HeadAngles angles = angles_at(point);
    emit asked_for(angles.pan_rad, angles.tilt_rad);
}

void PanTiltPad::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && isEnabled()) {
        ask(event->pos());
    }
}

void PanTiltPad::mouseMoveEvent(QMouseEvent* event) {
    if ((event->buttons() & Qt::LeftButton) != 0 && isEnabled()) {
        ask(event->pos());
    }
}

void PanTiltPad::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = field();
    painter.setPen(QPen(theme::line, 1.0));
    painter.setBrush(theme::panel);
    painter.drawRoundedRect(area, 4.0, 4.0);
    painter.drawLine(QPointF(area.center().x(), area.top()),
                     QPointF(area.center().x(), area.bottom()));
    painter.drawLine(QPointF(area.left(), area.center().y()),
                     QPointF(area.right(), area.center().y()));
    painter.setPen(theme::faint);
    const QRectF inner = area.adjusted(4.0, 2.0, -4.0, -2.0);
    painter.drawText(inner, Qt::AlignRight | Qt::AlignBottom, degrees(limits_.pan_rad, 0));
    painter.drawText(inner, Qt::AlignLeft | Qt::AlignBottom, degrees(-limits_.pan_rad, 0));
    // Beside the middle line, where the marks of a head at home and straight above are not.
    painter.drawText(inner.adjusted(0.5 * inner.width() + mark_px + 4.0, 0.0, 0.0, 0.0),
                     Qt::AlignLeft | Qt::AlignTop, degrees(limits_.tilt_rad, 0));
    if (!head_) {
        painter.drawText(inner, Qt::AlignCenter, tr("no head"));
        return;
    }
    if (head_->commanded) {
        painter.setPen(QPen(theme::accent, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(point_of(*head_->commanded), mark_px, mark_px);
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(head_->automatic ? theme::good : theme::caution);
    painter.drawEllipse(point_of(head_->angles), 4.5, 4.5);
}

}  // namespace kambara::ui
