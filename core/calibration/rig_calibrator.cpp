// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/rig_calibrator.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "core/base/median.h"
#include "core/calibration/calibration_gates.h"
#include "core/calibration/held_out.h"
#include "core/calibration/joint_adjustment.h"
#include "core/calibration/mono_start.h"
#include "core/calibration/view_checks.h"

namespace kambara {
namespace {

constexpr std::size_t least_corners = 6;
constexpr double rejected_above_median = 3.0;  // a view's residual, in units of the median view's
constexpr double never_rejected_px = 0.5;

std::string rounded(double value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

class Calibration {
  public:
    Calibration(const std::vector<RigView>& views, const Target& target,
                const RigCalibratorOptions& options, const CalibrationProgress& progress)
        : options_(options),
          target_(target),
          target_mm_(corners_in_target_mm(target)),
          progress_(progress),
          views_(views) {
        for (std::size_t c = 0; c < most_cameras; ++c) {
            if (options.cameras[c]) {
                places_.push_back(c);
            }
        }
        report_.corners_total = static_cast<int>(places_.size() * views.size() * target_mm_.size());
    }

    CalibrationReport run(std::stop_token stop) {
        stop_ = std::move(stop);
        solve();
        report_.reasons.insert(report_.reasons.begin(), warnings_.begin(), warnings_.end());
        if (stop_.stop_requested()) {
            report_.reasons.clear();
            refuse("It was stopped before its end.");
        }
        std::stable_sort(report_.views_rejected.begin(), report_.views_rejected.end(),
                         [](const auto& a, const auto& b) { return a.view < b.view; });
        return std::move(report_);
    }

  private:
    void solve() {
        leave_out_unseen();
        leave_out_mirrored();
        leave_out_repeated();
        align_boards();
        if (!enough()) {
            return;
        }
        for (std::size_t k = 0; k < places_.size(); ++k) {
            if (!calibrate_alone(k)) {
                return;
            }
            tell(0.1 + 0.4 * static_cast<double>(k + 1) / static_cast<double>(places_.size()));
        }
        if (!enough() || !pose_cameras() || !enough()) {
            return;
        }
        gather();
        if (!adjust_together()) {
            return;
        }
        tell(0.8);
        finish();
        tell(1.0);
    }

    void tell(double share) const {
        if (progress_) {
            progress_(share);
        }
    }

    void refuse(std::string reason) {
        report_.verdict = Verdict::refused;
        report_.reasons.push_back(std::move(reason));
    }

    DetectedCorners& corners(std::size_t view, std::size_t place) {
        return views_[view].sights[place].corners;
    }

    void reject(std::size_t view, std::size_t place, std::string reason) {
        report_.views_rejected.push_back(
            {static_cast<int>(view), camera_names[place], std::move(reason)});
        corners(view, place).clear();
    }

    void reject_view(std::size_t view, std::string reason) {
        report_.views_rejected.push_back({static_cast<int>(view), "", std::move(reason)});
        for (const std::size_t place : places_) {
            corners(view, place).clear();
        }
    }

    void leave_out_unseen() {
        for (std::size_t v = 0; v < views_.size(); ++v) {
            for (const std::size_t place : places_) {
                const CameraSight& sight = views_[v].sights[place];
                if (sight.corners.size() < least_corners) {
                    reject(v, place,
                           sight.fault.empty() ? "too few corners are seen" : sight.fault);
                }
            }
        }
    }

    void leave_out_mirrored() {
        bool any = false;
        for (std::size_t v = 0; v < views_.size(); ++v) {
            for (const std::size_t place : places_) {
                if (mirrored(target_, corners(v, place))) {
                    any = true;
                    reject(v, place, "the target is mirrored in this picture");
                }
            }
        }
        if (any) {
            warn(
                "Pictures show the target mirrored and are left out: turn off the camera's or "
                "the driver's mirroring.");
        }
    }

    // A picture that comes again adds nothing; a camera that stood still while others went on
    // shows another instant than they.
    void leave_out_repeated() {
        int repeated = 0;
        for (std::size_t v = 1; v < views_.size(); ++v) {
            for (std::size_t w = 0; w < v; ++w) {
                const auto same = std::find_if(places_.begin(), places_.end(), [&](std::size_t c) {
                    return same_picture(corners(v, c), corners(w, c));
                });
                if (same != places_.end()) {
                    reject_view(v, std::string("the ") + camera_names[*same] +
                                       " picture is the same as view " + std::to_string(w + 1) +
                                       "'s");
                    ++repeated;
                    break;
                }
            }
        }
        if (repeated > 0) {
            warn(std::to_string(repeated) + (repeated == 1 ? " view repeats" : " views repeat") +
                 " a picture of another view; each counts once. Move the target between pictures.");
        }
    }

    void align_boards() {
        if (const auto* board = std::get_if<ChessboardTarget>(&target_)) {
            for (std::size_t v = 0; v < views_.size(); ++v) {
                for (std::size_t k = 1; k < places_.size(); ++k) {
                    align_half_turn(*board, corners(v, places_[0]), corners(v, places_[k]));
                }
            }
        }
    }

    bool enough() {
        int seen = 0;
        for (std::size_t v = 0; v < views_.size(); ++v) {
            int cameras = 0;
            for (const std::size_t place : places_) {
                cameras += corners(v, place).empty() ? 0 : 1;
            }
            seen += cameras >= (places_.size() > 1 ? 2 : 1) ? 1 : 0;
        }
        if (seen >= options_.least_views) {
            return true;
        }
        refuse("Only " + std::to_string(seen) + " views show the target" +
               (places_.size() > 1 ? " to two cameras" : "") + "; at least " +
               std::to_string(options_.least_views) + " are needed.");
        return false;
    }

    bool calibrate_alone(std::size_t k) {
        const std::size_t place = places_[k];
        const PictureSize size = *options_.cameras[place];
        std::vector<DetectedCorners> seen;
        for (std::size_t v = 0; v < views_.size(); ++v) {
            seen.push_back(corners(v, place));
        }
        mono_.push_back(calibrate_mono(target_mm_, seen,
                                       {options_.model, options_.sensor, size.width_px,
                                        size.height_px, options_.free_k3.value_or(false)},
                                       stop_));
        MonoResult& mono = mono_.back();
        if (!mono.converged) {
            refuse(std::string("The ") + camera_names[place] +
                   " camera's views determine no lens: show the target larger, at several angles "
                   "and distances.");
            return false;
        }
        std::vector<double> rms;
        for (std::size_t v = 0; v < seen.size(); ++v) {
            if (mono.camera_from_target[v]) {
                rms.push_back(mono.view_rms_px[v]);
            }
        }
        if (rms.empty()) {
            refuse(std::string("No view of the ") + camera_names[place] +
                   " camera fits the target: check which target it is, and its numbers.");
            return false;
        }
        const double far_px = std::max(never_rejected_px, rejected_above_median * median(rms));
        for (std::size_t v = 0; v < seen.size(); ++v) {
            if (seen[v].empty()) {
                continue;
            }
            if (!mono.camera_from_target[v]) {
                reject(v, place, "its corners do not fit the target");
                ++contradicting_;
            } else if (mono.view_rms_px[v] > far_px) {
                mono.camera_from_target[v].reset();
                reject(
                    v, place,
                    "fits far worse than the others (" + rounded(mono.view_rms_px[v], 2) + " px)");
                ++contradicting_;
            }
        }
        return true;
    }

    // The pose of every camera from the left one, and what contradicts it.
    bool pose_cameras() {
        for (std::size_t k = 1; k < places_.size(); ++k) {
            std::size_t from = 0;
            PoseAgreement agreement = agreed_pose(target_mm_, mono_[0], mono_[k]);
            if (agreement.views.size() < 2 && k == 2) {
                const PoseAgreement other = agreed_pose(target_mm_, mono_[1], mono_[k]);
                if (other.views.size() > agreement.views.size()) {
                    agreement = other;
                    from = 1;
                }
            }
            const std::string names = std::string(camera_names[places_[from]]) + " and the " +
                                      camera_names[places_[k]] + " camera";
            if (!agreement.found) {
                refuse("No view shows the target to both the " + names + ".");
                return false;
            }
            const std::size_t n = agreement.views.size();
            const std::size_t against = agreement.against.size();
            if (10 * (n - against) < 6 * n || (n > 2 && n - against < 3)) {
                refuse("The pictures of the " + names + " do not belong together: only " +
                       std::to_string(n - against) + " of " + std::to_string(n) +
                       " pairs agree on where the cameras stand. Check that both lists are in the "
                       "same order, taken at the same instants, and neither mirrored.");
                return false;
            }
            for (const int view : agreement.against) {
                const auto v = static_cast<std::size_t>(view);
                reject_view(v, std::string("the ") + camera_names[places_[from]] + " and " +
                                   camera_names[places_[k]] +
                                   " pictures contradict each other: not the same instant, or "
                                   "another target");
                ++contradicting_;
            }
            const RigidTransform before =
                from == 0 ? RigidTransform{} : transform_of(mono_[1].camera.camera_from_first);
            mono_[k].camera.camera_from_first = block_of(transform_of(agreement.b_from_a) * before);
        }
        return true;
    }

    void gather() {
        bundle_.target_mm = target_mm_;
        bundle_.target_sigma_mm = corner_sigmas_mm(target_);
        bundle_.estimate_target = options_.estimate_target;
        for (const MonoResult& mono : mono_) {
            bundle_.cameras.push_back(mono.camera);
        }
        for (std::size_t v = 0; v < views_.size(); ++v) {
            std::optional<PoseBlock> pose;
            for (std::size_t k = 0; k < places_.size() && !pose; ++k) {
                if (!corners(v, places_[k]).empty() && mono_[k].camera_from_target[v]) {
                    pose = block_of(transform_of(mono_[k].camera.camera_from_first).inverse() *
                                    transform_of(*mono_[k].camera_from_target[v]));
                }
            }
            if (!pose) {
                continue;
            }
            for (std::size_t k = 0; k < places_.size(); ++k) {
                if (corners(v, places_[k]).empty()) {
                    continue;
                }
                for (const DetectedCorner& corner : corners(v, places_[k])) {
                    bundle_.corners.push_back({static_cast<int>(numbers_.size()),
                                               static_cast<int>(k), corner.id, corner.px,
                                               std::clamp(corner.sigma_px, 0.02, 2.0), true});
                }
            }
            numbers_.push_back(v);
            bundle_.first_from_target.push_back(*pose);
        }
    }

    bool adjust_together() {
        if (!adjust(bundle_, 3.0, stop_) || !adjust(bundle_, robust_px(bundle_), stop_)) {
            return not_determined();
        }
        drop_outliers(bundle_);
        if (!adjust(bundle_, 0.0, stop_)) {
            return not_determined();
        }
        // A view that still fits far worse than the others is not what the others are.
        if (leave_out_misfits() && !adjust(bundle_, 0.0, stop_)) {
            return not_determined();
        }
        if (options_.model == LensModel::brown && !options_.free_k3) {
            free_k3_where_it_shows(bundle_, stop_);
        }
        std::vector<bool> used(numbers_.size(), false);
        for (const BundleCorner& corner : bundle_.corners) {
            used[static_cast<std::size_t>(corner.view)] =
                used[static_cast<std::size_t>(corner.view)] || corner.used;
        }
        report_.views_used = static_cast<int>(std::count(used.begin(), used.end(), true));
        if (report_.views_used < options_.least_views) {
            refuse("Only " + std::to_string(report_.views_used) +
                   " views fit each other; at least " + std::to_string(options_.least_views) +
                   " are needed.");
            return false;
        }
        covariance_ = covariance_of(bundle_);
        if (!covariance_.determined) {
            return not_determined();
        }
        return !options_.baseline || weigh_baseline();
    }

    bool not_determined() {
        refuse(
            "The views do not determine the cameras: show the target at more angles and "
            "distances.");
        return false;
    }

    bool leave_out_misfits() {
        const auto misfits = drop_misfits(bundle_);
        for (const Misfit& misfit : misfits) {
            report_.views_rejected.push_back(
                {static_cast<int>(numbers_[static_cast<std::size_t>(misfit.view)]),
                 camera_names[places_[static_cast<std::size_t>(misfit.camera)]],
                 misfit.contradicts
                     ? "most of its corners contradict the other cameras'"
                     : "fits far worse than the others (" + rounded(misfit.rms_px, 2) + " px)"});
            ++contradicting_;
        }
        return !misfits.empty();
    }

    // The tape's baseline against the pictures'; where they agree it takes part with its weight.
    bool weigh_baseline() {
        if (places_.size() < 2 || places_[1] != 1) {
            return true;
        }
        const auto [found, sigma] = baseline_of(bundle_, covariance_, 1);
        const KnownBaseline& known = *options_.baseline;
        const double both = std::hypot(sigma, known.sigma_mm);
        report_.baseline = BaselineCheck{known.baseline_mm, known.sigma_mm, found, sigma,
                                         (found - known.baseline_mm) / both};
        // Weighed against residuals whose sigmas are told only up to a common factor.
        bundle_.baseline =
            BaselinePrior{1, known.baseline_mm,
                          known.sigma_mm / std::sqrt(std::max(1e-12, covariance_.variance_factor))};
        if (std::abs(report_.baseline->pull) > most_pull) {
            bundle_.baseline.reset();  // the gates refuse it
            return true;
        }
        if (!adjust(bundle_, 0.0, stop_)) {
            return not_determined();
        }
        covariance_ = covariance_of(bundle_);
        return covariance_.determined || not_determined();
    }

    void finish() {
        fill_report(bundle_, covariance_, places_, numbers_, options_, report_);
        for (const std::size_t place : places_) {
            report_.cameras[place]->blur_px = blur_px(place);
        }
        if (options_.held_out && places_.size() > 1 && places_[1] == 1) {
            report_.held_out = held_out_check(bundle_, stop_);
        }
        if (contradicting_ > 0) {
            warn(std::to_string(contradicting_) +
                 (contradicting_ == 1 ? " view does" : " views do") + " not fit the others and " +
                 (contradicting_ == 1 ? "is" : "are") + " left out; the list of views says why.");
        }
        judge(target_, options_, report_);
        if (report_.verdict == Verdict::good && !warnings_.empty()) {
            report_.verdict = Verdict::usable;
        }
    }

    double blur_px(std::size_t place) const {
        std::vector<double> widths;
        for (const RigView& view : views_) {
            for (const DetectedCorner& corner : view.sights[place].corners) {
                if (corner.blur_px > 0.0) {
                    widths.push_back(corner.blur_px);
                }
            }
        }
        return widths.empty() ? 0.0 : median(std::move(widths));
    }

    void warn(std::string text) { warnings_.push_back(std::move(text)); }

    const RigCalibratorOptions& options_;
    const Target& target_;
    const std::vector<Eigen::Vector3d> target_mm_;
    const CalibrationProgress& progress_;
    std::vector<RigView> views_;
    std::vector<std::size_t> places_;  // of the cameras that take part, among camera_names
    std::vector<MonoResult> mono_;     // a camera each, as in places_
    Bundle bundle_;
    std::vector<std::size_t> numbers_;  // of the bundle's views among all
    BundleCovariance covariance_;
    std::stop_token stop_;
    CalibrationReport report_;
    std::vector<std::string> warnings_;
    int contradicting_ = 0;
};

}  // namespace

CalibrationReport calibrate_rig(const std::vector<RigView>& views, const Target& target,
                                const RigCalibratorOptions& options, std::stop_token stop,
                                const CalibrationProgress& progress) {
    return Calibration(views, target, options, progress).run(std::move(stop));
}

}  // namespace kambara
