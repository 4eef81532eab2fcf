// SPDX-License-Identifier: GPL-3.0-or-later
// Targets as a few words, and whether they can be.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>

#include "core/calibration/charuco_board.h"
#include "core/calibration/target.h"
#include "core/calibration/target_file.h"

namespace kambara {
namespace {

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

// The rest of a short form behind its colon; false where it is not written so.
bool read(std::string_view rest, ChessboardTarget& board) {
    return read_number(rest, board.corners_across) && read_mark(rest, 'x') &&
           read_number(rest, board.corners_down) && read_mark(rest, ':') &&
           read_number(rest, board.square_mm) && rest.empty();
}

bool read(std::string_view rest, CharucoTarget& board) {
    if (!read_number(rest, board.squares_across) || !read_mark(rest, 'x') ||
        !read_number(rest, board.squares_down) || !read_mark(rest, ':') ||
        !read_number(rest, board.square_mm) || !read_mark(rest, ':') ||
        !read_number(rest, board.marker_mm) || !read_mark(rest, ':')) {
        return false;
    }
    board.dictionary = std::string(rest);
    return true;
}

bool length(double mm) {
    return mm > 0.0 && mm <= 10000.0;
}

bool count(int n, int least) {
    return n >= least && n <= 100;
}

std::string fault(const ChessboardTarget& board) {
    if (!count(board.corners_across, 3) || !count(board.corners_down, 3) ||
        !length(board.square_mm)) {
        return "it needs 3 to 100 inner corners each way and a square of up to 10000 mm";
    }
    return {};
}

std::string fault(const CharucoTarget& board) {
    if (!count(board.squares_across, 3) || !count(board.squares_down, 3) ||
        !length(board.square_mm)) {
        return "it needs 3 to 100 squares each way and a square of up to 10000 mm";
    }
    if (!length(board.marker_mm) || board.marker_mm >= board.square_mm) {
        return "its marker is not smaller than its square";
    }
    const auto dictionary = marker_dictionary(board.dictionary);
    if (!dictionary) {
        return "there is no marker dictionary \"" + board.dictionary + "\"";
    }
    if (board.squares_across * board.squares_down / 2 > dictionary->markers) {
        return "its dictionary has only " + std::to_string(dictionary->markers) + " markers";
    }
    return {};
}

std::string fault(const BoxTarget& target) {
    if (target.planes.empty() || target.planes.size() > 16 || !count(target.rows, 1)) {
        return "it needs 1 to 16 planes and 1 to 100 rows";
    }
    if (!length(target.box_width_mm) || !length(target.box_height_mm) ||
        !length(target.pitch_across_mm) || !length(target.pitch_down_mm) ||
        target.pitch_across_mm <= target.box_width_mm ||
        target.pitch_down_mm <= target.box_height_mm) {
        return "its boxes touch each other: a pitch is larger than the box";
    }
    if (target.margin_mm < 0.0 || !(target.margin_mm <= 10000.0)) {
        return "its margin can't be";
    }
    for (const BoxPlane& plane : target.planes) {
        const auto gap = [](double mm) { return mm >= 0.0 && mm <= 10000.0; };
        if (!count(plane.columns, 1) || !gap(plane.gap_before_mm) || !gap(plane.gap_after_mm) ||
            !(plane.angle_deg >= 30.0 && plane.angle_deg <= 330.0)) {
            return "a plane needs 1 to 100 columns, gaps of 0 or more and an angle of 30 to 330 "
                   "degrees";
        }
    }
    for (const RoundMark& mark : target.marks) {
        if (mark.plane < 0 || mark.plane >= static_cast<int>(target.planes.size()) ||
            !length(mark.diameter_mm) || !(std::abs(mark.across_mm) <= 10000.0) ||
            !(std::abs(mark.down_mm) <= 10000.0)) {
            return "a round mark needs a plane of the target, a place on it and a diameter";
        }
    }
    return {};
}

std::string fault(const PointTarget& target) {
    if (target.points_mm.size() < 4 || target.points_mm.size() > 10000) {
        return "it needs 4 to 10000 points";
    }
    return {};
}

std::string accuracy_fault(const Target& target) {
    const auto sensible = [](double sigma) { return sigma >= 0.0 && sigma <= 100.0; };
    const TargetAccuracy& accuracy = accuracy_of(target);
    const int corners = static_cast<int>(drawn_corners_mm(target).size());
    std::set<int> seen;
    for (const MeasuredCorner& corner : accuracy.measured) {
        if (corner.id < 0 || corner.id >= corners) {
            return "it has no corner " + std::to_string(corner.id) + " that could be measured";
        }
        if (!seen.insert(corner.id).second) {
            return "corner " + std::to_string(corner.id) + " is measured twice";
        }
        if (!sensible(corner.sigma_mm)) {
            return "a corner's sigma is not between 0 and 100 mm";
        }
    }
    return sensible(accuracy.sigma_mm) ? "" : "its sigma is not between 0 and 100 mm";
}

std::string short_form(const ChessboardTarget& board) {
    char text[96];
    std::snprintf(text, sizeof text, "chessboard:%dx%d:%g", board.corners_across,
                  board.corners_down, board.square_mm);
    return text;
}

std::string short_form(const CharucoTarget& board) {
    char text[96];
    std::snprintf(text, sizeof text, "charuco:%dx%d:%g:%g:", board.squares_across,
                  board.squares_down, board.square_mm, board.marker_mm);
    return text + board.dictionary;
}

std::string short_form(const BoxTarget& target) {
    BoxTarget plain = target;
    plain.accuracy = {};
    if (plain == two_plane_24()) {
        return "two-plane-24";
    }
    return std::to_string(drawn_corners_mm(target).size() / 4) + " boxes on " +
           std::to_string(target.planes.size()) +
           (target.planes.size() == 1 ? " plane" : " planes");
}

std::string short_form(const PointTarget& target) {
    return std::to_string(target.points_mm.size()) + " points";
}

template <class Kind>
Result<Target> checked(std::string_view text, std::string_view prefix, const Error& refused) {
    Kind board;
    if (!read(text.substr(prefix.size()), board)) {
        return refused;
    }
    if (const auto why = target_fault(board); !why.empty()) {
        return Error{"The target \"" + std::string(text) + "\" can't be used: " + why + ".",
                     "Give the numbers of the printed board."};
    }
    return Target(board);
}

}  // namespace

std::string target_fault(const Target& target) {
    auto why = std::visit([](const auto& kind) { return fault(kind); }, target);
    return why.empty() ? accuracy_fault(target) : why;
}

Result<Target> parse_target(std::string_view text) {
    if (text.ends_with(".yaml") || text.ends_with(".yml")) {
        return read_target_file(std::filesystem::path(text));
    }
    if (text == "two-plane-24") {
        return Target(two_plane_24());
    }
    const Error refused{
        "The target \"" + std::string(text) + "\" is not one this program knows.",
        "Give a target file (.yaml), chessboard:9x6:30 (inner corners across x down, square in "
        "mm), charuco:5x7:40:20:DICT_6X6_250 (squares across x down, square, marker, dictionary) "
        "or two-plane-24."};
    if (constexpr std::string_view prefix = "chessboard:"; text.starts_with(prefix)) {
        return checked<ChessboardTarget>(text, prefix, refused);
    }
    if (constexpr std::string_view prefix = "charuco:"; text.starts_with(prefix)) {
        return checked<CharucoTarget>(text, prefix, refused);
    }
    return refused;
}

std::string to_string(const Target& target) {
    return std::visit([](const auto& kind) { return short_form(kind); }, target);
}

}  // namespace kambara
