// SPDX-License-Identifier: GPL-3.0-or-later
// What suggestions are worth: few views held about where the session asks for them, against many
// at random, before a rig that is not the one the session begins with.
#pragma once

#include <cmath>

#include "tests/core/calibration/session/session_samples.h"

namespace kambara::testing_support {

struct GuidedStudy {
    Target target;
    LensModel model = LensModel::tsai;
    bool pan_tilt = false;
    double noise_px = 0.15;
    int suggested_views = 12;
    int random_views = 25;
};

/// Follows the suggestions, calibrating anew after every second view from the fourth on.
inline CalibrationReport guided(const GuidedStudy& study, unsigned seed) {
    const Rig rig = built_rig(study.pan_tilt);
    const SessionSetup setup = setup_for(rig, study.target, study.model);
    std::mt19937 random(seed);
    auto session = CalibrationSession::begin(setup);
    for (int tries = 0; tries < 300;) {
        const int shots = static_cast<int>(session->shots().size());
        if (shots == study.suggested_views) {
            break;
        }
        if (shots >= 4 && shots % 2 == 0) {
            SessionProblem problem = session->problem();
            problem.options.held_out = false;
            (void)session->learn(problem.solve());
        }
        const auto next = session->what_next();
        if (!next) {
            break;
        }
        bool taken = false;
        while (!taken && ++tries < 300) {
            auto view =
                shown(rig, setup.target, held_about(next->T_left_from_target, setup.target, random),
                      study.noise_px, random);
            taken = view && session->capture(std::move(*view))->shot;
        }
    }
    return session->problem().solve();
}

/// Anywhere in the volume in which hands show a target, whole in every picture.
inline CalibrationReport at_random(const GuidedStudy& study, unsigned seed) {
    const Rig rig = built_rig(study.pan_tilt);
    const SessionSetup setup = setup_for(rig, study.target, study.model);
    std::mt19937 random(seed);
    const bool book = std::holds_alternative<BoxTarget>(study.target);
    Showing how;
    how.turn_deg = book ? 12.0 : 35.0;
    how.nearest_mm = book ? 700.0 : 500.0;
    const RigGuess truth = guess_from(rig, options_of(setup));
    std::vector<RigView> all;
    while (static_cast<int>(all.size()) < study.random_views) {
        const RigidTransform T =
            rig.left.T_camera_from_rig * random_pose(setup.target, how, random);
        auto view = can_be_found(truth, setup.target, T)
                        ? shown(rig, setup.target, T, study.noise_px, random)
                        : std::nullopt;
        if (view) {
            all.push_back(std::move(*view));
        }
    }
    return calibrate_rig(all, setup.target, options_of(setup));
}

/// Root mean squares over several seeds, as shares of the range: what the reports say, one
/// deviation, and what ranges are off in truth.
struct RangeErrors {
    double reported = 0.0;
    double truly = 0.0;
    int good = 0;  ///< of the verdicts
    int rounds = 0;

    void add(const CalibrationReport& report, const Rig& built) {
        const double said = reported_range_error(report);
        const double off = true_range_error(built, report.rig);
        reported = std::sqrt((reported * reported * rounds + said * said) / (rounds + 1));
        truly = std::sqrt((truly * truly * rounds + off * off) / (rounds + 1));
        good += report.verdict == Verdict::good ? 1 : 0;
        ++rounds;
    }
};

struct GuidedResult {
    RangeErrors suggested;
    RangeErrors random;
};

inline GuidedResult run(const GuidedStudy& study, int rounds) {
    const Rig rig = built_rig(study.pan_tilt);
    GuidedResult result;
    for (int i = 1; i <= rounds; ++i) {
        result.suggested.add(guided(study, static_cast<unsigned>(i)), rig);
        result.random.add(at_random(study, static_cast<unsigned>(i)), rig);
    }
    return result;
}

}  // namespace kambara::testing_support
