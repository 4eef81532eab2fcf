// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibration_gates.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

namespace kambara {
namespace {

constexpr double least_picture_share = 0.4;
constexpr double least_depth_ratio = 1.4;
constexpr double most_systematic_share = 0.5;  // of the residuals, and at least ...
constexpr double least_systematic_px = 0.05;
constexpr double least_target_px = 0.1;  // of what residuals at one corner have in common
constexpr double most_target_share = 0.4;
constexpr double most_outliers = 0.02;
constexpr double most_focal_difference = 0.1;  // between left and right
constexpr double usable_range_error = 0.01;    // one deviation over the range
constexpr double refused_range_error = 0.05;
constexpr double usable_scale_error = 0.003;  // held-out lengths
constexpr double refused_scale_error = 0.015;
constexpr double expected_tolerance = 0.05;  // of a focal length, data sheet's
constexpr double most_bend_difference =
    0.05;                                  // at the picture's side, of the distance from the axis
constexpr double refraction = 1.335;       // of water: 1.33 to 1.345
constexpr double most_blur_px = 4.0;       // of an edge; a sharp one has 2
constexpr double off_centre_share = 0.15;  // of the picture's width

std::string number(double value, int decimals) {
    char text[48];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

std::string percent(double share) {
    return number(100.0 * share, std::abs(share) < 0.01 ? 2 : 1) + " %";
}

class Judgement {
  public:
    Judgement(const RigCalibratorOptions& options, CalibrationReport& report)
        : options_(options), report_(report) {}

    void run(const Target& target) {
        for (std::size_t c = 0; c < most_cameras; ++c) {
            if (report_.cameras[c]) {
                lens(c);
                coverage(c);
                sharpness(c);
                expectation(c);
            }
        }
        residuals();
        target_fits();
        depth(target);
        if (report_.cameras[1]) {
            sides();
            agreement();
            baseline();
            range();
            held_out();
        }
        report_.verdict = refused_            ? Verdict::refused
                          : reasons().empty() ? Verdict::good
                                              : Verdict::usable;
    }

  private:
    std::vector<std::string>& reasons() { return report_.reasons; }

    void warn(std::string text) { reasons().push_back(std::move(text)); }

    void refuse(std::string text) {
        refused_ = true;
        reasons().push_back(std::move(text));
    }

    static std::string the(std::size_t camera) {
        return std::string("The ") + camera_names[camera] + " camera";
    }

    void lens(std::size_t c) {
        const Camera& camera = report_.cameras[c]->camera;
        const auto why = implausibility(camera.lens, camera.width_px, camera.height_px);
        if (!why.empty()) {
            refuse(the(c) + " can't be: " + why + ".");
            return;
        }
        const auto p = pinhole_parameters(camera.lens);
        if (std::abs(p.cx_px - 0.5 * camera.width_px) > off_centre_share * camera.width_px ||
            std::abs(p.cy_px - 0.5 * camera.height_px) > off_centre_share * camera.width_px) {
            warn(the(c) + "'s optical axis comes out at (" + number(p.cx_px, 0) + ", " +
                 number(p.cy_px, 0) + ") px, far from the picture's middle.");
        }
        const auto* tsai = std::get_if<TsaiLens>(&camera.lens);
        const double sx = tsai != nullptr ? tsai->sx : p.fx_px / p.fy_px;
        if (std::abs(sx - 1.0) > 0.08) {
            warn(the(c) + "'s pixels come out " + percent(std::abs(sx - 1.0)) +
                 " off square: check the sensor's numbers.");
        }
        for (const NamedValue& parameter : report_.cameras[c]->parameters) {
            if (parameter.name.starts_with("f") &&
                parameter.sigma > 0.01 * std::abs(parameter.value)) {
                warn(the(c) + "'s focal length is open to " +
                     percent(parameter.sigma / parameter.value) +
                     ": show the target at more angles and distances.");
                break;
            }
        }
    }

    void coverage(std::size_t c) {
        const CameraResult& result = *report_.cameras[c];
        if (result.picture_share < least_picture_share) {
            warn(the(c) + " saw the target in " + percent(result.picture_share) +
                 " of its picture only: show it near the sides and corners, too.");
        }
        const double sigma = result.rms_px / std::sqrt(2.0);
        if (result.systematic_px > std::max(least_systematic_px, most_systematic_share * sigma)) {
            warn(the(c) + "'s residuals hang together over the picture (" +
                 number(result.systematic_px, 2) +
                 " px): the lens model does not describe this lens.");
        }
    }

    void sharpness(std::size_t c) {
        if (report_.cameras[c]->blur_px > most_blur_px) {
            warn(the(c) + "'s pictures are blurred: edges are " +
                 number(report_.cameras[c]->blur_px, 1) +
                 " px wide. Focus, and hold the target still.");
        }
    }

    // The focal length, and the distortion, against an earlier or a nominal one; in the other
    // medium by the flat port's first order: f_w = n f_a, kappa less by (1 - 1/n^2) / (2 f_a^2).
    void expectation(std::size_t c) {
        if (!options_.expected) {
            return;
        }
        const Rig& expected = *options_.expected;
        const Camera* before = c == 0   ? &expected.left
                               : c == 1 ? (expected.right ? &*expected.right : nullptr)
                                        : (expected.pan_tilt ? &*expected.pan_tilt : nullptr);
        if (before == nullptr) {
            return;
        }
        const Camera& found = report_.cameras[c]->camera;
        const double here = pinhole_parameters(found.lens).fy_px;
        const double there = pinhole_parameters(before->lens).fy_px * found.height_px /
                             static_cast<double>(before->height_px);
        double expected_ratio = 1.0;
        if (expected.medium != options_.medium) {
            expected_ratio = options_.medium == Medium::water ? refraction : 1.0 / refraction;
        }
        const double ratio = here / there;
        if (std::abs(ratio / expected_ratio - 1.0) > expected_tolerance) {
            const bool other_way = std::abs(ratio / (expected_ratio * refraction) - 1.0) < 0.03 ||
                                   std::abs(ratio * refraction / expected_ratio - 1.0) < 0.03;
            refuse(the(c) + "'s focal length is " + number(ratio, 3) +
                   " times the expected one's, "
                   "where " +
                   number(expected_ratio, 3) + " should be" +
                   (other_way ? ": the pictures look taken in the other medium."
                              : ": another lens, zoom or target size."));
            return;
        }
        distortion(c, *before, found);
    }

    // How far a lens bends what it shows at the side of the picture: the undistorted distance from
    // the optical axis over the distorted one, less one; for Tsai's lens kappa1 r^2.
    static std::optional<double> bend(const Lens& lens, double half_px) {
        const auto p = pinhole_parameters(lens);
        double sum = 0.0;
        for (const double side : {-half_px, half_px}) {
            const auto ray = unproject(lens, {p.cx_px + side, p.cy_px});
            if (!ray) {
                return std::nullopt;
            }
            sum += ray->direction.x() / ray->direction.z() * p.fx_px / side - 1.0;
        }
        return 0.5 * sum;
    }

    void distortion(std::size_t c, const Camera& before, const Camera& found) {
        const double half_px = 0.5 * found.width_px;
        const double half_before_px = 0.5 * before.width_px;
        const auto was = bend(before.lens, half_before_px);
        const auto is = bend(found.lens, half_px);
        if (!was || !is) {
            return;
        }
        double expected = *was;
        if (options_.expected->medium != options_.medium) {
            const bool from_air = options_.expected->medium == Medium::air;
            const double tangent = from_air ? half_before_px / pinhole_parameters(before.lens).fx_px
                                            : half_px / pinhole_parameters(found.lens).fx_px;
            const double step = 0.5 * (1.0 - 1.0 / (refraction * refraction)) * tangent * tangent;
            expected += from_air ? -step : step;
        }
        const double off = *is - expected;
        if (std::abs(off) <= most_bend_difference) {
            return;
        }
        const auto* tsai = std::get_if<TsaiLens>(&found.lens);
        if (tsai != nullptr) {
            const double half_mm = half_px * tsai->sensor.dx_prime_mm() / tsai->sx;
            warn(the(c) + "'s kappa1 is " + number(tsai->kappa1_per_mm2, 5) + " / mm2 where " +
                 number(expected / (half_mm * half_mm), 5) +
                 " is expected: " + percent(std::abs(off)) + " at the side of the picture.");
        } else {
            warn(the(c) + "'s lens bends by " + percent(*is) +
                 " at the side of the picture where " + percent(expected) + " is expected.");
        }
    }

    void residuals() {
        const std::string rms = "The residuals are " + number(report_.rms_px, 2) + " px";
        if (report_.rms_px > options_.refused_rms_px) {
            refuse(rms + ", more than " + number(options_.refused_rms_px, 2) +
                   ": blurred pictures, another target, or wrong numbers of it.");
        } else if (report_.rms_px > options_.usable_rms_px) {
            warn(rms + "; below " + number(options_.usable_rms_px, 2) +
                 " would be good. Blur, motion or an uneven target do this.");
        }
        const auto all = static_cast<double>(report_.residuals.size());
        const double out = 1.0 - report_.corners_used / std::max(1.0, all);
        if (out > most_outliers && report_.views_rejected.empty()) {
            warn(percent(out) + " of the corners fit nowhere and are left out.");
        }
    }

    // Residuals that a corner of the target has in common over the views are no noise of pictures:
    // the corner lies elsewhere. The mean square of a mean of n holds an n-th of the variance
    // about it, which is taken off.
    void target_fits() {
        struct Sum {
            int n = 0;
            Eigen::Vector2d sum = Eigen::Vector2d::Zero();
            double squares = 0.0;
        };
        std::map<int, Sum> corners;
        for (const Residual& r : report_.residuals) {
            if (r.used) {
                Sum& s = corners[r.id];
                ++s.n;
                s.sum += r.residual_px;
                s.squares += r.residual_px.squaredNorm();
            }
        }
        double common = 0.0;
        double weights = 0.0;
        for (const auto& [id, s] : corners) {
            if (s.n > 1) {
                const double of_mean = s.sum.squaredNorm() / s.n;
                const double variance = (s.squares - of_mean) / (s.n - 1);
                common += of_mean - variance;
                weights += s.n;
            }
        }
        const double common_px = std::sqrt(std::max(0.0, common) / std::max(1.0, weights));
        if (common_px > std::max(least_target_px, most_target_share * report_.rms_px)) {
            warn("The residuals hang together over the target (" + number(common_px, 2) +
                 " px): its sizes and gaps are not as described. Measure it again.");
        }
    }

    void depth(const Target&) {
        const double ratio = report_.farthest_mm / std::max(1e-9, report_.nearest_mm);
        if (ratio < least_depth_ratio) {
            warn("The target was seen from " + number(report_.nearest_mm, 0) + " to " +
                 number(report_.farthest_mm, 0) +
                 " mm only: the depth is narrow, and focal length and distance can't be told "
                 "apart well. Show it nearer and farther, by a factor of two.");
        }
    }

    void sides() {
        const RigidTransform& T = report_.pairs[1]->T_other_from_left;
        if (T.centre_mm().x() < 0.0) {
            refuse(
                "The right camera comes out to the left of the left one: the sides are "
                "exchanged, or all pictures mirrored.");
        }
    }

    void agreement() {
        const double left = pinhole_parameters(report_.cameras[0]->camera.lens).fy_px;
        const double right = pinhole_parameters(report_.cameras[1]->camera.lens).fy_px;
        if (std::abs(left / right - 1.0) > most_focal_difference) {
            warn("The left and right focal lengths differ by " +
                 percent(std::abs(left / right - 1.0)) +
                 ": if both lenses are of one kind, one is wrong.");
        }
    }

    void baseline() {
        const auto& check = report_.baseline;
        if (!check) {
            report_.notes.push_back(
                "The scale rests on the target's sizes alone; a baseline measured by tape would "
                "check them.");
            return;
        }
        if (std::abs(check->pull) > most_pull) {
            refuse("The baseline comes out at " + number(check->found_mm, 2) + " mm, " +
                   number(std::abs(check->pull), 1) + " deviations from the measured " +
                   number(check->measured_mm, 2) + " mm: check the target's sizes and the tape.");
        }
    }

    void range() {
        double worst = 0.0;
        double sum = 0.0;
        for (const RangeErrorPoint& point : report_.range_errors) {
            const double share = point.sigma_calibration_mm / point.range_mm;
            worst = std::max(worst, share);
            sum += share;
        }
        if (report_.range_errors.empty()) {
            warn("Left and right see no place in common in the working volume: no range there.");
            return;
        }
        const double mean = sum / static_cast<double>(report_.range_errors.size());
        const std::string text = "The calibration leaves ranges open to " + percent(mean) +
                                 " (one deviation; " + percent(worst) + " at worst)";
        if (mean > refused_range_error) {
            refuse(text + ": too much to measure with.");
        } else if (mean > usable_range_error) {
            warn(text + ": take more views, nearer and farther, to the sides.");
        }
    }

    void held_out() {
        const auto& check = report_.held_out;
        if (!check) {
            return;
        }
        const double off = std::abs(check->scale_error);
        const std::string text = "Views that took no part come out " + percent(off) +
                                 (check->scale_error > 0.0 ? " too large" : " too small");
        if (off > refused_scale_error) {
            refuse(text + ": the calibration does not hold for other views.");
        } else if (off > usable_scale_error) {
            warn(text + ": more views would make it surer.");
        }
    }

    const RigCalibratorOptions& options_;
    CalibrationReport& report_;
    bool refused_ = false;
};

}  // namespace

void judge(const Target& target, const RigCalibratorOptions& options, CalibrationReport& report) {
    Judgement(options, report).run(target);
}

std::string to_string(Verdict verdict) {
    switch (verdict) {
        case Verdict::good:
            return "good";
        case Verdict::usable:
            return "usable";
        case Verdict::refused:
            break;
    }
    return "refused";
}

}  // namespace kambara
