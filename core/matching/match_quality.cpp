// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/match_quality.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kambara {
namespace {

// Differences in likeness below this are noise, even between places of the greatest likeness.
constexpr double least_unlikeness = 0.0005;

struct FittedModel {
    Measure measure;
    Transform transform;
    QualityModel model;
};

// As tests/benchmark/quality_calibration prints them.
constexpr FittedModel fitted[] = {
    {Measure::zncc, Transform::none, {{-3.70, 2.07, 2.21, 5.22}, 0.667}},
    {Measure::ncc, Transform::none, {{-12.70, 11.49, 0.00, 5.61}, 0.953}},
    {Measure::sad, Transform::none, {{-1.63, 0.38, 3.19, 5.48}, 0.321}},
    {Measure::zncc, Transform::gaussian, {{-6.54, 5.01, 2.23, 4.81}, 0.718}},
    {Measure::ncc, Transform::gaussian, {{-20.42, 19.51, 0.00, 4.71}, 0.964}},
    {Measure::sad, Transform::gaussian, {{-2.29, 1.06, 2.55, 5.13}, 0.353}},
    {Measure::zncc, Transform::gradient, {{-1.49, 0.00, 5.01, 4.43}, 0.532}},
    {Measure::ncc, Transform::gradient, {{-2.04, 0.63, 0.00, 6.32}, 0.808}},
    {Measure::sad, Transform::gradient, {{-0.75, 0.00, 7.26, 3.49}, 0.247}},
    {Measure::zncc, Transform::rank3, {{-1.84, 0.00, 7.14, 11.65}, 0.257}},
    {Measure::ncc, Transform::rank3, {{-5.37, 4.02, 0.00, 17.55}, 0.817}},
    {Measure::sad, Transform::rank3, {{-0.34, 0.00, 14.51, 3.17}, 0.027}},
    {Measure::zncc, Transform::rank5, {{-1.78, 0.00, 1.78, 13.26}, 0.306}},
    {Measure::ncc, Transform::rank5, {{-4.40, 3.01, 0.00, 14.71}, 0.837}},
    {Measure::sad, Transform::rank5, {{-0.40, 0.00, 12.04, 4.89}, 0.026}},
    {Measure::zncc, Transform::sdog, {{-1.54, 0.00, 12.22, 5.00}, 0.359}},
    {Measure::ncc, Transform::sdog, {{-1.55, 0.00, 17.51, 7.16}, 0.679}},
    {Measure::sad, Transform::sdog, {{-1.54, 0.00, 11.91, 4.97}, 0.353}},
    {Measure::hamming, Transform::sdog, {{-1.54, 0.00, 11.89, 5.16}, 0.365}},
    {Measure::hamming, Transform::census, {{-1.85, 0.79, 5.02, 12.18}, 0.308}},
};
constexpr QualityModel of_all_methods{{-1.01, 0.00, 7.35, 4.70}, 0.495};

double in_range(double likeness) {
    return likeness > 0.0 ? std::min(likeness, 1.0) : 0.0;  // so that NaN gives 0
}

}  // namespace

MatchEvidence match_evidence(const Matcher& matcher, const ScoreMap& map, const Peak& peak) {
    MatchEvidence evidence;
    evidence.likeness = matcher.quality(peak.score);
    const int apart = apart_px(matcher.width(), matcher.height());
    if (const auto next = runner_up(map, matcher.method().measure, peak, apart)) {
        evidence.runner_up = matcher.quality(*next);
    }
    return evidence;
}

const QualityModel& quality_model(const MatchMethod& method) {
    for (const FittedModel& row : fitted) {
        if (row.measure == method.measure && row.transform == method.transform) {
            return row.model;
        }
    }
    return of_all_methods;
}

QualityFeatures quality_features(const MatchEvidence& evidence, double usual_rival) {
    const double likeness = in_range(evidence.likeness);
    const double rival = std::min(in_range(evidence.runner_up.value_or(usual_rival)), likeness);
    const double distinctness = likeness - rival;
    return {1.0, likeness, distinctness, distinctness / (1.0 - rival + least_unlikeness)};
}

double match_probability(const QualityModel& model, const MatchEvidence& evidence) {
    const QualityFeatures features = quality_features(evidence, model.usual_rival);
    double log_odds = 0.0;
    for (std::size_t i = 0; i < features.size(); ++i) {
        log_odds += model.weights[i] * features[i];
    }
    return 1.0 / (1.0 + std::exp(-log_odds));
}

double match_probability(const MatchMethod& method, const MatchEvidence& evidence) {
    return match_probability(quality_model(method), evidence);
}

}  // namespace kambara
