// SPDX-License-Identifier: GPL-3.0-or-later
// How long the target is kept in murky water (tests/support/murky_water.h), by the attenuation
// lengths between it and the camera, one way: with the default method (zncc, which smooths where
// noise is much), smoothing always, and others beside it.
// Usage: water_benchmark [SEEDS [SECONDS]]; 5 seeds of 16 s take some minutes.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "core/tracking/tracker_options.h"
#include "tests/support/murky_water.h"

namespace kambara {
namespace {

void print(const std::string& name, const KeptFrames& counts) {
    std::printf("  %-20s", name.c_str());
    for (std::size_t i = 0; i < KeptFrames::bins; ++i) {
        if (counts.frames[i] > 0) {
            std::printf(" %6.1f", 100.0 * counts.kept[i] / counts.frames[i]);
        } else {
            std::printf("      -");
        }
    }
    std::printf("  | %6.2f   %5.2f   %d\n", 100.0 * counts.kept_to_3_lengths(),
                100.0 * counts.wrong_to_3_lengths(), counts.refused);
}

void run(int seeds, double seconds) {
    const std::vector<std::pair<std::string, MatchMethod>> methods = {
        {"the default", TrackerOptions{}.search.method},
        {"zncc after gauss", {Measure::zncc, Transform::gaussian}},
        {"census", {Measure::hamming, Transform::census}},
        {"ncc", {Measure::ncc, Transform::none}},
        {"sad", {Measure::sad, Transform::none}}};
    for (const char* water : murky_waters) {
        std::vector<KeptFrames> counts(methods.size());
        for (int seed = 1; seed <= seeds; ++seed) {
            const MurkyScene scene = murky_scene(water, seed, seconds);
            for (std::size_t i = 0; i < methods.size(); ++i) {
                follow(scene, methods[i].second, counts[i]);
            }
        }
        std::printf("%s: frames kept, %%, by attenuation lengths\n", water);
        std::printf("  %-20s    0-.5   .5-1  1-1.5  1.5-2  2-2.5  2.5-3  3-3.5   3.5-", "method");
        std::printf(" | 0 to 3   wrong   templates refused\n");
        for (std::size_t i = 0; i < methods.size(); ++i) {
            print(methods[i].first, counts[i]);
        }
    }
}

}  // namespace
}  // namespace kambara

int main(int argc, char** argv) {
    kambara::run(argc > 1 ? std::atoi(argv[1]) : 5, argc > 2 ? std::atof(argv[2]) : 16.0);
}
