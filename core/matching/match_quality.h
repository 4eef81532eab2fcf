// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/matching/match_method.h"
#include "core/matching/matcher.h"
#include "core/matching/peak.h"
#include "core/matching/score_map.h"

namespace kambara {

/// What a search says for and against its best place.
struct MatchEvidence {
    double likeness = 0.0;  ///< Matcher::quality() of the best score, in [0, 1]
    /// Likeness of the best place apart from it (see apart_px); empty where the region has none.
    std::optional<double> runner_up;
};

/// The evidence for the peak of a map that the matcher has just made.
MatchEvidence match_evidence(const Matcher& matcher, const ScoreMap& map, const Peak& peak);

/// The probability, in [0, 1], that a match is right, which is to say within 2 px of the truth:
/// comparable between methods, where likeness is not. A logistic model for each measure after each
/// transform, fitted to real recordings (tests/benchmark/quality_calibration.cpp) whose windows
/// hold the true place five times in six, sometimes covered: where matches are right more or less
/// often than there, so are those of the same probability. It does not fall when the likeness rises
/// with the runner-up or with the distinctness (likeness less runner-up) kept, nor when the
/// runner-up falls. Without a runner-up, one of the usual likeness is assumed. Never NaN: evidence
/// out of range is brought into it, and NaN counts as no likeness. A method that was not fitted has
/// the model of all methods together.
double match_probability(const MatchMethod& method, const MatchEvidence& evidence);

/// What the model weighs: 1, likeness, distinctness, and the share of the runner-up's unlikeness
/// that the best place does without.
using QualityFeatures = std::array<double, 4>;

struct QualityModel {
    QualityFeatures weights{};  ///< all but the first 0 or more
    double usual_rival = 0.0;   ///< likeness of the runner-up, on average
};

const QualityModel& quality_model(const MatchMethod& method);
QualityFeatures quality_features(const MatchEvidence& evidence, double usual_rival);
double match_probability(const QualityModel& model, const MatchEvidence& evidence);

}  // namespace kambara
