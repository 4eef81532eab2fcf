// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera/rig.h"
#include "core/stereo/position.h"
#include "core/tracking/patch_search.h"

namespace kambara {

/// Both matches of a pair with the covariance of all four coordinates. A right match that was found
/// by a patch cut at the left one carries the left one's error on, and the noise of the left
/// picture is in both, with the opposite sign: with the errors e_l = H^-1 g (n_l - n_t) of the left
/// match (noise of the left picture and of the template) and d = H^-1 g (n_r - n_l) of the right
/// one against it, the right pixel errs by M e_l + d, M being how the right pixel goes with the
/// left one at a constant distance. What the left picture's noise shifted so goes out again, and
/// the disparity is known better than by two matches that know nothing of each other.
PairMeasurement pair_of(const Rig& rig, const PatchMatch& left, const PatchMatch& right);

}  // namespace kambara
