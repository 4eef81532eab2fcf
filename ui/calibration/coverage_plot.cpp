// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/coverage_plot.h"

#include <QPainter>
#include <algorithm>
#include <cmath>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr double most_deg = 50.0;
constexpr double least_depth_mm = 400.0;
constexpr double least_top_mm = 1600.0;

}  // namespace

CoveragePlot::CoveragePlot(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Depths and angles covered"));
}

void CoveragePlot::show_coverage(const Coverage& coverage) {
    coverage_ = coverage;
    update();
}

void CoveragePlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QFontMetrics metrics = painter.fontMetrics();
    const double line = metrics.height();
    const double scale_width = metrics.horizontalAdvance(millimetres(9999.0, 0)) + 26.0;
    const double side = std::min(width() - scale_width - 24.0, height() - 2.0 * line - 12.0);
    const QRectF field(4.0, line + 4.0, side, side);
    const QRectF depth(width() - scale_width, field.top(), 18.0, side);
    painter.setPen(theme::faint);
    painter.drawText(QPointF(field.left(), line - 3.0), tr("Turned and tilted"));
    painter.drawText(QRectF(depth.left() - 30.0, 0.0, scale_width + 30.0, line), Qt::AlignLeft,
                     tr("Depth"));
    painter.setPen(theme::line);
    painter.setBrush(theme::panel);
    painter.drawRect(field);
    painter.drawRect(depth);
    painter.drawLine(QPointF(field.center().x(), field.top()),
                     QPointF(field.center().x(), field.bottom()));
    painter.drawLine(QPointF(field.left(), field.center().y()),
                     QPointF(field.right(), field.center().y()));
    painter.setPen(theme::faint);
    painter.drawText(QRectF(field.left(), field.bottom() + 2.0, field.width(), line),
                     Qt::AlignHCenter, QStringLiteral("\u00B1%1\u202F\u00B0").arg(most_deg));
    const double top_mm = std::max(least_top_mm, 1.1 * coverage_.farthest_mm);
    const auto at_depth = [&](double mm) {
        const double share = (mm - least_depth_mm) / (top_mm - least_depth_mm);
        return depth.top() + std::clamp(share, 0.0, 1.0) * depth.height();
    };
    for (const double mm : {500.0, 1000.0, 1500.0, 2000.0}) {
        if (mm < top_mm) {
            painter.drawText(
                QRectF(depth.right() + 4.0, at_depth(mm) - 0.5 * line, scale_width - 22.0, line),
                Qt::AlignLeft | Qt::AlignVCenter, millimetres(mm, 0));
        }
    }
    if (coverage_.poses.empty()) {
        painter.drawText(field, Qt::AlignCenter | Qt::TextWordWrap, tr("No shot yet"));
        return;
    }
    QColor colour = theme::good;
    painter.setPen(Qt::NoPen);
    for (const HeldPose& pose : coverage_.poses) {
        colour.setAlpha(210);
        painter.setBrush(colour);
        const auto across = [](double deg) { return std::clamp(deg / most_deg, -1.0, 1.0); };
        painter.drawEllipse(
            field.center() + 0.5 * side * QPointF(across(pose.turn_deg), across(pose.tilt_deg)),
            4.0, 4.0);
        painter.fillRect(
            QRectF(depth.left() + 1.0, at_depth(pose.depth_mm) - 1.5, depth.width() - 2.0, 3.0),
            colour);
    }
}

}  // namespace kambara::ui
