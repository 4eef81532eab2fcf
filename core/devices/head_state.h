// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace kambara {

/// What a head's camera looks through.
struct LensStatus {
    double zoom_share = 0.0;           ///< 0 wide, 1 tele
    double horizontal_view_rad = 0.0;  ///< in air; 0 where that is not known
    double widest_view_rad = 0.0;      ///< that of zoom 0; likewise
    double focus_share = 0.0;          ///< 0 far, 1 near
    bool autofocus = true;
    bool operator==(const LensStatus&) const = default;

    /// How many times as large as at its widest it shows things; 1 where that is not known.
    double magnification() const {
        return horizontal_view_rad > 0.0 && widest_view_rad > 0.0
                   ? std::tan(0.5 * widest_view_rad) / std::tan(0.5 * horizontal_view_rad)
                   : 1.0;
    }
};

/// What a head can do beside looking at given angles, so that nobody is offered what it would
/// refuse.
struct HeadAbilities {
    bool drive = false;
    bool reset = false;
    bool zoom = false;
    bool focus = false;
    bool autofocus = false;
    int presets = 0;  ///< numbered from 0; none: 0
    bool operator==(const HeadAbilities&) const = default;
};

}  // namespace kambara
