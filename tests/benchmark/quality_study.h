// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/matching/match_quality.h"
#include "tests/support/real_searches.h"
#include "tests/support/reliability.h"

namespace kambara {

/// What one method found in one recording.
struct RecordingSamples {
    std::string name;
    std::vector<testing_support::MatchSample> fit;
    std::vector<testing_support::MatchSample> held_out;
};

/// One method's model, and how far it can be trusted where it was not fitted.
struct MethodStudy {
    MatchMethod method;
    std::vector<RecordingSamples> recordings;
    QualityModel model;                      ///< fitted to all first halves
    testing_support::Reliability held_out;   ///< of all second halves
    std::vector<double> unseen_calibration;  ///< error on each recording by a model of the others
};

MethodStudy study_of(const MatchMethod& method,
                     const std::vector<testing_support::SearchSet>& sets);

/// The model of most likelihood, as it would be written down.
QualityModel fitted_model(const std::vector<testing_support::MatchSample>& samples);

/// Of all first halves by all methods.
QualityModel pooled_model(const std::vector<MethodStudy>& studies);

testing_support::Reliability reliability_by(
    const QualityModel& model, const std::vector<testing_support::MatchSample>& samples);

}  // namespace kambara
