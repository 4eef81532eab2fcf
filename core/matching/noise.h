// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/match_method.h"

namespace kambara {

/// Standard deviation of a grey picture's noise within a rectangle, grey levels, from the mean size
/// of what a difference of two Laplacians leaves: white noise whole, smooth texture hardly at all
/// (Immerkaer, Fast noise variance estimation, 1996). Fine texture raises it. The rectangle lies
/// inside the picture; 0 where it is smaller than 3 x 3.
double noise_grey(const Image& grey, const Rectangle& rectangle);

/// By how much noise lowers the likeness of two pieces of pictures that would be alike without it:
/// a zero-mean correlation falls by the root of the share of the variance that is no noise, in each
/// of the two (Spearman's attenuation), where noise is taken to be 4 grey levels at most. From 1
/// down to 0, which is noise alone; 1 for measures and transforms where no such law holds. `templ`
/// and `grey` hold the pieces `inner` and `place`, of one size, and the transform's margin about
/// them where they can.
double likeness_kept(const MatchMethod& method, const Image& templ, const Rectangle& inner,
                     const Image& grey, const Rectangle& place);

}  // namespace kambara
