// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/charuco_detector.h"

#include <Eigen/Dense>
#include <algorithm>
#include <opencv2/aruco/charuco.hpp>

#include "core/calibration/charuco_board.h"
#include "core/calibration/corner_refinement.h"
#include "core/image/opencv_view.h"

namespace kambara {
namespace {

constexpr std::size_t least_corners = 6;

// Whether the corners span a plane, not a line.
bool spread_out(const DetectedCorners& corners, const CharucoTarget& board) {
    const int across = board.squares_across - 1;
    bool rows = false;
    bool columns = false;
    for (const DetectedCorner& corner : corners) {
        rows = rows || corner.id / across != corners.front().id / across;
        columns = columns || corner.id % across != corners.front().id % across;
    }
    return rows && columns;
}

}  // namespace

Result<DetectedCorners> detect_charuco(const Image& grey, const CharucoTarget& board) {
    const auto known = marker_dictionary(board.dictionary);
    if (!known) {
        return Error{"There is no marker dictionary \"" + board.dictionary + "\".",
                     "Name one of OpenCV's, for example DICT_6X6_250."};
    }
    const cv::Mat picture = opencv_view(grey);
    const auto dictionary = cv::aruco::getPredefinedDictionary(known->number);
    const auto layout = cv::aruco::CharucoBoard::create(
        board.squares_across, board.squares_down, static_cast<float>(board.square_mm),
        static_cast<float>(board.marker_mm), dictionary);
    std::vector<std::vector<cv::Point2f>> markers;
    std::vector<std::vector<cv::Point2f>> refused;
    std::vector<int> ids;
    cv::aruco::detectMarkers(picture, dictionary, markers, ids,
                             cv::aruco::DetectorParameters::create(), refused);
    if (ids.empty()) {
        return Error{"No marker of the ChArUco board is found.",
                     "Show the board larger and evenly lit, and check its dictionary."};
    }
    cv::aruco::refineDetectedMarkers(picture, layout, markers, ids, refused);
    std::vector<cv::Point2f> at;
    std::vector<int> numbers;
    cv::aruco::interpolateCornersCharuco(markers, ids, picture, layout, at, numbers);
    DetectedCorners corners;
    for (std::size_t i = 0; i < at.size(); ++i) {
        corners.push_back({numbers[i], {at[i].x, at[i].y}});
    }
    std::sort(corners.begin(), corners.end(),
              [](const auto& a, const auto& b) { return a.id < b.id; });
    // The window keeps clear of the markers beside the corner.
    const double clear = 0.5 * (board.square_mm - board.marker_mm) / board.square_mm;
    refine_corners(grey, corners, std::min(0.3, clear));
    if (corners.size() < least_corners || !spread_out(corners, board)) {
        return Error{
            "Only " + std::to_string(corners.size()) + " corners of the ChArUco board are found.",
            "Show more of the board: six corners that are not all in a row."};
    }
    return corners;
}

}  // namespace kambara
