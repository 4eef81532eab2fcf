// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSize>

#include "core/image/rectangle.h"

namespace kambara::ui {

/// A rectangle of whole pixels that an operator draws or moves. It never leaves the picture.
class RectangleSelection {
  public:
    static constexpr int least_size_px = 7;

    RectangleSelection() = default;
    /// A corner of it, from which drag_to() draws.
    RectangleSelection(const QSize& picture, const QPointF& corner_px);
    /// A square in the middle of the picture.
    static RectangleSelection centred(const QSize& picture, int size_px);

    void drag_to(const QPointF& corner_px);
    void move(int dx_px, int dy_px);
    void grow(int dx_px, int dy_px);  ///< about its centre, by so much to each side

    Rectangle rectangle() const { return rectangle_; }
    bool large_enough() const {
        return rectangle_.width >= least_size_px && rectangle_.height >= least_size_px;
    }

  private:
    void keep_inside();

    QSize picture_;
    QPointF anchor_px_;
    Rectangle rectangle_{0, 0, 0, 0};
};

}  // namespace kambara::ui
