// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/head_stick.h"

#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr double margin = 4.0;
constexpr double knob_share = 0.26;  // of the radius
constexpr double dead_share = 0.08;

}  // namespace

HeadStick::HeadStick(QWidget* parent) : QWidget(parent) {
    allow(false, QString());
    setAccessibleName(tr("Stick"));
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
}

void HeadStick::allow(bool able, const QString& reason_not) {
    setEnabled(able);
    setToolTip(able ? tr("Press and hold to turn the head: the farther from the middle, the "
                         "faster. The arrow keys do the same.")
                    : reason_not);
}

QPointF HeadStick::middle() const {
    return QRectF(rect()).center();
}

double HeadStick::radius() const {
    return 0.5 * std::min(width(), height()) - margin;
}

QPointF HeadStick::deflection_at(const QPointF& point) const {
    const QPointF off = point - middle();
    const double way = std::hypot(off.x(), off.y()) / (radius() * (1.0 - knob_share));
    if (way < dead_share) {
        return {0.0, 0.0};
    }
    const double share = std::min(1.0, way);
    const double speed = share * share;
    const double length = std::hypot(off.x(), off.y());
    return {speed * off.x() / length, -speed * off.y() / length};
}

void HeadStick::take(const QPointF& point) {
    const QPointF off = point - middle();
    const double most = radius() * (1.0 - knob_share);
    const double length = std::hypot(off.x(), off.y());
    knob_ = length > most ? off * (most / length) : off;
    emit held(deflection_at(point));
    update();
}

void HeadStick::spring_back() {
    if (!pressed_) {
        return;
    }
    pressed_ = false;
    knob_ = {};
    emit let_go();
    update();
}

void HeadStick::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        pressed_ = true;
        take(event->pos());
    }
}

void HeadStick::mouseMoveEvent(QMouseEvent* event) {
    if (pressed_) {
        take(event->pos());
    }
}

void HeadStick::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        spring_back();
    }
}

// Whoever is disabled or hidden gets no release any more.
void HeadStick::changeEvent(QEvent* event) {
    if (event->type() == QEvent::EnabledChange && !isEnabled()) {
        spring_back();
    }
    QWidget::changeEvent(event);
}

void HeadStick::hideEvent(QHideEvent* event) {
    spring_back();
    QWidget::hideEvent(event);
}

void HeadStick::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double r = radius();
    const QPointF centre = middle();
    painter.setPen(QPen(theme::line, 1.0));
    painter.setBrush(theme::panel);
    painter.drawEllipse(centre, r, r);
    painter.drawLine(centre - QPointF(r, 0.0), centre + QPointF(r, 0.0));
    painter.drawLine(centre - QPointF(0.0, r), centre + QPointF(0.0, r));
    const QColor knob = !isEnabled() ? theme::line : pressed_ ? theme::accent : theme::faint;
    painter.setPen(Qt::NoPen);
    painter.setBrush(knob);
    painter.drawEllipse(centre + knob_, r * knob_share, r * knob_share);
}

}  // namespace kambara::ui
