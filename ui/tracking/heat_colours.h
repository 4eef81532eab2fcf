// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRgb>

namespace kambara::ui {

/// A colour for a share in [0, 1]: from dark blue by purple and orange to light yellow, growing in
/// lightness all the way, so that it reads in grey and by the colour-blind too.
QRgb heat_colour(double share);

}  // namespace kambara::ui
