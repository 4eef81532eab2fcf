// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "app/cli/calibration_pictures.h"
#include "core/calibration/calibration_report.h"

namespace kambara::cli {

/// The report of a calibration with the keys of the command line's contract, as far as it is
/// filled, and for its HTML page, which shows these numbers.
nlohmann::json calibration_json(const CalibrationReport& report, const CalibrationFiles& files);

}  // namespace kambara::cli
