// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/chessboard_detector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/image/opencv_view.h"

namespace kambara {
namespace {

constexpr double window_share = 0.3;  // of the corner spacing, to each side
constexpr double least_spacing_px = 6.0;

double smallest_spacing_px(const std::vector<cv::Point2f>& corners, int across, int down) {
    double smallest = std::numeric_limits<double>::max();
    const auto at = [&](int x, int y) { return corners[static_cast<std::size_t>(y * across + x)]; };
    for (int y = 0; y < down; ++y) {
        for (int x = 0; x < across; ++x) {
            if (x + 1 < across) {
                smallest = std::min(smallest, cv::norm(at(x + 1, y) - at(x, y)));
            }
            if (y + 1 < down) {
                smallest = std::min(smallest, cv::norm(at(x, y + 1) - at(x, y)));
            }
        }
    }
    return smallest;
}

}  // namespace

Result<std::vector<Eigen::Vector2d>> detect_chessboard(const Image& grey,
                                                       const ChessboardTarget& board) {
    const cv::Mat picture = opencv_view(grey);
    const cv::Size size(board.corners_across, board.corners_down);
    std::vector<cv::Point2f> corners;
    const bool found = cv::findChessboardCorners(
        picture, size, corners, cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE);
    if (!found) {
        return Error{"No chessboard of " + std::to_string(board.corners_across) + " x " +
                         std::to_string(board.corners_down) + " inner corners is found.",
                     "Show the whole board with a white margin, evenly lit, and check the numbers "
                     "of corners."};
    }
    const double spacing = smallest_spacing_px(corners, size.width, size.height);
    if (spacing < least_spacing_px) {
        return Error{"The chessboard is too small in the picture: its corners are " +
                         std::to_string(spacing) + " px apart.",
                     "Bring it nearer."};
    }
    const int half = std::max(2, static_cast<int>(std::lround(window_share * spacing)));
    cv::cornerSubPix(picture, corners, cv::Size(half, half), cv::Size(-1, -1),
                     cv::TermCriteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 100, 1e-4));
    std::vector<Eigen::Vector2d> result;
    result.reserve(corners.size());
    for (const cv::Point2f& corner : corners) {
        result.emplace_back(corner.x, corner.y);
    }
    return result;
}

}  // namespace kambara
