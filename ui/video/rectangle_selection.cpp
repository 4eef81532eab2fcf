// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/rectangle_selection.h"

#include <algorithm>
#include <cmath>

namespace kambara::ui {
namespace {

int inside(double coordinate_px, int size) {
    return std::clamp(static_cast<int>(std::lround(coordinate_px)), 0, std::max(0, size - 1));
}

}  // namespace

RectangleSelection::RectangleSelection(const QSize& picture, const QPointF& corner_px)
    : picture_(picture), anchor_px_(corner_px) {
    drag_to(corner_px);
}

RectangleSelection RectangleSelection::centred(const QSize& picture, int size_px) {
    RectangleSelection selection;
    selection.picture_ = picture;
    selection.rectangle_ = {(picture.width() - size_px) / 2, (picture.height() - size_px) / 2,
                            size_px, size_px};
    selection.keep_inside();
    return selection;
}

void RectangleSelection::drag_to(const QPointF& corner_px) {
    const int x0 = inside(anchor_px_.x(), picture_.width());
    const int y0 = inside(anchor_px_.y(), picture_.height());
    const int x1 = inside(corner_px.x(), picture_.width());
    const int y1 = inside(corner_px.y(), picture_.height());
    rectangle_ = {std::min(x0, x1), std::min(y0, y1), std::abs(x1 - x0) + 1, std::abs(y1 - y0) + 1};
}

void RectangleSelection::move(int dx_px, int dy_px) {
    rectangle_.x += dx_px;
    rectangle_.y += dy_px;
    keep_inside();
}

void RectangleSelection::grow(int dx_px, int dy_px) {
    const int dx = std::max(dx_px, (least_size_px - rectangle_.width) / 2);
    const int dy = std::max(dy_px, (least_size_px - rectangle_.height) / 2);
    rectangle_ = {rectangle_.x - dx, rectangle_.y - dy, rectangle_.width + 2 * dx,
                  rectangle_.height + 2 * dy};
    keep_inside();
}

void RectangleSelection::keep_inside() {
    rectangle_.width = std::min(rectangle_.width, picture_.width());
    rectangle_.height = std::min(rectangle_.height, picture_.height());
    rectangle_.x = std::clamp(rectangle_.x, 0, picture_.width() - rectangle_.width);
    rectangle_.y = std::clamp(rectangle_.y, 0, picture_.height() - rectangle_.height);
}

}  // namespace kambara::ui
