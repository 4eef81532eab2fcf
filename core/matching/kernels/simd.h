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

/// The same of the transforms' rows, for the target of this number in Highway's tables.
void use_simd_transforms(std::size_t target, TransformRows& rows);
void use_simd_signs(std::size_t target, TransformRows& rows);

}  // namespace kambara
