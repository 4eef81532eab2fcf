// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/residual_plot.h"

#include <QPainter>
#include <algorithm>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/calibration/guide_view.h"

namespace kambara::ui {
namespace {

constexpr double stretch = 100.0;

}  // namespace

ResidualPlot::ResidualPlot(std::size_t camera, const CalibrationReport& report, QWidget* parent)
    : QWidget(parent) {
    const CameraResult& result = *report.cameras[camera];
    picture_ = QSizeF(result.camera.width_px, result.camera.height_px);
    title_ = tr("%1: residuals %2, drawn %3 times as long")
                 .arg(camera_title(camera), pixels(result.rms_px, 3))
                 .arg(stretch);
    for (const Residual& residual : report.residuals) {
        if (residual.camera == static_cast<int>(camera)) {
            residuals_.push_back(residual);
        }
    }
    setAccessibleName(title_);
}

void ResidualPlot::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = painter.fontMetrics().height() + 4.0;
    painter.setPen(theme::text);
    painter.drawText(QRectF(0.0, 0.0, width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(title_, Qt::ElideRight, width()));
    const double scale =
        std::min((width() - 2.0) / picture_.width(), (height() - line - 2.0) / picture_.height());
    const QRectF area(QPointF(1.0, line), picture_ * scale);
    painter.setPen(theme::line);
    painter.setBrush(theme::panel);
    painter.drawRect(area);
    painter.setClipRect(area);
    for (const Residual& residual : residuals_) {
        const QPointF from = area.topLeft() + scale * QPointF(residual.px.x(), residual.px.y());
        const QPointF by =
            scale * stretch * QPointF(residual.residual_px.x(), residual.residual_px.y());
        painter.setPen(QPen(residual.used ? theme::accent : theme::bad, 1.2));
        painter.drawLine(from, from + by);
    }
}

}  // namespace kambara::ui
