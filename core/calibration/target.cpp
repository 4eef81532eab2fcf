// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target.h"

#include <charconv>
#include <cstdio>

namespace kambara {
namespace {

constexpr double box_width_mm = 50.0;
constexpr double box_height_mm = 70.0;
constexpr double pitch_across_mm = 75.0;
constexpr double pitch_down_mm = 95.0;
constexpr double edge_mm = 225.0;  // where the planes meet, on the left plane's x axis
constexpr double margin_mm = 25.0;

const Eigen::Vector3d down(0, 1, 0);

// Top-left corner of a box and the direction across it; columns 0..2 are on the left plane, 3..5
// on the right one, which runs from the shared edge towards the viewer.
TargetPatch box(int column, int row) {
    const double y = row * pitch_down_mm;
    if (column < 3) {
        return {{column * pitch_across_mm, y, 0.0},
                box_width_mm * Eigen::Vector3d::UnitX(),
                box_height_mm * down,
                true};
    }
    return {{edge_mm, y, -margin_mm - (column - 3) * pitch_across_mm},
            -box_width_mm * Eigen::Vector3d::UnitZ(),
            box_height_mm * down,
            true};
}

std::vector<Eigen::Vector3d> corners_of(const ChessboardTarget& target) {
    std::vector<Eigen::Vector3d> corners;
    for (int row = 0; row < target.corners_down; ++row) {
        for (int column = 0; column < target.corners_across; ++column) {
            corners.emplace_back(column * target.square_mm, row * target.square_mm, 0.0);
        }
    }
    return corners;
}

std::vector<Eigen::Vector3d> corners_of(const TwoPlaneTarget&) {
    std::vector<Eigen::Vector3d> corners;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 6; ++column) {
            const TargetPatch b = box(column, row);
            corners.push_back(b.origin_mm);
            corners.push_back(b.origin_mm + b.across_mm);
            corners.push_back(b.origin_mm + b.across_mm + b.down_mm);
            corners.push_back(b.origin_mm + b.down_mm);
        }
    }
    return corners;
}

std::vector<TargetPatch> patches(const ChessboardTarget& target) {
    const double s = target.square_mm;
    const int columns = target.corners_across + 1;
    const int rows = target.corners_down + 1;
    // The sheet has a white margin of one square beyond the outer squares.
    std::vector<TargetPatch> all{{{-2.0 * s, -2.0 * s, 0.0},
                                  (columns + 2) * s * Eigen::Vector3d::UnitX(),
                                  (rows + 2) * s * down,
                                  false}};
    for (int row = 0; row < rows; ++row) {
        for (int column = row % 2; column < columns; column += 2) {
            all.push_back({{(column - 1) * s, (row - 1) * s, 0.0},
                           s * Eigen::Vector3d::UnitX(),
                           s * down,
                           true});
        }
    }
    return all;
}

std::vector<TargetPatch> patches(const TwoPlaneTarget&) {
    const double top = -margin_mm;
    const double height = 3 * pitch_down_mm + box_height_mm + 2 * margin_mm;
    std::vector<TargetPatch> all{{{-margin_mm, top, 0.0},
                                  (edge_mm + margin_mm) * Eigen::Vector3d::UnitX(),
                                  height * down,
                                  false},
                                 {{edge_mm, top, 0.0},
                                  -(edge_mm + margin_mm) * Eigen::Vector3d::UnitZ(),
                                  height * down,
                                  false}};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 6; ++column) {
            all.push_back(box(column, row));
        }
    }
    return all;
}

bool read_number(std::string_view& text, auto& value) {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc{}) {
        return false;
    }
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
}

bool read_mark(std::string_view& text, char mark) {
    if (text.empty() || text.front() != mark) {
        return false;
    }
    text.remove_prefix(1);
    return true;
}

}  // namespace

Result<Target> parse_target(std::string_view text) {
    const Error refused{
        "The target \"" + std::string(text) + "\" is not one this program knows.",
        "Give chessboard:9x6:30 (inner corners across x down, square in mm) or two-plane-24."};
    if (text == "two-plane-24") {
        return Target(TwoPlaneTarget{});
    }
    constexpr std::string_view prefix = "chessboard:";
    if (!text.starts_with(prefix)) {
        return refused;
    }
    std::string_view rest = text.substr(prefix.size());
    ChessboardTarget board;
    if (!read_number(rest, board.corners_across) || !read_mark(rest, 'x') ||
        !read_number(rest, board.corners_down) || !read_mark(rest, ':') ||
        !read_number(rest, board.square_mm) || !rest.empty()) {
        return refused;
    }
    const auto sensible = [](int n) { return n >= 3 && n <= 100; };
    if (!sensible(board.corners_across) || !sensible(board.corners_down) ||
        !(board.square_mm > 0.0) || board.square_mm > 10000.0) {
        return Error{
            "A chessboard of " + std::string(rest.empty() ? text : rest) + " cannot be used.",
            "It needs 3 to 100 inner corners each way and a square of up to 10000 mm."};
    }
    return Target(board);
}

std::string to_string(const Target& target) {
    if (const auto* board = std::get_if<ChessboardTarget>(&target)) {
        char text[96];
        std::snprintf(text, sizeof text, "chessboard:%dx%d:%g", board->corners_across,
                      board->corners_down, board->square_mm);
        return text;
    }
    return "two-plane-24";
}

std::vector<Eigen::Vector3d> corners_in_target_mm(const Target& target) {
    return std::visit([](const auto& kind) { return corners_of(kind); }, target);
}

std::vector<TargetPatch> patches_of(const Target& target) {
    return std::visit([](const auto& kind) { return patches(kind); }, target);
}

}  // namespace kambara
