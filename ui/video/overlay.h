// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/image/rectangle.h"
#include "core/vsystem/snapshot.h"
#include "ui/video/view_transform.h"

class QPainter;

namespace kambara::ui {

enum class ViewedCamera { left, right, pan_tilt };

/// Paints over a picture what the snapshot says of it: left the match and the window searched,
/// right the match and its epipolar curve, pan-tilt the middle it is aimed with.
void paint_overlay(QPainter& painter, const ViewTransform& view, ViewedCamera camera,
                   const Snapshot& snapshot);

/// Paints a rectangle that is being chosen, with its size.
void paint_selection(QPainter& painter, const ViewTransform& view, const Rectangle& rectangle);

}  // namespace kambara::ui
