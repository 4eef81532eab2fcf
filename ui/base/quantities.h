// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace kambara::ui {

/// Numbers with their units, as people read them: the locale's separators, a narrow no-break space
/// before the unit. Not finite: a dash.
QString millimetres(double value_mm, int decimals = 1);
QString degrees(double angle_rad, int decimals = 1);
QString seconds(double value_s, int decimals = 2);
QString milliseconds(double value_ms, int decimals = 1);
QString hertz(double value_hz, int decimals = 1);
QString percent(double share, int decimals = 0);  ///< of a share of 1
QString pixels(double value_px, int decimals = 2);

}  // namespace kambara::ui
