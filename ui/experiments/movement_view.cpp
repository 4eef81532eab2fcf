// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/movement_view.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr double margin_px = 14.0;
constexpr double least_span_mm = 20.0;  // a target at rest does not fill the view with its noise

}  // namespace

MovementView::MovementView(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Recorded positions"));
}

void MovementView::set_hint(const QString& hint) {
    hint_ = hint;
    update();
}

void MovementView::show_points(std::vector<Eigen::Vector3d> points_in_rig_mm,
                               const std::optional<Eigen::Vector3d>& direction) {
    points_ = std::move(points_in_rig_mm);
    direction_ = direction;
    if (!points_.empty()) {
        least_ = most_ = points_.front();
        for (const Eigen::Vector3d& p : points_) {
            least_ = least_.cwiseMin(p);
            most_ = most_.cwiseMax(p);
        }
    }
    update();
}

double MovementView::scale_for(const QSizeF& area) const {
    const Eigen::Vector3d span = (most_ - least_).cwiseMax(least_span_mm);
    return std::min((area.width() - 2.0 * margin_px) / std::max(span.x(), span.z()),
                    (area.height() - 2.0 * margin_px) / span.y());
}

void MovementView::paint_side(QPainter& painter, const QRectF& area, int across,
                              const QString& title) const {
    const double line = painter.fontMetrics().height() + 4.0;
    painter.setPen(theme::text);
    painter.drawText(
        QRectF(area.left(), area.top(), area.width(), line), Qt::AlignLeft,
        painter.fontMetrics().elidedText(title, Qt::ElideRight, static_cast<int>(area.width())));
    const QRectF field = area.adjusted(0.0, line, -1.0, -line);
    painter.setPen(theme::line);
    painter.setBrush(theme::panel);
    painter.drawRect(field);
    const double scale = scale_for(field.size());
    const Eigen::Vector3d middle = 0.5 * (least_ + most_);
    const auto place = [&](const Eigen::Vector3d& p) {
        return field.center() + scale * QPointF(p[across] - middle[across], p.y() - middle.y());
    };
    // A length to read the others by.
    const double raw_mm = 0.25 * field.width() / scale;
    const double decade = std::pow(10.0, std::floor(std::log10(raw_mm)));
    const double bar_mm = (raw_mm >= 5.0 * decade   ? 5.0
                           : raw_mm >= 2.0 * decade ? 2.0
                                                    : 1.0) *
                          decade;
    painter.setPen(QPen(theme::faint, 2.0));
    const QPointF bar(field.left(), field.bottom() + 4.0);
    painter.drawLine(bar, bar + QPointF(scale * bar_mm, 0.0));
    painter.setPen(theme::faint);
    painter.drawText(QRectF(bar.x() + scale * bar_mm + 6.0, field.bottom() + 1.0,
                            field.width() - scale * bar_mm - 6.0, line),
                     Qt::AlignLeft, millimetres(bar_mm, 0));
    painter.setClipRect(field);
    if (direction_) {
        Eigen::Vector3d mean = Eigen::Vector3d::Zero();
        for (const Eigen::Vector3d& p : points_) {
            mean += p / static_cast<double>(points_.size());
        }
        const double reach_mm = field.height() / scale;
        painter.setPen(QPen(theme::good, 1.5));
        painter.drawLine(place(mean - reach_mm * *direction_),
                         place(mean + reach_mm * *direction_));
    }
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::accent);
    for (const Eigen::Vector3d& p : points_) {
        painter.drawEllipse(place(p), 2.0, 2.0);
    }
    painter.setClipping(false);
}

void MovementView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    if (points_.empty()) {
        painter.setPen(theme::line);
        painter.setBrush(theme::panel);
        painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
        painter.setPen(theme::faint);
        painter.drawText(rect().adjusted(20, 20, -20, -20), Qt::AlignCenter | Qt::TextWordWrap,
                         hint_);
        return;
    }
    const double half = 0.5 * (width() - margin_px);
    paint_side(painter, {0.0, 0.0, half, double(height())}, 0, tr("From the front: x, y"));
    paint_side(painter, {half + margin_px, 0.0, half, double(height())}, 2,
               tr("From the side: z, y"));
}

}  // namespace kambara::ui
