// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/session/coverage.h"
#include "core/calibration/session/next_view.h"
#include "core/calibration/session/session_file.h"
#include "core/calibration/session/session_setup.h"
#include "core/calibration/session/shot_checks.h"
#include "core/calibration/session/stillness.h"

namespace kambara {

/// What a view must be to be captured.
struct CaptureRules {
    StillnessOptions stillness;
    SharpnessOptions sharpness;
    double least_change_px = 15.0;  ///< from a view kept, in at least one camera
};

/// What came of looking at one set of pictures.
struct Look {
    RigView seen;             ///< the corners found, or why not, a camera each
    std::optional<int> shot;  ///< the number it was captured under
    std::string why_not;      ///< else the reason, a sentence
};

/// All that a calibration needs, so that it can run on a thread of its own while the session goes
/// on. Views in the report are counted from 0, as `numbers` lists the shots.
struct SessionProblem {
    Target target;
    RigCalibratorOptions options;
    std::vector<int> numbers;
    std::vector<RigView> views;

    CalibrationReport solve(std::stop_token stop = {},
                            const CalibrationProgress& progress = {}) const;
};

/// A guided calibration: looks at synchronised pictures of one to three cameras, captures views
/// that are new, still and sharp in all of them, says what is covered and what to show next, and
/// calibrates. With a folder everything captured and decided is on disk before it counts, and can
/// be resumed. One thread at a time; nothing here waits for anything but the disk.
///
///     not found / moving / not sharp / a repeat -> nothing, with the reason
///     found, still, sharp, new                  -> a shot, kept
///     a shot: kept <-> dropped, by hand; undo takes the last such decision back
class CalibrationSession {
  public:
    /// A session in memory, or with a folder: a new one, or one without a session in it.
    static Result<CalibrationSession> begin(const SessionSetup& setup,
                                            const CaptureRules& rules = {},
                                            const std::filesystem::path& folder = {},
                                            PictureWriter write_picture = {});
    static Result<CalibrationSession> resume(const std::filesystem::path& folder,
                                             PictureWriter write_picture,
                                             const CaptureRules& rules = {});

    /// Finds the target and captures the view once it is held still. An error: the disk; then
    /// nothing was captured.
    Result<Look> look(const PictureSet& pictures);
    /// As above for corners that were found elsewhere, in these pictures if there are any.
    Result<Look> look(RigView seen, const PictureSet& pictures = {});
    /// Captures by hand, without waiting for stillness. All else holds.
    Result<Look> capture(RigView seen, const PictureSet& pictures = {});

    const SessionSetup& setup() const { return content_.setup; }
    const std::vector<Shot>& shots() const { return content_.shots; }
    std::vector<RigView> kept_views() const;

    /// Refuses a number that no shot has. Nothing happens to a shot that is so already.
    Result<Done> drop(int shot) { return decide(shot, false); }
    Result<Done> keep(int shot) { return decide(shot, true); }
    bool can_undo() const { return !content_.decisions.empty(); }
    /// Takes the last decision back; refuses where there is none.
    Result<Done> undo();

    Coverage coverage() const;
    /// See next_view.h. Until something is learnt, from the expected or the nominal rig.
    std::optional<NextView> what_next() const;
    /// By prediction, as in NextView.
    double predicted_range_error() const;

    SessionProblem problem() const;
    /// Takes a result, unless refused, as the guess from now on; an error: the disk.
    Result<Done> learn(const CalibrationReport& report);

  private:
    CalibrationSession(SessionContent content, const CaptureRules& rules,
                       std::filesystem::path folder, PictureWriter write_picture);

    Result<Look> consider(RigView seen, const PictureSet& pictures, bool by_hand);
    std::string why_not(const RigView& seen, bool by_hand);
    Result<Done> decide(int shot, bool kept);
    Result<Done> take_decisions(std::vector<Decision> decisions);
    RigCalibratorOptions calibrator_options() const;
    NextViewOptions next_view_options() const;
    void guess_anew();

    SessionContent content_;
    CaptureRules rules_;
    std::filesystem::path folder_;
    PictureWriter write_picture_;
    Stillness stillness_;
    RigGuess guess_;
};

}  // namespace kambara
