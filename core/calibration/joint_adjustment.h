// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stop_token>
#include <vector>

#include "core/calibration/bundle.h"

namespace kambara {

/// What an adjusted bundle's residuals say of single corners, pictures and lens terms.

/// A residual beyond which a corner should count less: three robust deviations, px.
double robust_px(const Bundle& bundle);

/// Leaves out the corners that are six robust deviations off.
void drop_outliers(Bundle& bundle);

/// A picture that fits far worse than the others, or of which most corners are out.
struct Misfit {
    int view = 0;  ///< as the bundle counts, as is `camera`
    int camera = 0;
    double rms_px = 0.0;
    bool contradicts = false;  ///< most of its corners were out
};

/// Leaves out the views of such pictures, and names one picture a view.
std::vector<Misfit> drop_misfits(Bundle& bundle);

/// Brown's lenses: adjusts with the third radial terms free, and keeps them where the residuals
/// fall by more than chance lets them.
void free_k3_where_it_shows(Bundle& bundle, std::stop_token stop);

}  // namespace kambara
