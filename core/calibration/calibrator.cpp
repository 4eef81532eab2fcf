// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/calibrator.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <utility>

#include "core/calibration/bundle.h"

namespace kambara {
namespace {

constexpr double rejected_above_median = 3.0;  // a view's residual, in units of the median view's
constexpr double never_rejected_px = 0.5;
constexpr double baseline_sigmas = 4.0;

using Corners = std::vector<Eigen::Vector2d>;

// One camera by itself: lens parameters, the board's poses, each view's residual.
struct Mono {
    Bundle::LensParameters lens{};
    std::vector<Bundle::Pose> camera_from_board;
    std::vector<double> view_rms_px;
};

std::vector<cv::Point2f> opencv_points(const Corners& corners) {
    std::vector<cv::Point2f> points;
    for (const auto& corner : corners) {
        points.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
    }
    return points;
}

Mono calibrate_one(const std::vector<Corners>& views, const std::vector<Eigen::Vector3d>& board,
                   const CalibratorOptions& options) {
    std::vector<cv::Point3f> board_points;
    for (const auto& p : board) {
        board_points.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
    }
    const std::vector<std::vector<cv::Point3f>> objects(views.size(), board_points);
    std::vector<std::vector<cv::Point2f>> seen;
    for (const Corners& view : views) {
        seen.push_back(opencv_points(view));
    }
    cv::Mat K = cv::Mat::eye(3, 3, CV_64F);
    cv::Mat D = cv::Mat::zeros(5, 1, CV_64F);
    std::vector<cv::Mat> rotations;
    std::vector<cv::Mat> translations;
    cv::Mat view_errors;
    cv::calibrateCamera(objects, seen, {options.width_px, options.height_px}, K, D, rotations,
                        translations, cv::noArray(), cv::noArray(), view_errors,
                        options.free_k3 ? 0 : cv::CALIB_FIX_K3);
    Mono mono;
    mono.lens = {K.at<double>(0, 0), K.at<double>(1, 1), K.at<double>(0, 2), K.at<double>(1, 2)};
    for (int i = 0; i < 5; ++i) {
        mono.lens[static_cast<std::size_t>(4 + i)] = D.at<double>(i);
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        const cv::Mat& r = rotations[i];
        const cv::Mat& t = translations[i];
        mono.camera_from_board.push_back({r.at<double>(0), r.at<double>(1), r.at<double>(2),
                                          t.at<double>(0), t.at<double>(1), t.at<double>(2)});
        mono.view_rms_px.push_back(view_errors.at<double>(static_cast<int>(i)));
    }
    return mono;
}

RigidTransform transform_of(const Bundle::Pose& pose) {
    const Eigen::Vector3d axis(pose[0], pose[1], pose[2]);
    const double angle = axis.norm();
    RigidTransform T;
    if (angle > 0.0) {
        T.R = Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix();
    }
    T.t_mm = {pose[3], pose[4], pose[5]};
    return T;
}

Bundle::Pose pose_of(const RigidTransform& T) {
    const Eigen::AngleAxisd turn(T.R);
    const Eigen::Vector3d axis = turn.angle() * turn.axis();
    return {axis.x(), axis.y(), axis.z(), T.t_mm.x(), T.t_mm.y(), T.t_mm.z()};
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// The pose between the cameras, as most views have it: the median of each coordinate, and the
// rotation nearest to the mean one.
RigidTransform typical_right_from_left(const Mono& left, const Mono& right) {
    Eigen::Matrix3d R = Eigen::Matrix3d::Zero();
    std::vector<double> t[3];
    for (std::size_t i = 0; i < left.camera_from_board.size(); ++i) {
        const RigidTransform T = transform_of(right.camera_from_board[i]) *
                                 transform_of(left.camera_from_board[i]).inverse();
        R += T.R;
        for (int k = 0; k < 3; ++k) {
            t[k].push_back(T.t_mm[k]);
        }
    }
    return {nearest_rotation(R), {median(t[0]), median(t[1]), median(t[2])}};
}

Camera camera_of(const Bundle::LensParameters& p, const CalibratorOptions& options) {
    return {BrownLens(p[0], p[1], p[2], p[3], {p[4], p[5], p[6], p[7], p[8]}), options.width_px,
            options.height_px, RigidTransform{}};
}

// The board's order of corners is known up to half a turn, and both cameras must mean the same:
// their rows run the same way, unless one camera is rolled by more than a quarter turn.
void align_order(const Corners& left, Corners& right) {
    if ((left.back() - left.front()).dot(right.back() - right.front()) < 0.0) {
        std::reverse(right.begin(), right.end());
    }
}

struct Selection {
    std::vector<int> views;  // numbers of the views used
    std::vector<Corners> left_px;
    std::vector<Corners> right_px;
};

class Calibration {
  public:
    Calibration(const std::vector<BoardView>& views, const ChessboardTarget& board,
                const CalibratorOptions& options, const CalibrationProgress& progress)
        : options_(options), board_(corners_in_target_mm(Target(board))), progress_(progress) {
        const int cameras = options.stereo ? 2 : 1;
        report_.corners_total =
            cameras * static_cast<int>(views.size()) * static_cast<int>(board_.size());
        for (std::size_t i = 0; i < views.size(); ++i) {
            take(static_cast<int>(i), views[i]);
        }
    }

    CalibrationReport run(std::stop_token stop) {
        if (!enough()) {
            return report_;
        }
        tell(0.1);
        Mono left = calibrate_one(chosen_.left_px, board_, options_);
        Mono right = options_.stereo ? calibrate_one(chosen_.right_px, board_, options_) : Mono{};
        tell(0.4);
        if (leave_out_misfits(left, right)) {
            if (!enough()) {
                return report_;
            }
            left = calibrate_one(chosen_.left_px, board_, options_);
            right = options_.stereo ? calibrate_one(chosen_.right_px, board_, options_) : Mono{};
        }
        tell(0.6);
        Bundle bundle{board_,
                      chosen_.left_px,
                      chosen_.right_px,
                      options_.free_k3,
                      left.lens,
                      right.lens,
                      {},
                      left.camera_from_board};
        if (options_.stereo) {
            bundle.right_from_left = pose_of(typical_right_from_left(left, right));
        }
        const BundleResult adjusted = adjust(bundle, stop);
        tell(0.95);
        if (stop.stop_requested()) {
            refuse("It was stopped before its end.");
            return report_;
        }
        if (!adjusted.converged) {
            refuse("The views do not determine the cameras: show the board at more angles.");
            return report_;
        }
        fill(bundle, adjusted);
        judge();
        tell(1.0);
        return report_;
    }

  private:
    void tell(double share) const {
        if (progress_) {
            progress_(share);
        }
    }

    void take(int number, const BoardView& view) {
        if (view.left_px.size() != board_.size()) {
            report_.views_rejected.push_back({number, "left: " + view.left_fault});
        } else if (options_.stereo && view.right_px.size() != board_.size()) {
            report_.views_rejected.push_back({number, "right: " + view.right_fault});
        } else {
            chosen_.views.push_back(number);
            chosen_.left_px.push_back(view.left_px);
            if (options_.stereo) {
                chosen_.right_px.push_back(view.right_px);
                align_order(view.left_px, chosen_.right_px.back());
            }
        }
    }

    bool enough() {
        if (static_cast<int>(chosen_.views.size()) >= options_.least_views) {
            return true;
        }
        refuse("Only " + std::to_string(chosen_.views.size()) + " views can be used; at least " +
               std::to_string(options_.least_views) + " are needed.");
        return false;
    }

    // Views that fit far worse than the others: a blurred picture, a wrong order of corners.
    bool leave_out_misfits(const Mono& left, const Mono& right) {
        const auto limit = [](const Mono& mono) {
            return mono.view_rms_px.empty()
                       ? 0.0
                       : std::max(never_rejected_px,
                                  rejected_above_median * median(mono.view_rms_px));
        };
        const double left_limit = limit(left);
        const double right_limit = limit(right);
        Selection kept;
        for (std::size_t i = 0; i < chosen_.views.size(); ++i) {
            const bool left_fits = left.view_rms_px[i] <= left_limit;
            const bool right_fits = !options_.stereo || right.view_rms_px[i] <= right_limit;
            if (left_fits && right_fits) {
                kept.views.push_back(chosen_.views[i]);
                kept.left_px.push_back(chosen_.left_px[i]);
                if (options_.stereo) {
                    kept.right_px.push_back(chosen_.right_px[i]);
                }
                continue;
            }
            const double rms = left_fits ? right.view_rms_px[i] : left.view_rms_px[i];
            report_.views_rejected.push_back(
                {chosen_.views[i], std::string(left_fits ? "right" : "left") +
                                       ": fits far worse than the others (" + std::to_string(rms) +
                                       " px)"});
        }
        const bool any = kept.views.size() < chosen_.views.size();
        chosen_ = std::move(kept);
        return any;
    }

    void fill(const Bundle& bundle, const BundleResult& adjusted) {
        const double corners =
            static_cast<double>(chosen_.views.size()) * static_cast<double>(board_.size());
        report_.views_used = static_cast<int>(chosen_.views.size());
        report_.corners_used = static_cast<int>(corners) * (options_.stereo ? 2 : 1);
        report_.left = {camera_of(bundle.left, options_),
                        std::sqrt(adjusted.left_sum_px2 / corners), adjusted.left_sigma};
        report_.rms_px = report_.left.rms_px;
        report_.rig.left = report_.left.camera;
        if (!options_.stereo) {
            return;
        }
        report_.right =
            CameraResult{camera_of(bundle.right, options_),
                         std::sqrt(adjusted.right_sum_px2 / corners), adjusted.right_sigma};
        report_.rms_px =
            std::sqrt((adjusted.left_sum_px2 + adjusted.right_sum_px2) / (2.0 * corners));
        report_.stereo_rms_px = report_.rms_px;
        report_.T_right_from_left = transform_of(bundle.right_from_left);
        const Eigen::Matrix3d& C = adjusted.translation_covariance_mm2;
        report_.sigma_T_mm = C.diagonal().cwiseSqrt();
        const Eigen::Vector3d along = report_.T_right_from_left.t_mm.normalized();
        report_.baseline_sigma_mm = std::sqrt(std::max(0.0, along.dot(C * along)));
        use_known_baseline();
        report_.rig =
            rig_from_pair(report_.left.camera, report_.right->camera, report_.T_right_from_left);
        report_.rig.provenance.baseline_sigma_mm = report_.baseline_sigma_mm;
        report_.rig.provenance.stereo_rms_px = report_.stereo_rms_px;
    }

    // A baseline that was measured otherwise is weighed against the board's and sets the scale.
    void use_known_baseline() {
        if (!options_.baseline) {
            return;
        }
        const double found = report_.T_right_from_left.t_mm.norm();
        const double known = options_.baseline->baseline_mm;
        const double known_sigma = options_.baseline->sigma_mm;
        const double both = std::hypot(report_.baseline_sigma_mm, known_sigma);
        if (std::abs(found - known) > baseline_sigmas * both) {
            refuse("The baseline comes out at " + std::to_string(found) + " mm, " +
                   std::to_string(std::abs(found - known) / both) + " deviations from the known " +
                   std::to_string(known) + " mm: check the square's size.");
            return;
        }
        const double w_found = 1.0 / std::pow(std::max(1e-9, report_.baseline_sigma_mm), 2);
        const double w_known = 1.0 / std::pow(std::max(1e-9, known_sigma), 2);
        const double best = (w_found * found + w_known * known) / (w_found + w_known);
        report_.T_right_from_left.t_mm *= best / found;
        report_.baseline_sigma_mm = 1.0 / std::sqrt(w_found + w_known);
    }

    void judge() {
        const auto check = [&](const char* name, const CameraResult& result) {
            const auto why =
                implausibility(result.camera.lens, options_.width_px, options_.height_px);
            if (!why.empty()) {
                refuse(std::string("The ") + name + " camera can't be: " + why + ".");
            }
        };
        check("left", report_.left);
        if (report_.right) {
            check("right", *report_.right);
        }
        const std::string rms = "The residuals are " + std::to_string(report_.rms_px) + " px";
        if (report_.rms_px > options_.refused_rms_px) {
            refuse(rms + ", more than " + std::to_string(options_.refused_rms_px) + ".");
        } else if (report_.rms_px > options_.usable_rms_px) {
            report_.reasons.push_back(rms + "; below " + std::to_string(options_.usable_rms_px) +
                                      " would be good.");
        }
        if (!refused_) {
            report_.verdict = report_.reasons.empty() ? CalibrationReport::Verdict::good
                                                      : CalibrationReport::Verdict::usable;
        }
    }

    void refuse(std::string reason) {
        refused_ = true;
        report_.verdict = CalibrationReport::Verdict::refused;
        report_.reasons.push_back(std::move(reason));
    }

    const CalibratorOptions options_;
    const std::vector<Eigen::Vector3d> board_;
    const CalibrationProgress& progress_;
    Selection chosen_;
    CalibrationReport report_;
    bool refused_ = false;
};

}  // namespace

std::string to_string(CalibrationReport::Verdict verdict) {
    switch (verdict) {
        case CalibrationReport::Verdict::good:
            return "good";
        case CalibrationReport::Verdict::usable:
            return "usable";
        case CalibrationReport::Verdict::refused:
            break;
    }
    return "refused";
}

CalibrationReport calibrate_chessboard(const std::vector<BoardView>& views,
                                       const ChessboardTarget& board,
                                       const CalibratorOptions& options, std::stop_token stop,
                                       const CalibrationProgress& progress) {
    return Calibration(views, board, options, progress).run(std::move(stop));
}

}  // namespace kambara
