// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "core/calibration/calibration_report.h"

namespace kambara::cli {

/// The HTML page of a calibration: verdict, cameras, residuals over each picture, coverage, what
/// the checks say, range errors. Its numbers are those of the JSON; the report adds the residuals.
std::string calibration_page(const nlohmann::json& json, const CalibrationReport& report,
                             const std::string& settings);

}  // namespace kambara::cli
