// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/stereo/range_experiment.h"

namespace kambara::cli {

/// What it comes to, as a sentence.
std::string range_verdict_sentence(const RangeExperiment& experiment);

/// One row a station: known and measured place, and the errors before and after the correction.
std::string range_test_table(const RangeExperiment& experiment);

/// The same as a page: tables, the estimates as 1999's figure 46, and the error against depth,
/// height and side.
std::string range_test_page(const RangeExperiment& experiment, double baseline_mm);

}  // namespace kambara::cli
