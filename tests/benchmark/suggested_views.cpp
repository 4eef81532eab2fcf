// SPDX-License-Identifier: GPL-3.0-or-later
// suggested_views [ROUNDS]: range errors after 12 views that the session suggests and after 25 at
// random, as root mean squares over so many seeds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "tests/core/calibration/session/guided_study.h"

namespace {

using kambara::testing_support::GuidedStudy;
using kambara::testing_support::RangeErrors;

void print(const char* name, const RangeErrors& errors) {
    std::printf("  %-13s %.4f %% reported, %.4f %% in truth, %d of %d good\n", name,
                100.0 * errors.reported, 100.0 * errors.truly, errors.good, errors.rounds);
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 10;
    const kambara::Target board = kambara::ChessboardTarget{9, 6, 30.0};
    const kambara::Target boxes = kambara::two_plane_24();
    for (const bool pan_tilt : {false, true}) {
        for (const auto model : {kambara::LensModel::tsai, kambara::LensModel::brown}) {
            for (const auto* target : {&boxes, &board}) {
                GuidedStudy study;
                study.target = *target;
                study.model = model;
                study.pan_tilt = pan_tilt;
                const auto result = kambara::testing_support::run(study, rounds);
                std::printf("%s, %s, %d cameras\n", kambara::to_string(*target).c_str(),
                            model == kambara::LensModel::tsai ? "tsai" : "brown", pan_tilt ? 3 : 2);
                print("12 suggested", result.suggested);
                print("25 random", result.random);
                std::fflush(stdout);
            }
        }
    }
    return 0;
}
