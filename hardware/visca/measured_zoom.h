// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "hardware/visca/head_kind.h"

namespace kambara::visca {

/// The lens at its widest, where the table of heads does not know it.
struct WidestLens {
    double f_mm = 0.0;
    double sensor_width_mm = 0.0;
};

/// The kind of head with a measured zoom curve in place of what it had. `curve`: zoom shares (0
/// wide, 1 tele), rising, and how many times as large as at the first of them things are shown.
/// Refuses a kind whose lens is not known where `widest` does not tell it.
Result<HeadKind> with_measured_zoom(HeadKind kind,
                                    const std::vector<std::pair<double, double>>& curve,
                                    const std::optional<WidestLens>& widest = std::nullopt);

}  // namespace kambara::visca
