// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/calibration/rig_calibrator.h"
#include "core/calibration/rig_views.h"
#include "core/calibration/target.h"

namespace kambara {

/// What a calibration session is for: fixed once it has begun, and kept with it.
struct SessionSetup {
    Target target;
    std::array<std::optional<PictureSize>, most_cameras> cameras;  ///< the left one always
    LensModel model = LensModel::brown;
    Sensor sensor;  ///< Tsai's
    Medium medium = Medium::air;
    std::optional<KnownBaseline> baseline;
    std::optional<Rig> expected;  ///< data sheet, or an earlier calibration
};

/// A view that was captured, with its number, counted from 1 and never given twice.
struct Shot {
    int number = 0;
    RigView seen;
    bool kept = true;
};

/// That a shot was dropped or taken back, by hand.
struct Decision {
    int shot = 0;
    bool kept = false;
    bool operator==(const Decision&) const = default;
};

}  // namespace kambara
