// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/charuco_board.h"

#include <array>
#include <opencv2/aruco/dictionary.hpp>
#include <utility>

namespace kambara {
namespace {

constexpr std::array<std::pair<const char*, int>, 17> dictionaries{{
    {"DICT_4X4_50", cv::aruco::DICT_4X4_50},
    {"DICT_4X4_100", cv::aruco::DICT_4X4_100},
    {"DICT_4X4_250", cv::aruco::DICT_4X4_250},
    {"DICT_4X4_1000", cv::aruco::DICT_4X4_1000},
    {"DICT_5X5_50", cv::aruco::DICT_5X5_50},
    {"DICT_5X5_100", cv::aruco::DICT_5X5_100},
    {"DICT_5X5_250", cv::aruco::DICT_5X5_250},
    {"DICT_5X5_1000", cv::aruco::DICT_5X5_1000},
    {"DICT_6X6_50", cv::aruco::DICT_6X6_50},
    {"DICT_6X6_100", cv::aruco::DICT_6X6_100},
    {"DICT_6X6_250", cv::aruco::DICT_6X6_250},
    {"DICT_6X6_1000", cv::aruco::DICT_6X6_1000},
    {"DICT_7X7_50", cv::aruco::DICT_7X7_50},
    {"DICT_7X7_100", cv::aruco::DICT_7X7_100},
    {"DICT_7X7_250", cv::aruco::DICT_7X7_250},
    {"DICT_7X7_1000", cv::aruco::DICT_7X7_1000},
    {"DICT_ARUCO_ORIGINAL", cv::aruco::DICT_ARUCO_ORIGINAL},
}};

}  // namespace

std::optional<MarkerDictionary> marker_dictionary(const std::string& name) {
    for (const auto& [known, number] : dictionaries) {
        if (name == known) {
            return MarkerDictionary{number,
                                    cv::aruco::getPredefinedDictionary(number)->bytesList.rows};
        }
    }
    return std::nullopt;
}

std::vector<CharucoMarker> charuco_markers(const CharucoTarget& target) {
    std::vector<CharucoMarker> markers;
    const auto known = marker_dictionary(target.dictionary);
    if (!known) {
        return markers;
    }
    const auto dictionary = cv::aruco::getPredefinedDictionary(known->number);
    const int side = dictionary->markerSize + 2;
    const double inset_mm = 0.5 * (target.square_mm - target.marker_mm);
    for (int row = 0; row < target.squares_down; ++row) {
        for (int column = (row + 1) % 2; column < target.squares_across; column += 2) {
            CharucoMarker marker;
            marker.id = static_cast<int>(markers.size());
            if (marker.id >= known->markers) {
                return markers;
            }
            marker.top_left_mm = {(column - 1) * target.square_mm + inset_mm,
                                  (row - 1) * target.square_mm + inset_mm};
            marker.cells_a_side = side;
            marker.light.assign(static_cast<std::size_t>(side * side), false);
            const cv::Mat bits = cv::aruco::Dictionary::getBitsFromByteList(
                dictionary->bytesList.row(marker.id), dictionary->markerSize);
            for (int y = 0; y + 2 < side; ++y) {
                for (int x = 0; x + 2 < side; ++x) {
                    marker.light[static_cast<std::size_t>((y + 1) * side + x + 1)] =
                        bits.at<std::uint8_t>(y, x) != 0;
                }
            }
            markers.push_back(std::move(marker));
        }
    }
    return markers;
}

}  // namespace kambara
