// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/view_transform.h"

#include <algorithm>

namespace kambara::ui {
namespace {

const QPointF half_a_pixel(0.5, 0.5);

}  // namespace

ViewTransform ViewTransform::fitted(const QSize& picture, const QSize& widget) {
    ViewTransform view;
    if (picture.isEmpty() || widget.isEmpty()) {
        return view;
    }
    view.zoom_ = std::clamp(std::min(static_cast<double>(widget.width()) / picture.width(),
                                     static_cast<double>(widget.height()) / picture.height()),
                            least_zoom, most_zoom);
    view.offset_ = {0.5 * (widget.width() - view.zoom_ * picture.width()),
                    0.5 * (widget.height() - view.zoom_ * picture.height())};
    return view;
}

ViewTransform ViewTransform::at_full_size(const QSize& widget) const {
    return zoomed(1.0 / zoom_, {0.5 * widget.width(), 0.5 * widget.height()});
}

ViewTransform ViewTransform::zoomed(double factor, const QPointF& anchor) const {
    ViewTransform view = *this;
    view.zoom_ = std::clamp(zoom_ * factor, least_zoom, most_zoom);
    view.offset_ = anchor - (anchor - offset_) * (view.zoom_ / zoom_);
    return view;
}

ViewTransform ViewTransform::moved(const QPointF& by) const {
    ViewTransform view = *this;
    view.offset_ += by;
    return view;
}

QPointF ViewTransform::widget_from_pixel(const QPointF& pixel) const {
    return (pixel + half_a_pixel) * zoom_ + offset_;
}

QPointF ViewTransform::pixel_from_widget(const QPointF& point) const {
    return (point - offset_) / zoom_ - half_a_pixel;
}

QRectF ViewTransform::picture_area(const QSize& picture) const {
    return {offset_, QSizeF(picture) * zoom_};
}

}  // namespace kambara::ui
