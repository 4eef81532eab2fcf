// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/kernels/kernels.h"

#include <hwy/targets.h>
#include <cstdlib>

#include "core/matching/kernels/simd.h"

namespace kambara {
namespace {

struct Level {
    const char* name;
    std::int64_t target;
};

// In rising order. The last one of a processor is its best.
constexpr Level levels[] = {
#if HWY_ARCH_X86
    {"sse4", HWY_SSE4},
    {"avx2", HWY_AVX2},
    {"avx512bw", HWY_AVX3},
    {"avx512", HWY_AVX3_DL},
#else
    {"neon", HWY_NEON},
#endif
};

// Highway keeps one choice for the whole program: it is set for each level in turn, before any
// kernel runs, and left at the best.
std::vector<Kernels> gather() {
    std::vector<Kernels> found{plain_kernels()};
    const std::int64_t supported = hwy::SupportedTargets();
    for (const Level& level : levels) {
        if ((supported & level.target) != 0) {
            hwy::GetChosenTarget().Update(level.target);
            Kernels kernels;
            kernels.name = level.name;
            use_simd_dot(kernels);
            use_simd_sad(kernels);
            use_simd_hamming(kernels);
            use_simd_finish(kernels);
            use_simd_spectrum(kernels);
            const std::size_t target = hwy::GetChosenTarget().GetIndex();
            use_simd_transforms(target, kernels.transforms);
            use_simd_signs(target, kernels.transforms);
            found.push_back(kernels);
        }
    }
    hwy::GetChosenTarget().Update(supported);
    return found;
}

const Kernels& choose() {
    const auto& all = runnable_kernels();
    if (const char* asked = std::getenv("KAMBARA_KERNELS")) {
        for (const Kernels& kernels : all) {
            if (kernels.name == asked) {
                return kernels;
            }
        }
    }
    return all.back();
}

}  // namespace

const std::vector<Kernels>& runnable_kernels() {
    static const std::vector<Kernels> all = gather();
    return all;
}

const Kernels& best_kernels() {
    static const Kernels& best = choose();
    return best;
}

const TransformRows& transform_rows() {
    return best_kernels().transforms;
}

}  // namespace kambara
