// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace kambara {

/// Smooths a picture of grey levels, row by row, by a Gaussian cut off at three sigma; the border's
/// pixels stand for what lies beyond it.
void blur(std::vector<float>& grey, int width, int height, double sigma_px);

}  // namespace kambara
