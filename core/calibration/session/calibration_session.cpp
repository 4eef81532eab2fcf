// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/calibration_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

constexpr double least_noise_px = 0.02;

std::array<bool, most_cameras> taking_part(const SessionSetup& setup) {
    std::array<bool, most_cameras> part{};
    for (std::size_t c = 0; c < most_cameras; ++c) {
        part[c] = setup.cameras[c].has_value();
    }
    return part;
}

// Which camera's picture has another size than the session's.
std::string other_size(const PictureSet& pictures, const SessionSetup& setup) {
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (pictures[c] != nullptr && setup.cameras[c] &&
            PictureSize{pictures[c]->width(), pictures[c]->height()} != *setup.cameras[c]) {
            return std::string("The ") + camera_names[c] +
                   " camera's pictures have another size than the session began with.";
        }
    }
    return {};
}

std::string fault_of(const SessionSetup& setup) {
    if (!setup.cameras[0]) {
        return "The left camera does not take part.";
    }
    for (const auto& size : setup.cameras) {
        if (size && (size->width_px <= 0 || size->height_px <= 0)) {
            return "A camera's pictures have no size.";
        }
    }
    if (const auto why = target_fault(setup.target); !why.empty()) {
        return "The target can't be: " + why + ".";
    }
    if (std::holds_alternative<PointTarget>(setup.target)) {
        return "A list of points can't be found in pictures.";
    }
    return {};
}

// Each shot is kept unless the last decision on it says otherwise.
void apply_decisions(const std::vector<Decision>& decisions, std::vector<Shot>& shots) {
    for (Shot& shot : shots) {
        shot.kept = true;
        for (const Decision& decision : decisions) {
            shot.kept = decision.shot == shot.number ? decision.kept : shot.kept;
        }
    }
}

}  // namespace

CalibrationReport SessionProblem::solve(std::stop_token stop,
                                        const CalibrationProgress& progress) const {
    return calibrate_rig(views, target, options, std::move(stop), progress);
}

CalibrationSession::CalibrationSession(SessionContent content, const CaptureRules& rules,
                                       std::filesystem::path folder, PictureWriter write_picture)
    : content_(std::move(content)),
      rules_(rules),
      folder_(std::move(folder)),
      write_picture_(std::move(write_picture)),
      stillness_(rules.stillness) {
    apply_decisions(content_.decisions, content_.shots);
    guess_anew();
}

Result<CalibrationSession> CalibrationSession::begin(const SessionSetup& setup,
                                                     const CaptureRules& rules,
                                                     const std::filesystem::path& folder,
                                                     PictureWriter write_picture) {
    if (const auto fault = fault_of(setup); !fault.empty()) {
        return Error{fault, "Choose the cameras and the target first."};
    }
    if (!folder.empty()) {
        if (const auto done = begin_session_folder(folder, setup); !done) {
            return done.error();
        }
    }
    SessionContent content;
    content.setup = setup;
    return CalibrationSession(std::move(content), rules, folder, std::move(write_picture));
}

Result<CalibrationSession> CalibrationSession::resume(const std::filesystem::path& folder,
                                                      PictureWriter write_picture,
                                                      const CaptureRules& rules) {
    auto content = read_session_folder(folder);
    if (!content) {
        return content.error();
    }
    if (const auto fault = fault_of(content->setup); !fault.empty()) {
        return Error{folder.string() + ": " + fault, "Begin a new session in another folder."};
    }
    return CalibrationSession(std::move(*content), rules, folder, std::move(write_picture));
}

Result<Look> CalibrationSession::look(const PictureSet& pictures) {
    return look(find_in_all(pictures, content_.setup.target), pictures);
}

Result<Look> CalibrationSession::look(RigView seen, const PictureSet& pictures) {
    return consider(std::move(seen), pictures, false);
}

Result<Look> CalibrationSession::capture(RigView seen, const PictureSet& pictures) {
    return consider(std::move(seen), pictures, true);
}

std::string CalibrationSession::why_not(const RigView& seen, bool by_hand) {
    if (auto why = not_found(seen, taking_part(content_.setup)); !why.empty()) {
        stillness_.forget();
        return why;
    }
    if (!stillness_.still_after(seen) && !by_hand) {
        return "The target is not held still yet.";
    }
    if (auto why = not_sharp(seen, rules_.sharpness); !why.empty()) {
        return why;
    }
    for (const Shot& shot : content_.shots) {
        // One just dropped is not captured again by itself while the target stays where it is.
        const bool last = &shot == &content_.shots.back() && !by_hand;
        if ((shot.kept || last) && repeats(seen, shot.seen, rules_.least_change_px)) {
            return "The target is where shot " + std::to_string(shot.number) +
                   " shows it already: move it.";
        }
    }
    return {};
}

Result<Look> CalibrationSession::consider(RigView seen, const PictureSet& pictures, bool by_hand) {
    Look look;
    look.why_not = other_size(pictures, content_.setup);
    if (look.why_not.empty()) {
        look.why_not = why_not(seen, by_hand);
    }
    look.seen = std::move(seen);
    if (!look.why_not.empty()) {
        return look;
    }
    Shot shot;
    shot.number = content_.shots.empty() ? 1 : content_.shots.back().number + 1;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (content_.setup.cameras[c]) {
            shot.seen.sights[c] = look.seen.sights[c];
        }
    }
    if (!folder_.empty()) {
        if (const auto done = write_shot(folder_, shot, pictures, write_picture_); !done) {
            return done.error();
        }
    }
    look.shot = shot.number;
    content_.shots.push_back(std::move(shot));
    return look;
}

std::vector<RigView> CalibrationSession::kept_views() const {
    std::vector<RigView> views;
    for (const Shot& shot : content_.shots) {
        if (shot.kept) {
            views.push_back(shot.seen);
        }
    }
    return views;
}

Result<Done> CalibrationSession::decide(int number, bool kept) {
    const auto shot = std::find_if(content_.shots.begin(), content_.shots.end(),
                                   [number](const Shot& s) { return s.number == number; });
    if (shot == content_.shots.end()) {
        return Error{"There is no shot " + std::to_string(number) + ".", "Choose one of the list."};
    }
    if (shot->kept == kept) {
        return Done{};
    }
    auto decisions = content_.decisions;
    decisions.push_back({number, kept});
    return take_decisions(std::move(decisions));
}

Result<Done> CalibrationSession::undo() {
    if (content_.decisions.empty()) {
        return Error{"There is nothing to undo.", ""};
    }
    auto decisions = content_.decisions;
    decisions.pop_back();
    return take_decisions(std::move(decisions));
}

Result<Done> CalibrationSession::take_decisions(std::vector<Decision> decisions) {
    decisions.swap(content_.decisions);
    if (!folder_.empty()) {
        if (auto done = write_session_state(folder_, content_); !done) {
            decisions.swap(content_.decisions);
            return done;
        }
    }
    apply_decisions(content_.decisions, content_.shots);
    return Done{};
}

RigCalibratorOptions CalibrationSession::calibrator_options() const {
    const SessionSetup& setup = content_.setup;
    RigCalibratorOptions options;
    options.cameras = setup.cameras;
    options.model = setup.model;
    options.sensor = setup.sensor;
    options.medium = setup.medium;
    options.baseline = setup.baseline;
    options.expected = setup.expected;
    return options;
}

NextViewOptions CalibrationSession::next_view_options() const {
    NextViewOptions options;
    options.noise_px = content_.noise_px;
    options.least_change_px = 3.0 * rules_.least_change_px;
    return options;
}

void CalibrationSession::guess_anew() {
    const SessionSetup& setup = content_.setup;
    const bool expected = setup.expected && setup.expected->medium == setup.medium;
    guess_ = guess_from(content_.solved ? *content_.solved
                        : expected      ? *setup.expected
                                        : nominal_rig(setup.medium),
                        calibrator_options());
}

Coverage CalibrationSession::coverage() const {
    return coverage_of(guess_, content_.setup.target, kept_views());
}

std::optional<NextView> CalibrationSession::what_next() const {
    return next_view(guess_, content_.setup.target, kept_views(), next_view_options());
}

double CalibrationSession::predicted_range_error() const {
    return kambara::predicted_range_error(guess_, content_.setup.target, kept_views(),
                                          next_view_options());
}

SessionProblem CalibrationSession::problem() const {
    SessionProblem problem{content_.setup.target, calibrator_options(), {}, kept_views()};
    for (const Shot& shot : content_.shots) {
        if (shot.kept) {
            problem.numbers.push_back(shot.number);
        }
    }
    return problem;
}

Result<Done> CalibrationSession::learn(const CalibrationReport& report) {
    if (report.verdict == Verdict::refused) {
        return Done{};
    }
    content_.solved = report.rig;
    content_.noise_px = std::max(least_noise_px, report.rms_px / std::sqrt(2.0));
    guess_anew();
    if (folder_.empty()) {
        return Done{};
    }
    if (auto done = write_session_rig(folder_, report.rig); !done) {
        return done;
    }
    return write_session_state(folder_, content_);
}

}  // namespace kambara
