// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "hardware/simulated/water.h"

namespace kambara {

/// Smooths a picture of levels, row by row, by a Gaussian cut off at three sigma, whose width may
/// differ from row to row; the border's pixels stand for what lies beyond it. Sigmas are positive,
/// one for each row.
void blur(float* levels, int width, const std::vector<double>& sigmas_px);
void blur(Colour* levels, int width, const std::vector<double>& sigmas_px);

}  // namespace kambara
