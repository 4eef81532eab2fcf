// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/calibration/area_fit.h"
#include "core/calibration/side_fit.h"

namespace kambara {

/// Measures many boxes of one picture: large ones by their sides, small ones by the light of every
/// pixel about them, each with the others' shares taken into account.
class BoxMeasure {
  public:
    BoxMeasure(const Image& grey, const LightOfLevel& light, const SideFitOptions& options)
        : grey_(grey), light_(light), options_(options) {}

    /// Each by itself, from corners known to a pixel: by its sides where they can be measured.
    std::vector<std::optional<FittedBox>> each(const std::vector<Quadrilateral>& starts) const;

    /// All together, from corners known well; empty where a box can't be measured.
    std::vector<std::optional<FittedBox>> together(const std::vector<Quadrilateral>& starts,
                                                   const Straightener& straightener) const;

    void set_blur_px(double blur_px) { options_.blur_px = blur_px; }

  private:
    const Image& grey_;
    const LightOfLevel& light_;
    SideFitOptions options_;
};

/// The distance between a box's two long sides, px.
double breadth_px(const Quadrilateral& box);

}  // namespace kambara
