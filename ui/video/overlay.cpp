// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/overlay.h"

#include <QPainter>
#include <QPolygonF>
#include <QStringList>
#include <cmath>
#include <limits>

#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr double arm = 6.0;  // of a cross, screen pixels

struct Look {
    QColor colour;
    double width = 2.0;
    QString label;
};

QPointF point(const Eigen::Vector2d& pixel) {
    return {pixel.x(), pixel.y()};
}

QRectF area(const ViewTransform& view, const Rectangle& rectangle) {
    return {view.widget_from_pixel({rectangle.x - 0.5, rectangle.y - 0.5}),
            view.widget_from_pixel(
                {rectangle.x + rectangle.width - 0.5, rectangle.y + rectangle.height - 0.5})};
}

void paint_match(QPainter& painter, const ViewTransform& view, const Eigen::Vector2d& pixel,
                 const Eigen::Vector2i& size_px, const Look& look) {
    const QPointF centre = view.widget_from_pixel(point(pixel));
    const QSizeF size(size_px.x() * view.zoom(), size_px.y() * view.zoom());
    const QRectF box(centre - QPointF(0.5 * size.width(), 0.5 * size.height()), size);
    painter.setPen(QPen(look.colour, look.width));
    painter.drawRect(box);
    painter.drawLine(centre - QPointF(arm, 0.0), centre + QPointF(arm, 0.0));
    painter.drawLine(centre - QPointF(0.0, arm), centre + QPointF(0.0, arm));
    if (!look.label.isEmpty()) {
        const QRectF text_area = painter.fontMetrics().boundingRect(look.label);
        const QRectF ground(box.left() - 1.0, box.top() - text_area.height() - 5.0,
                            text_area.width() + 10.0, text_area.height() + 4.0);
        painter.fillRect(ground, look.colour);
        painter.setPen(Qt::black);
        painter.drawText(ground, Qt::AlignCenter, look.label);
    }
}

// `said` is said of the steered target alone.
Look look_of(const Snapshot& snapshot, const TrackSnapshot& track, const QString& said) {
    const bool steered = track.id == snapshot.steered_target;
    QStringList label;
    if (snapshot.tracks.size() > 1) {
        label << QString::number(track.id);
    }
    if (steered && !said.isEmpty()) {
        label << said;
    } else if (!steered) {
        label << name_of(track.estimate.state);
    }
    return {colour_of(track.estimate.state), steered ? 2.5 : 1.0, label.join(QStringLiteral("  "))};
}

void paint_left(QPainter& painter, const ViewTransform& view, const Snapshot& snapshot,
                const TrackSnapshot& track) {
    const TrackEstimate& estimate = track.estimate;
    const bool steered = track.id == snapshot.steered_target;
    const Look look =
        look_of(snapshot, track,
                name_of(estimate.state) + QStringLiteral("  ") + percent(estimate.quality));
    if (steered && estimate.search && !estimate.search->map.empty()) {
        painter.setPen(QPen(look.colour, 1.0, Qt::DashLine));
        painter.drawRect(area(view, estimate.search->window()));
    }
    if (estimate.left_px) {
        paint_match(painter, view, *estimate.left_px, estimate.template_size_px, look);
    }
}

void paint_right(QPainter& painter, const ViewTransform& view, const Snapshot& snapshot,
                 const TrackSnapshot& track) {
    const TrackEstimate& estimate = track.estimate;
    const bool steered = track.id == snapshot.steered_target;
    if (steered && estimate.search && estimate.search->epipolar_px.size() > 1) {
        QPolygonF curve;
        for (const Eigen::Vector2d& pixel : estimate.search->epipolar_px) {
            curve << view.widget_from_pixel(point(pixel));
        }
        painter.setPen(QPen(theme::epipolar, 1.2));
        painter.drawPolyline(curve);
    }
    if (estimate.right_px) {
        const QString label = estimate.position
                                  ? millimetres(estimate.position->point_in_left_mm.norm(), 0)
                                  : QString();
        paint_match(painter, view, *estimate.right_px, estimate.template_size_px,
                    look_of(snapshot, track, label));
    }
}

void paint_aim(QPainter& painter, const ViewTransform& view, const Snapshot& snapshot) {
    const ImagePtr& picture = snapshot.pictures.pan_tilt.picture;
    if (!picture || !snapshot.head) {
        return;
    }
    const QPointF middle =
        view.widget_from_pixel({0.5 * (picture->width() - 1), 0.5 * (picture->height() - 1)});
    // Where it looks is not known for sure while it complains.
    const QColor colour = !snapshot.head->fault.empty() ? theme::bad
                          : snapshot.head->automatic    ? theme::good
                                                        : theme::caution;
    painter.setPen(QPen(colour, 1.5));
    for (const QPointF& side : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
        painter.drawLine(middle + arm * side, middle + 3.0 * arm * side);
    }
}

}  // namespace

void paint_overlay(QPainter& painter, const ViewTransform& view, ViewedCamera camera,
                   const Snapshot& snapshot) {
    if (camera == ViewedCamera::pan_tilt) {
        paint_aim(painter, view, snapshot);
        return;
    }
    for (const TrackSnapshot& track : snapshot.tracks) {
        if (camera == ViewedCamera::left) {
            paint_left(painter, view, snapshot, track);
        } else {
            paint_right(painter, view, snapshot, track);
        }
    }
}

std::optional<int> target_under(const Snapshot& snapshot, const QPointF& left_px) {
    std::optional<int> nearest;
    double nearest_px = std::numeric_limits<double>::infinity();
    for (const TrackSnapshot& track : snapshot.tracks) {
        if (!track.estimate.left_px) {
            continue;
        }
        const QPointF off = left_px - point(*track.estimate.left_px);
        const Eigen::Vector2d half_px = 0.5 * track.estimate.template_size_px.cast<double>();
        const double distance_px = std::hypot(off.x(), off.y());
        if (std::abs(off.x()) <= half_px.x() && std::abs(off.y()) <= half_px.y() &&
            distance_px < nearest_px) {
            nearest = track.id;
            nearest_px = distance_px;
        }
    }
    return nearest;
}

void paint_selection(QPainter& painter, const ViewTransform& view, const Rectangle& rectangle) {
    const QRectF box = area(view, rectangle);
    painter.fillRect(box, QColor(0x4f, 0xb3, 0xff, 0x30));
    painter.setPen(QPen(theme::accent, 2.0));
    painter.drawRect(box);
    const QString size =
        QStringLiteral("%1 \u00D7 %2 px").arg(rectangle.width).arg(rectangle.height);
    const QRectF ground(box.left(), box.bottom() + 3.0,
                        painter.fontMetrics().horizontalAdvance(size) + 10.0,
                        painter.fontMetrics().height() + 2.0);
    painter.fillRect(ground, theme::accent);
    painter.setPen(Qt::black);
    painter.drawText(ground, Qt::AlignCenter, size);
}

}  // namespace kambara::ui
