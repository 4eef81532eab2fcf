// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/guide_view.h"

#include <QPainter>
#include <QPolygonF>
#include <algorithm>

#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/video/picture_image.h"
#include "ui/video/view_transform.h"

namespace kambara::ui {
namespace {

constexpr int faintest = 22;  // of 255
constexpr int stronger_each_view = 14;
constexpr int strongest = 92;

void paint_note(QPainter& painter, const QRectF& row, int alignment, const QString& text,
                const QColor& colour) {
    const QFontMetrics metrics = painter.fontMetrics();
    const QString fitting =
        metrics.elidedText(text, Qt::ElideRight, static_cast<int>(row.width()) - 12);
    QRectF box(row.left(), row.top(), metrics.horizontalAdvance(fitting) + 12.0, row.height());
    if ((alignment & Qt::AlignRight) != 0) {
        box.moveRight(row.right());
    }
    painter.fillRect(box, QColor(0, 0, 0, 190));
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, fitting);
}

}  // namespace

QString camera_title(std::size_t camera) {
    switch (camera) {
        case 0:
            return GuideView::tr("Left");
        case 1:
            return GuideView::tr("Right");
        default:
            return GuideView::tr("Pan-tilt");
    }
}

GuideView::GuideView(std::size_t camera, const QString& title, QWidget* parent)
    : QWidget(parent), camera_(camera), title_(title) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(title);
}

void GuideView::show_look(const SessionLook& look) {
    image_ = image_sharing(look.pictures[camera_]);
    sight_ = look.look.seen.sights[camera_];
    update();
}

void GuideView::show_state(const SessionState& state) {
    coverage_ = state.coverage.pictures[camera_];
    outlines_px_.clear();
    if (state.next) {
        outlines_px_ = state.next->outlines_px[camera_];
    }
    update();
}

void GuideView::clear() {
    image_ = {};
    sight_ = {};
    outlines_px_.clear();
    coverage_ = {};
    update();
}

void GuideView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(0x12, 0x14, 0x18));
    if (image_.isNull()) {
        painter.setPen(theme::faint);
        painter.drawText(rect(), Qt::AlignCenter, tr("%1: no picture yet").arg(title_));
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const auto view = ViewTransform::fitted(image_.size(), size());
    const QRectF area = view.picture_area(image_.size());
    painter.drawImage(area, image_);
    painter.setClipRect(area);
    const double field_width = area.width() / PictureCoverage::across;
    const double field_height = area.height() / PictureCoverage::down;
    for (int i = 0; i < PictureCoverage::across * PictureCoverage::down; ++i) {
        if (const int views = coverage_.views[static_cast<std::size_t>(i)]; views > 0) {
            QColor colour = theme::good;
            colour.setAlpha(std::min(strongest, faintest + stronger_each_view * views));
            painter.fillRect(QRectF(area.left() + (i % PictureCoverage::across) * field_width,
                                    area.top() + (i / PictureCoverage::across) * field_height,
                                    field_width, field_height),
                             colour);
        }
    }
    painter.setBrush(Qt::NoBrush);
    for (const auto& outline : outlines_px_) {
        QPolygonF polygon;
        for (const auto& px : outline) {
            polygon << view.widget_from_pixel({px.x(), px.y()});
        }
        painter.setPen(QPen(QColor(0, 0, 0, 170), 5.0));
        painter.drawPolygon(polygon);
        painter.setPen(QPen(theme::accent, 2.5));
        painter.drawPolygon(polygon);
    }
    painter.setPen(QPen(Qt::black, 1.0));
    painter.setBrush(theme::caution);
    for (const DetectedCorner& corner : sight_.corners) {
        painter.drawEllipse(view.widget_from_pixel({corner.px.x(), corner.px.y()}), 3.0, 3.0);
    }
    const double height = painter.fontMetrics().height() + 6.0;
    const QRectF top(area.left() + 4.0, area.top() + 4.0, area.width() - 8.0, height);
    paint_note(painter, top, Qt::AlignLeft, title_, theme::text);
    paint_note(painter, top, Qt::AlignRight, tr("%1 covered").arg(percent(coverage_.share)),
               coverage_.share > 0.0 ? theme::good : theme::faint);
    const QRectF bottom(area.left() + 4.0, area.bottom() - height - 4.0, area.width() - 8.0,
                        height);
    if (!sight_.corners.empty()) {
        paint_note(painter, bottom, Qt::AlignLeft,
                   tr("%1 corners found").arg(sight_.corners.size()), theme::good);
    } else if (!sight_.fault.empty()) {
        paint_note(painter, bottom, Qt::AlignLeft, translated(sight_.fault), theme::caution);
    }
}

}  // namespace kambara::ui
