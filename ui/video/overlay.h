// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <optional>

#include "core/image/rectangle.h"
#include "core/vsystem/snapshot.h"
#include "ui/video/view_transform.h"

class QPainter;

namespace kambara::ui {

enum class ViewedCamera { left, right, pan_tilt };

/// Paints over a picture what the snapshot says of it: left the matches and the window searched,
/// right the matches and the epipolar curve, pan-tilt the middle it is aimed with. Of several
/// targets each has its number; the steered one is drawn stronger, and how it was searched shown.
void paint_overlay(QPainter& painter, const ViewTransform& view, ViewedCamera camera,
                   const Snapshot& snapshot);

/// The number of the target whose box in the left picture holds that pixel: of several the one
/// whose middle is nearest.
std::optional<int> target_under(const Snapshot& snapshot, const QPointF& left_px);

/// Paints a rectangle that is being chosen, with its size.
void paint_selection(QPainter& painter, const ViewTransform& view, const Rectangle& rectangle);

}  // namespace kambara::ui
