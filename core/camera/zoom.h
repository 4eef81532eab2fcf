// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/camera/lens.h"

namespace kambara {

/// The lens zoomed in so that it shows things `factor` times as large, above 0. Its distortion
/// stays that of the same place on a Tsai lens' sensor or of the same direction before a Brown
/// lens: what a real zoom does to it, nobody has measured here.
Lens zoomed(const Lens& lens, double factor);

}  // namespace kambara
