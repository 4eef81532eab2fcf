// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/quantities.h"

#include <QLocale>
#include <cmath>

#include "core/base/angles.h"

namespace kambara::ui {
namespace {

QString with_unit(double value, int decimals, const QString& unit) {
    if (!std::isfinite(value)) {
        return QStringLiteral("\u2013");
    }
    // What rounds to nothing has no sign.
    const bool nothing = std::abs(value) * std::pow(10.0, decimals) < 0.5;
    return QLocale().toString(nothing ? 0.0 : value, 'f', decimals) + QChar(0x202F) + unit;
}

}  // namespace

QString millimetres(double value_mm, int decimals) {
    return with_unit(value_mm, decimals, QStringLiteral("mm"));
}

QString degrees(double angle_rad, int decimals) {
    return with_unit(deg_from_rad(angle_rad), decimals, QStringLiteral("\u00B0"));
}

QString seconds(double value_s, int decimals) {
    return with_unit(value_s, decimals, QStringLiteral("s"));
}

QString milliseconds(double value_ms, int decimals) {
    return with_unit(value_ms, decimals, QStringLiteral("ms"));
}

QString hertz(double value_hz, int decimals) {
    return with_unit(value_hz, decimals, QStringLiteral("Hz"));
}

QString percent(double share, int decimals) {
    return with_unit(100.0 * share, decimals, QStringLiteral("%"));
}

QString pixels(double value_px, int decimals) {
    return with_unit(value_px, decimals, QStringLiteral("px"));
}

}  // namespace kambara::ui
