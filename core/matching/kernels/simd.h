// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/matching/kernels/kernels.h"

namespace kambara {

/// Each puts in its kernels for the vector unit that Highway's chosen target names.
void use_simd_dot(Kernels& kernels);
void use_simd_sad(Kernels& kernels);
void use_simd_hamming(Kernels& kernels);
void use_simd_finish(Kernels& kernels);
void use_simd_spectrum(Kernels& kernels);

}  // namespace kambara
