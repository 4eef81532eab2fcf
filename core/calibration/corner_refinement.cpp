// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/corner_refinement.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/base/median.h"
#include "core/image/opencv_view.h"

namespace kambara {
namespace {

constexpr double least_sigma_px = 0.02;
constexpr double most_sigma_px = 2.0;

// The grey levels' noise: the median of the differences that no straight edge or slope leaves
// (second differences across second differences), which structure in a few pixels doesn't move.
double noise_levels(const cv::Mat& picture) {
    std::vector<double> sizes;
    for (int y = 1; y + 1 < picture.rows; y += 3) {
        for (int x = 1; x + 1 < picture.cols; x += 3) {
            const auto at = [&](int dx, int dy) {
                return static_cast<double>(picture.at<std::uint8_t>(y + dy, x + dx));
            };
            sizes.push_back(std::abs(at(-1, -1) - 2.0 * at(0, -1) + at(1, -1) - 2.0 * at(-1, 0) +
                                     4.0 * at(0, 0) - 2.0 * at(1, 0) + at(-1, 1) - 2.0 * at(0, 1) +
                                     at(1, 1)));
        }
    }
    if (sizes.empty()) {
        return 1.0;
    }
    // 36 is the sum of the weights' squares; rounding to whole levels is noise of 0.29.
    return std::hypot(1.4826 * median(std::move(sizes)) / 6.0, 0.29);
}

struct Window {
    double sigma_px = most_sigma_px;
    double blur_px = 0.0;
};

// The corner is where all gradients of the window are square to the way to it: least squares whose
// covariance is the noise of a gradient, at the distances at which it turns the answer.
Window look_at(const cv::Mat& picture, const Eigen::Vector2d& corner, int half, double noise) {
    Eigen::Matrix2d H = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    const int cx = static_cast<int>(std::lround(corner.x()));
    const int cy = static_cast<int>(std::lround(corner.y()));
    double low = 255.0;
    double high = 0.0;
    double steepest = 0.0;
    for (int y = std::max(1, cy - half); y <= std::min(picture.rows - 2, cy + half); ++y) {
        for (int x = std::max(1, cx - half); x <= std::min(picture.cols - 2, cx + half); ++x) {
            const auto at = [&](int u, int v) {
                return static_cast<double>(picture.at<std::uint8_t>(v, u));
            };
            const Eigen::Vector2d g(0.5 * (at(x + 1, y) - at(x - 1, y)),
                                    0.5 * (at(x, y + 1) - at(x, y - 1)));
            const Eigen::Vector2d way(corner.x() - x, corner.y() - y);
            const double weight =
                std::exp(-(way.squaredNorm()) / std::max(1.0, static_cast<double>(half * half)));
            H += weight * g * g.transpose();
            // Of the residual g . way, by a gradient's noise of half the levels' variance each way.
            spread += weight * weight * 0.5 * way.squaredNorm() * g * g.transpose();
            low = std::min(low, at(x, y));
            high = std::max(high, at(x, y));
            steepest = std::max(steepest, g.norm());
        }
    }
    Window window;
    if (H.determinant() > 1e-6 * H.trace() * H.trace()) {
        const Eigen::Matrix2d inverse = H.inverse();
        const Eigen::Matrix2d C = noise * noise * inverse * spread * inverse;
        window.sigma_px = std::clamp(std::sqrt(0.5 * C.trace()), least_sigma_px, most_sigma_px);
    }
    window.blur_px = steepest > 0.0 ? (high - low) / steepest : 0.0;
    return window;
}

}  // namespace

double spacing_px(const DetectedCorners& corners, std::size_t at) {
    double smallest = 1e300;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i != at) {
            smallest = std::min(smallest, (corners[i].px - corners[at].px).norm());
        }
    }
    return smallest;
}

void refine_corners(const Image& grey, DetectedCorners& corners, double share) {
    const cv::Mat picture = opencv_view(grey);
    const double noise = noise_levels(picture);
    DetectedCorners refined;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double spacing = spacing_px(corners, i);
        const int half = std::clamp(static_cast<int>(std::lround(share * spacing)), 2, 40);
        std::vector<cv::Point2f> at{
            {static_cast<float>(corners[i].px.x()), static_cast<float>(corners[i].px.y())}};
        cv::cornerSubPix(
            picture, at, cv::Size(half, half), cv::Size(-1, -1),
            cv::TermCriteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-4));
        DetectedCorner corner = corners[i];
        corner.px = {at[0].x, at[0].y};
        if ((corner.px - corners[i].px).norm() > half) {
            continue;
        }
        const Window window = look_at(picture, corner.px, half, noise);
        corner.sigma_px = window.sigma_px;
        corner.blur_px = window.blur_px;
        refined.push_back(corner);
    }
    corners = std::move(refined);
}

}  // namespace kambara
