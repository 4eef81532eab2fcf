// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

namespace kambara {

/// The pictures captured for a calibration, and the calibration from them. Any thread; detection
/// and adjustment run on the caller's, without the lock.
class CalibrationViews {
  public:
    /// Keeps the pictures as one more view; refuses beyond a hundred.
    Result<Reply> capture(const ImageSet& images);

    /// Calibrates from all views kept; on an accepted result they are let go. The rig counts only
    /// where the outcome holds a rig file's text. What this calibration says nothing of, the medium
    /// and the pan-tilt camera's place beside the left one, is taken over from `before`.
    Result<std::pair<Rig, CalibrationOutcome>> calibrate(const Calibrate& command,
                                                         const Rig& before);

  private:
    std::mutex mutex_;
    std::vector<StereoFrame> views_;
};

}  // namespace kambara
