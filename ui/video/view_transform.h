// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSize>

namespace kambara::ui {

/// How a picture lies in a widget: zoomed evenly in both directions, so its aspect is kept. Pixel
/// coordinates name pixel centres: the top-left pixel covers (-0.5, -0.5) to (0.5, 0.5).
class ViewTransform {
  public:
    /// The whole picture, as large as it fits, in the middle.
    static ViewTransform fitted(const QSize& picture, const QSize& widget);
    /// One picture pixel a screen pixel, the same pixel in the middle as before.
    ViewTransform at_full_size(const QSize& widget) const;
    /// Zoomed by `factor` with the place under `anchor` kept; within least_zoom and most_zoom.
    ViewTransform zoomed(double factor, const QPointF& anchor) const;
    ViewTransform moved(const QPointF& by) const;

    QPointF widget_from_pixel(const QPointF& pixel) const;
    QPointF pixel_from_widget(const QPointF& point) const;
    /// Where a picture of that size is drawn.
    QRectF picture_area(const QSize& picture) const;
    double zoom() const { return zoom_; }

    static constexpr double least_zoom = 0.05;
    static constexpr double most_zoom = 64.0;

  private:
    double zoom_ = 1.0;
    QPointF offset_;  // widget coordinates of the picture's top-left corner
};

}  // namespace kambara::ui
