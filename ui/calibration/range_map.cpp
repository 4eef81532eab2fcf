// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/range_map.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/angles.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr double green_up_to = 0.001;  // of the range
constexpr double red_from = 0.005;

QColor colour_of_share(double share) {
    const double at = std::clamp((share - green_up_to) / (red_from - green_up_to), 0.0, 1.0);
    const QColor from = at < 0.5 ? theme::good : theme::caution;
    const QColor to = at < 0.5 ? theme::caution : theme::bad;
    const double part = at < 0.5 ? 2.0 * at : 2.0 * at - 1.0;
    const auto mix = [part](int a, int b) {
        return static_cast<int>(std::lround(a + part * (b - a)));
    };
    return {mix(from.red(), to.red()), mix(from.green(), to.green()), mix(from.blue(), to.blue())};
}

}  // namespace

RangeMap::RangeMap(const std::vector<RangeErrorPoint>& points, QWidget* parent) : QWidget(parent) {
    for (const RangeErrorPoint& point : points) {
        if (std::abs(point.height_mm) < 1.0) {
            points_.push_back(point);
        }
    }
    setAccessibleName(tr("Range errors"));
}

void RangeMap::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    if (points_.empty()) {
        painter.setPen(theme::faint);
        painter.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Ranges need a left and a right camera that see the same place."));
        return;
    }
    std::set<double> azimuths;
    std::set<double> depths;
    for (const RangeErrorPoint& point : points_) {
        azimuths.insert(point.azimuth_deg);
        depths.insert(point.depth_mm);
    }
    const double line = painter.fontMetrics().height() + 4.0;
    const double left = painter.fontMetrics().horizontalAdvance(millimetres(9999.0, 0)) + 10.0;
    const QRectF area(left, line, width() - left - 2.0, height() - 2.0 * line - 2.0);
    const QSizeF cell(area.width() / static_cast<double>(azimuths.size()),
                      area.height() / static_cast<double>(depths.size()));
    painter.setPen(theme::text);
    painter.drawText(QRectF(0.0, 0.0, width(), line), Qt::AlignLeft,
                     painter.fontMetrics().elidedText(
                         tr("One deviation of the range, from what the calibration leaves open"),
                         Qt::ElideRight, width()));
    painter.setPen(theme::faint);
    int row = 0;
    for (const double depth : depths) {
        const double top = area.bottom() - ++row * cell.height();
        painter.drawText(QRectF(0.0, top, left - 6.0, cell.height()),
                         Qt::AlignRight | Qt::AlignVCenter, millimetres(depth, 0));
    }
    int column = 0;
    for (const double azimuth : azimuths) {
        painter.drawText(
            QRectF(area.left() + column++ * cell.width(), area.bottom(), cell.width(), line),
            Qt::AlignCenter, degrees(rad_from_deg(azimuth), 0));
    }
    for (const RangeErrorPoint& point : points_) {
        const auto x = std::distance(azimuths.begin(), azimuths.find(point.azimuth_deg));
        const auto y = std::distance(depths.begin(), depths.find(point.depth_mm));
        const QRectF place(
            QPointF(area.left() + static_cast<double>(x) * cell.width() + 1.0,
                    area.bottom() - static_cast<double>(y + 1) * cell.height() + 1.0),
            cell - QSizeF(2.0, 2.0));
        const double share = point.sigma_calibration_mm / point.range_mm;
        painter.fillRect(place, colour_of_share(share));
        painter.setPen(Qt::black);
        painter.drawText(place, Qt::AlignCenter, percent(share, 3));
    }
}

}  // namespace kambara::ui
