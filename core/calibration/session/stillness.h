// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/calibration/rig_views.h"

namespace kambara {

/// How far the corners that both sights have lie apart: root mean square, px. Empty where they
/// share less than half of the larger one's corners, or one has none.
std::optional<double> distance_px(const DetectedCorners& a, const DetectedCorners& b);

struct StillnessOptions {
    double most_motion_px = 0.5;  ///< from the first of the pictures that count as still
    int pairs = 3;                ///< of pictures that follow each other
};

/// Tells from view after view whether the target is held still before all cameras that see it.
/// One thread at a time.
class Stillness {
  public:
    explicit Stillness(const StillnessOptions& options = {}) : options_(options) {}

    /// True once so many views in a row lie close to the first of them.
    bool still_after(const RigView& seen);
    void forget() { pairs_ = -1; }

  private:
    StillnessOptions options_;
    RigView first_;
    int pairs_ = -1;  // -1: no view yet
};

}  // namespace kambara
