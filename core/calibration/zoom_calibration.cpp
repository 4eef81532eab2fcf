// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/zoom_calibration.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>
#include <optional>

#include "core/camera/zoom.h"
#include "core/image/opencv_view.h"

namespace kambara {
namespace {

constexpr int most_points = 400;
constexpr double corner_quality = 0.01;  // of the best corner's
constexpr double apart_px = 9.0;
constexpr int window_px = 21;
constexpr int reach_levels = 4;  // of the pyramid: some 100 px
constexpr double there_and_back_px = 0.5;
constexpr double inlier_px = 2.0;  // of a similarity, before the lens is thought of
constexpr double settled = 1e-5;   // change of the magnification
constexpr int grid_px = 16;        // a lens is smooth between these
constexpr double guess_step = 1.1;

std::string share_text(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3f", share);
    return text;
}

/// Where a thing is seen in the picture drawn for the guess, and in the one it is looked for in.
struct Seen {
    Eigen::Vector2d drawn_px;
    Eigen::Vector2d found_px;
};

struct Step {
    double magnification = 1.0;
    double log_sigma = 0.0;
    int points = 0;
    double rms_px = 0.0;
};

// Where the lens zoomed to `from` shows what each pixel of the lens zoomed to `to` does.
cv::Mat places_of(const Lens& lens, const Image& grey, double from, double to) {
    const Lens source = zoomed(lens, from);
    const Lens target = zoomed(lens, to);
    const int columns = grey.width() / grid_px + 2;
    const int rows = grey.height() / grid_px + 2;
    cv::Mat coarse(rows, columns, CV_32FC2);
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto ray = unproject(target, {i * grid_px, j * grid_px});
            const auto pixel = ray ? project(source, ray->at(1.0)) : std::nullopt;
            const Eigen::Vector2d at = pixel.value_or(Eigen::Vector2d(-1e4, -1e4));
            coarse.at<cv::Vec2f>(j, i) = {static_cast<float>(at.x()), static_cast<float>(at.y())};
        }
    }
    cv::Mat places(grey.height(), grey.width(), CV_32FC2);
    for (int y = 0; y < grey.height(); ++y) {
        const int j = y / grid_px;
        const float v = static_cast<float>(y % grid_px) / grid_px;
        for (int x = 0; x < grey.width(); ++x) {
            const int i = x / grid_px;
            const float u = static_cast<float>(x % grid_px) / grid_px;
            const cv::Vec2f above =
                coarse.at<cv::Vec2f>(j, i) * (1.0F - u) + coarse.at<cv::Vec2f>(j, i + 1) * u;
            const cv::Vec2f below = coarse.at<cv::Vec2f>(j + 1, i) * (1.0F - u) +
                                    coarse.at<cv::Vec2f>(j + 1, i + 1) * u;
            places.at<cv::Vec2f>(y, x) = above * (1.0F - v) + below * v;
        }
    }
    return places;
}

cv::Mat drawn_at(const Image& grey, const cv::Mat& places) {
    cv::Mat drawn;
    cv::remap(opencv_view(grey), drawn, places, cv::noArray(), cv::INTER_CUBIC,
              cv::BORDER_CONSTANT);
    return drawn;
}

// Where the drawn picture is of pixels, not of what lies beyond them.
cv::Mat drawn_part(const cv::Mat& places) {
    cv::Mat part = drawn_at(Image(places.cols, places.rows, 1, 255), places);
    cv::threshold(part, part, 254.0, 255.0, cv::THRESH_BINARY);
    cv::erode(part, part, cv::Mat::ones(15, 15, CV_8UC1), {-1, -1}, 1, cv::BORDER_CONSTANT, 0);
    return part;
}

std::vector<Seen> follow(const cv::Mat& drawn, const cv::Mat& part, const cv::Mat& next) {
    std::vector<cv::Point2f> from;
    cv::goodFeaturesToTrack(drawn, from, most_points, corner_quality, apart_px, part);
    if (from.empty()) {
        return {};
    }
    std::vector<cv::Point2f> to;
    std::vector<cv::Point2f> back;
    std::vector<std::uint8_t> found;
    std::vector<std::uint8_t> found_back;
    const cv::Size window(window_px, window_px);
    const cv::TermCriteria until(cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.001);
    cv::calcOpticalFlowPyrLK(drawn, next, from, to, found, cv::noArray(), window, reach_levels,
                             until);
    cv::calcOpticalFlowPyrLK(next, drawn, to, back, found_back, cv::noArray(), window, reach_levels,
                             until);
    std::vector<cv::Point2f> a;
    std::vector<cv::Point2f> b;
    for (std::size_t i = 0; i < from.size(); ++i) {
        if (found[i] != 0 && found_back[i] != 0 &&
            cv::norm(back[i] - from[i]) < there_and_back_px) {
            a.push_back(from[i]);
            b.push_back(to[i]);
        }
    }
    std::vector<std::uint8_t> fits;
    if (a.size() < 4 || cv::estimateAffinePartial2D(a, b, fits, cv::RANSAC, inlier_px).empty()) {
        return {};
    }
    std::vector<Seen> seen;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (fits[i] != 0) {
            seen.push_back({{a[i].x, a[i].y}, {b[i].x, b[i].y}});
        }
    }
    return seen;
}

using Residuals = Eigen::Matrix<double, Eigen::Dynamic, 1>;

constexpr double out_of_reach_px = 1e6;  // beyond what any weight leaves

// By the logarithm of the magnification and the turn of the camera, to the places found.
Residuals residuals_of(const Lens& lens, const std::vector<Eigen::Vector3d>& directions,
                       const std::vector<Seen>& seen, const Eigen::Vector4d& x) {
    const Lens now = zoomed(lens, std::exp(x[0]));
    const Eigen::Vector3d turn = x.tail<3>();
    Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
    if (turn.norm() > 0.0) {
        R = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    }
    Residuals r = Residuals::Zero(static_cast<Eigen::Index>(2 * seen.size()));
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const auto pixel = project(now, R * directions[i]);
        r.segment<2>(static_cast<Eigen::Index>(2 * i)) =
            pixel ? Eigen::Vector2d(*pixel - seen[i].found_px)
                  : Eigen::Vector2d::Constant(out_of_reach_px);
    }
    return r;
}

// By how much the noise of windows that overlap is more than that of as many apart.
double shared_noise(const std::vector<Seen>& seen) {
    const auto overlap = [](double apart) { return std::max(0.0, 1.0 - apart / window_px); };
    double sum = 0.0;
    for (const Seen& a : seen) {
        for (const Seen& b : seen) {
            const Eigen::Vector2d apart = (a.drawn_px - b.drawn_px).cwiseAbs();
            sum += overlap(apart.x()) * overlap(apart.y());
        }
    }
    return sum / static_cast<double>(seen.size());
}

double median_length(const Residuals& r) {
    std::vector<double> lengths;
    for (Eigen::Index i = 0; i < r.size(); i += 2) {
        lengths.push_back(r.segment<2>(i).norm());
    }
    const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

std::optional<Step> fit(const Lens& lens, const std::vector<Seen>& all, double guess) {
    std::vector<Eigen::Vector3d> directions;
    std::vector<Seen> seen;
    const Lens drawn = zoomed(lens, guess);
    for (const Seen& one : all) {
        if (const auto ray = unproject(drawn, one.drawn_px)) {
            directions.push_back(ray->at(1.0));
            seen.push_back(one);
        }
    }
    if (seen.size() < 4) {
        return std::nullopt;
    }
    Eigen::Vector4d x(std::log(guess), 0.0, 0.0, 0.0);
    Step step;
    double variance = 0.0;  // of the magnification's logarithm, as if no two points shared noise
    for (int round = 0; round < 12; ++round) {
        const Residuals r = residuals_of(lens, directions, seen, x);
        const double reach_px = 4.685 * std::max(0.02, 0.85 * median_length(r));  // Tukey's
        Eigen::Matrix<double, Eigen::Dynamic, 4> J(r.size(), 4);
        for (int k = 0; k < 4; ++k) {
            constexpr double by = 1e-6;
            Eigen::Vector4d moved = x;
            moved[k] += by;
            J.col(k) = (residuals_of(lens, directions, seen, moved) - r) / by;
        }
        Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
        Eigen::Vector4d right = Eigen::Vector4d::Zero();
        double squares = 0.0;
        double weights = 0.0;
        step.points = 0;
        for (Eigen::Index i = 0; i < r.size(); i += 2) {
            const double t = r.segment<2>(i).norm() / reach_px;
            if (t >= 1.0) {
                continue;
            }
            const double weight = (1.0 - t * t) * (1.0 - t * t);
            normal += weight * J.middleRows<2>(i).transpose() * J.middleRows<2>(i);
            right -= weight * J.middleRows<2>(i).transpose() * r.segment<2>(i);
            squares += weight * r.segment<2>(i).squaredNorm();
            weights += weight;
            ++step.points;
        }
        if (step.points < 4) {
            return std::nullopt;
        }
        const Eigen::LDLT<Eigen::Matrix4d> solver(normal);
        const Eigen::Vector4d change = solver.solve(right);
        if (!change.allFinite()) {
            return std::nullopt;
        }
        x += change;
        step.rms_px = std::sqrt(squares / weights);
        variance = squares / std::max(1.0, 2.0 * weights - 4.0) *
                   solver.solve(Eigen::Vector4d::Unit(0)).x();
        if (std::abs(change[0]) < settled && change.tail<3>().norm() < settled) {
            break;
        }
    }
    step.magnification = std::exp(x[0]);
    step.log_sigma = std::sqrt(shared_noise(seen) * variance);
    return step;
}

// From the picture at `from` to the next one, for a first guess of its magnification.
std::optional<Step> step_by(const Lens& lens, const Image& grey, double from, const cv::Mat& next,
                            double guess) {
    const cv::Mat places = places_of(lens, grey, from, guess);
    return fit(lens, follow(drawn_at(grey, places), drawn_part(places), next), guess);
}

std::optional<Step> best_step(const Lens& lens, const Image& grey, double from, const Image& next,
                              const ZoomCalibrationOptions& options) {
    const cv::Mat found_in = opencv_view(next);
    std::optional<Step> best;
    for (double ratio = 1.0; ratio <= options.largest_step; ratio *= guess_step) {
        for (const double guess : {from * ratio, from / ratio}) {
            const auto step = step_by(lens, grey, from, found_in, guess);
            if (step && (!best || step->points > best->points)) {
                best = step;
            }
            if (ratio == 1.0) {
                break;
            }
        }
    }
    // Drawn for what was found, both pictures look the same, and no patch is matched with a larger
    // one.
    for (int round = 0; best && round < 3; ++round) {
        const double guess = best->magnification;
        const auto step = step_by(lens, grey, from, found_in, guess);
        if (!step) {
            return std::nullopt;
        }
        best = step;
        if (std::abs(std::log(step->magnification / guess)) < settled) {
            break;
        }
    }
    return best;
}

std::optional<Error> refusal(const Camera& camera, const std::vector<ZoomView>& views,
                             const ZoomCalibrationOptions& options) {
    if (views.size() < 2) {
        return Error{"A zoom is measured by two views at the least.",
                     "Take views from the widest to the longest zoom."};
    }
    if (views.front().zoom_share > options.widest_share) {
        return Error{"The widest view is at zoom " + share_text(views.front().zoom_share) +
                         "; the camera's calibration is that of zoom 0.",
                     "Take a view at zoom 0 as well."};
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Image& grey = *views[i].grey;
        if (grey.channels() != 1 || grey.width() != camera.width_px ||
            grey.height() != camera.height_px) {
            return Error{"The view at zoom " + share_text(views[i].zoom_share) + " has " +
                             std::to_string(grey.width()) + " x " + std::to_string(grey.height()) +
                             " pixels, the camera " + std::to_string(camera.width_px) + " x " +
                             std::to_string(camera.height_px) + ".",
                         "Use the rig file of the camera that took the views."};
        }
        if (i > 0 && views[i].zoom_share <= views[i - 1].zoom_share) {
            return Error{"Two views are at the same zoom, " + share_text(views[i].zoom_share) + ".",
                         "Leave one of them out."};
        }
    }
    return std::nullopt;
}

}  // namespace

Result<std::vector<ZoomPlace>> calibrate_zoom(const Camera& camera, std::vector<ZoomView> views,
                                              const ZoomCalibrationOptions& options) {
    std::stable_sort(views.begin(), views.end(), [](const ZoomView& a, const ZoomView& b) {
        return a.zoom_share < b.zoom_share;
    });
    if (auto error = refusal(camera, views, options)) {
        return *error;
    }
    std::vector<ZoomPlace> places{{views.front().zoom_share}};
    double log_variance = 0.0;
    for (std::size_t i = 1; i < views.size(); ++i) {
        const double from = places.back().magnification;
        const auto step = best_step(camera.lens, *views[i - 1].grey, from, *views[i].grey, options);
        // Written so that a deviation which is no number is refused as well.
        if (!step || step->points < options.least_points ||
            !(step->log_sigma <= options.largest_sigma) ||
            !(step->rms_px <= options.largest_rms_px)) {
            const std::string found = std::to_string(step ? step->points : 0);
            const bool enough = step && step->points >= options.least_points;
            return Error{"From zoom " + share_text(views[i - 1].zoom_share) + " to " +
                             share_text(views[i].zoom_share) +
                             (enough ? " the " + found + " points found again fit no zoom."
                                     : " only " + found + " points are found again."),
                         "Take more views between these, of a scene at rest with much detail, in "
                         "focus, the head at rest as well."};
        }
        log_variance += step->log_sigma * step->log_sigma;
        places.push_back({views[i].zoom_share, step->magnification,
                          step->magnification * std::sqrt(log_variance), step->points,
                          step->rms_px});
    }
    return places;
}

}  // namespace kambara
