// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/chessboard_detector.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "core/calibration/corner_refinement.h"
#include "core/image/opencv_view.h"

namespace kambara {
namespace {

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

Result<DetectedCorners> detect_chessboard(const Image& grey, const ChessboardTarget& board) {
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
    DetectedCorners result;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        result.push_back({static_cast<int>(i), {corners[i].x, corners[i].y}});
    }
    const std::size_t all = result.size();
    refine_corners(grey, result);
    if (result.size() < all) {
        return Error{"The chessboard's corners are too blurred to be measured.",
                     "Hold it still and focus."};
    }
    return result;
}

}  // namespace kambara
