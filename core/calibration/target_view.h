// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/calibration/projective_fit.h"
#include "core/calibration/straightener.h"

namespace kambara {

/// How points of a target come to lie in one picture of which no camera is known: any projection,
/// and one radial term about the picture's middle.
struct TargetView {
    Projection projection = Projection::Zero();
    RadialTerms radial;

    std::optional<Eigen::Vector2d> pixel(const Eigen::Vector3d& point) const {
        return Straightener(radial).pixel(apply(projection, point));
    }
};

/// Pairs of a target's points and their pixels.
struct SeenPoints {
    std::vector<Eigen::Vector3d> points;
    std::vector<Eigen::Vector2d> pixels;
};

/// The view of so many points, with this radial term; flat where all have z = 0.
TargetView fit_view(const SeenPoints& seen, const RadialTerms& radial);

/// As above, with the radial term that explains the pixels best, held near 0 within 0.3 where they
/// don't tell.
TargetView fit_view_and_radial(const SeenPoints& seen, const RadialTerms& start);

/// Root mean square distance of the pixels from where the view has them, in straightened pixels.
double rms_px(const TargetView& view, const SeenPoints& seen);

}  // namespace kambara
