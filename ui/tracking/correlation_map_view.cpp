// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tracking/correlation_map_view.h"

#include <QPainter>
#include <algorithm>
#include <utility>
#include <vector>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/tracking/heat_colours.h"

namespace kambara::ui {
namespace {

constexpr int margin = 8;
constexpr int bar_width = 12;

}  // namespace

CorrelationMapView::CorrelationMapView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
}

void CorrelationMapView::show_snapshot(const SnapshotPtr& snapshot) {
    const TrackEstimate estimate = steered_estimate(*snapshot);
    auto search = estimate.search;
    const bool was_lost = std::exchange(lost_, estimate.state == TrackState::lost);
    if (search != search_ || lost_ != was_lost) {
        search_ = std::move(search);
        colour();
        update();
    }
}

void CorrelationMapView::clear() {
    search_.reset();
    lost_ = false;
    image_ = {};
    update();
}

void CorrelationMapView::set_stretched(bool stretched) {
    stretched_ = stretched;
    colour();
    update();
}

void CorrelationMapView::colour() {
    if (!has_map()) {
        image_ = {};
        return;
    }
    const ScoreMap& map = search_->map;
    std::vector<double> likeness(map.size());
    for (std::size_t i = 0; i < map.size(); ++i) {
        likeness[i] = search_->likeness(map.value(i));
    }
    const auto [least, most] = std::minmax_element(likeness.begin(), likeness.end());
    const auto place = static_cast<int>(most - likeness.begin());
    best_ = {place % map.positions.width, place / map.positions.width};
    lowest_ = stretched_ ? *least : 0.0;
    highest_ = stretched_ && *most > *least ? *most : 1.0;
    image_ = QImage(map.positions.width, map.positions.height, QImage::Format_RGB32);
    auto value = likeness.begin();
    for (int y = 0; y < image_.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image_.scanLine(y));
        for (int x = 0; x < image_.width(); ++x) {
            row[x] = heat_colour((*value++ - lowest_) / (highest_ - lowest_));
        }
    }
}

void CorrelationMapView::paint_scale(QPainter& painter, const QRect& bar) const {
    for (int y = 0; y < bar.height(); ++y) {
        const double share = 1.0 - static_cast<double>(y) / std::max(1, bar.height() - 1);
        painter.fillRect(bar.left(), bar.top() + y, bar.width(), 1, QColor(heat_colour(share)));
    }
    painter.setPen(theme::text);
    const int below = painter.fontMetrics().ascent();
    painter.drawText(bar.right() + 5, bar.top() + below, percent(highest_));
    painter.drawText(bar.right() + 5, bar.bottom(), percent(lowest_));
}

void CorrelationMapView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), theme::ground);
    if (image_.isNull()) {
        painter.setPen(theme::faint);
        painter.drawText(rect().adjusted(margin, margin, -margin, -margin),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         lost_ ? tr("The target is lost; there is no search to show just now.")
                               : tr("No search yet. Choose a target in the left picture."));
        return;
    }
    const int labels = painter.fontMetrics().horizontalAdvance(percent(1.0)) + 8;
    const QRect room = rect().adjusted(margin, margin, -(margin + bar_width + labels + 6), -margin);
    const QSize size = image_.size().scaled(room.size(), Qt::KeepAspectRatio);
    const QRect area(room.left() + (room.width() - size.width()) / 2,
                     room.top() + (room.height() - size.height()) / 2, size.width(), size.height());
    painter.drawImage(area, image_);
    const double zoom = static_cast<double>(area.width()) / image_.width();
    const QPointF best = QPointF(area.topLeft()) + (QPointF(best_) + QPointF(0.5, 0.5)) * zoom;
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme::epipolar, 1.5));
    painter.drawEllipse(best, 7.0, 7.0);
    painter.setRenderHint(QPainter::Antialiasing, false);
    paint_scale(painter, {area.right() + 7, area.top(), bar_width, area.height()});
}

}  // namespace kambara::ui
