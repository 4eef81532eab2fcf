// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmark/quality_study.h"

#include <cmath>
#include <cstddef>

#include "tests/support/logistic_fit.h"

namespace kambara {
namespace {

using namespace testing_support;

using Samples = std::vector<MatchSample>;

void append(Samples& samples, const Samples& more) {
    samples.insert(samples.end(), more.begin(), more.end());
}

double rounded(double value, double steps) {
    return std::round(value * steps) / steps;
}

double mean_rival(const Samples& samples) {
    double sum = 0.0;
    double count = 0.0;
    for (const MatchSample& sample : samples) {
        sum += sample.evidence.runner_up.value_or(0.0);
        count += sample.evidence.runner_up ? 1.0 : 0.0;
    }
    return count > 0.0 ? sum / count : 0.0;
}

Samples halves_of(const std::vector<RecordingSamples>& recordings,
                  Samples RecordingSamples::*half) {
    Samples all;
    for (const RecordingSamples& recording : recordings) {
        append(all, recording.*half);
    }
    return all;
}

double error_on_unseen(const std::vector<RecordingSamples>& recordings, std::size_t unseen) {
    Samples others;
    Samples own;
    for (std::size_t i = 0; i < recordings.size(); ++i) {
        append(i == unseen ? own : others, recordings[i].fit);
        append(i == unseen ? own : others, recordings[i].held_out);
    }
    return reliability_by(fitted_model(others), own).calibration_error;
}

}  // namespace

QualityModel fitted_model(const Samples& samples) {
    QualityModel model;
    model.usual_rival = rounded(mean_rival(samples), 1000.0);
    LogisticSamples rows;
    const auto count = static_cast<Eigen::Index>(samples.size());
    rows.features.resize(count, static_cast<Eigen::Index>(model.weights.size()));
    rows.outcomes.resize(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const MatchSample& sample = samples[static_cast<std::size_t>(i)];
        const QualityFeatures features = quality_features(sample.evidence, model.usual_rival);
        rows.features.row(i) = Eigen::Map<const Eigen::RowVector4d>(features.data());
        rows.outcomes[i] = sample.right ? 1.0 : 0.0;
    }
    const Eigen::VectorXd weights = fit_logistic(rows);
    for (std::size_t i = 0; i < model.weights.size(); ++i) {
        model.weights[i] = rounded(weights[static_cast<Eigen::Index>(i)], 100.0);
    }
    return model;
}

QualityModel pooled_model(const std::vector<MethodStudy>& studies) {
    Samples all;
    for (const MethodStudy& study : studies) {
        append(all, halves_of(study.recordings, &RecordingSamples::fit));
    }
    return fitted_model(all);
}

Reliability reliability_by(const QualityModel& model, const Samples& samples) {
    std::vector<Forecast> forecasts;
    for (const MatchSample& sample : samples) {
        forecasts.push_back({match_probability(model, sample.evidence), sample.right});
    }
    return reliability_of(forecasts);
}

MethodStudy study_of(const MatchMethod& method, const std::vector<SearchSet>& sets) {
    MethodStudy study;
    study.method = method;
    for (const SearchSet& set : sets) {
        study.recordings.push_back(
            {set.name, samples_of(method, set.fit), samples_of(method, set.held_out)});
    }
    study.model = fitted_model(halves_of(study.recordings, &RecordingSamples::fit));
    study.held_out =
        reliability_by(study.model, halves_of(study.recordings, &RecordingSamples::held_out));
    for (std::size_t i = 0; i < study.recordings.size(); ++i) {
        study.unseen_calibration.push_back(error_on_unseen(study.recordings, i));
    }
    return study;
}

}  // namespace kambara
