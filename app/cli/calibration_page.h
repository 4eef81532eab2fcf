// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/calibration/calibration_report.h"
#include "core/calibration/session/coverage.h"
#include "core/calibration/session/session_setup.h"

namespace kambara::cli {

/// What a guided session adds to the page: its shots, and what they cover.
struct SessionPart {
    std::vector<Shot> shots;
    std::vector<int> numbers;  ///< of the shots that the report counts as views 0, 1, ...
    Coverage coverage;
    SessionSetup setup;
};

/// The HTML page of a calibration: verdict, cameras, residuals over each picture, coverage, what
/// the checks say, range errors. Its numbers are those of the JSON; the report adds the residuals.
std::string calibration_page(const nlohmann::json& json, const CalibrationReport& report,
                             const std::string& settings, const SessionPart* session = nullptr);

}  // namespace kambara::cli
