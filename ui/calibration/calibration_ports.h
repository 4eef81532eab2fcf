// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/calibration_report.h"
#include "core/calibration/session/coverage.h"
#include "core/calibration/session/session_file.h"
#include "core/calibration/session/session_setup.h"
#include "core/geometry/rigid_transform.h"

namespace kambara::ui {

/// What a session came to, for its report.
struct SessionOutcome {
    SessionSetup setup;
    std::vector<Shot> shots;
    std::vector<int> numbers;  ///< of the shots that the report counts as views 0, 1, ...
    Coverage coverage;
    CalibrationReport report;
    std::string settings;
};

/// What the window needs of the program around it. Called on the session's thread.
struct CalibrationPorts {
    PictureWriter write_picture;
    /// A picture file's name and its content's hash, as a rig file keeps them.
    std::function<Result<std::string>(const std::filesystem::path&)> picture_mark;
    std::function<std::string(const SessionOutcome&)> report_page;  ///< HTML, in one file
};

/// The hand that holds a simulated target; empty where a real one is held by somebody. The members
/// may be called from any thread.
struct TargetHand {
    std::string target;  ///< what it holds, in the short form
    /// A helper is a little off.
    std::function<void(const RigidTransform& T_left_from_target, bool by_helper)> hold;
    std::function<void()> let_go;

    explicit operator bool() const { return static_cast<bool>(hold); }
};

}  // namespace kambara::ui
