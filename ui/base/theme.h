// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

#include "core/tracking/track_state.h"

class QApplication;

namespace kambara::ui {

/// The window's colours: dark, since pictures are judged by eye, with a contrast of text to ground
/// of at least 7 to 1.
namespace theme {
inline const QColor ground(0x1b, 0x1e, 0x23);
inline const QColor panel(0x26, 0x2a, 0x31);
inline const QColor line(0x48, 0x4f, 0x5a);
inline const QColor text(0xe8, 0xea, 0xed);
inline const QColor faint(0xa9, 0xb1, 0xbc);
inline const QColor accent(0x4f, 0xb3, 0xff);
inline const QColor good(0x4c, 0xd9, 0x7b);
inline const QColor caution(0xff, 0xb9, 0x3d);
inline const QColor bad(0xff, 0x6b, 0x61);
inline const QColor epipolar(0x3d, 0xd6, 0xe6);
}  // namespace theme

QColor colour_of(TrackState state);

void apply_theme(QApplication& application);

}  // namespace kambara::ui
