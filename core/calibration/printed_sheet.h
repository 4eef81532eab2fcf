// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/target.h"

namespace kambara {

/// A paper's format, upright, mm.
struct PaperFormat {
    std::string name;
    double width_mm = 0.0;
    double height_mm = 0.0;
};

/// A4, A3, A2, A1, A0 (ISO 216), then letter, legal and tabloid.
const std::vector<PaperFormat>& paper_formats();

/// What is printed, in the sheet's frame: mm from its top-left corner, right and down.
struct SheetPart {
    enum class Kind {
        rectangle,
        disc,   ///< the ellipse within the rectangle
        point,  ///< two opposite quarters of a disc; the point is where they meet
    };
    Kind kind = Kind::rectangle;
    double left_mm = 0.0;
    double top_mm = 0.0;
    double width_mm = 0.0;
    double height_mm = 0.0;
    bool dark = true;
    std::string label = {};  ///< beside a point
};

/// One plane of a target, flat. Later parts lie over earlier ones.
struct PrintedSheet {
    double width_mm = 0.0;
    double height_mm = 0.0;
    bool dark = false;      ///< the sheet itself
    bool cut = false;       ///< to be cut out exactly: its edge meets another sheet's
    double clear_mm = 5.0;  ///< of paper that is needed around it
    std::vector<SheetPart> parts;
};

/// The planes of a target in its own order. The white edge of a flat pattern need not be printed:
/// it counts as `clear_mm`, half a square. Points are put on the planes that hold most of them, a
/// point on two planes on both. Refuses points that lie on no plane of four, and a mark that lies
/// beside its sheet. A corner that was measured stands where the drawing has it.
Result<std::vector<PrintedSheet>> printed_sheets(const Target& target);

/// How a sheet lies on its paper: the paper's size as it is turned, and the sheet's top-left corner
/// from the paper's, mm. The free strip beside or below it takes the ruler and the words.
struct SheetPlace {
    double paper_width_mm = 0.0;
    double paper_height_mm = 0.0;
    double left_mm = 0.0;
    double top_mm = 0.0;
    bool strip_below = false;  ///< else at the right
};

inline constexpr double paper_margin_mm = 5.0;  ///< that printers leave white
inline constexpr double strip_mm = 16.0;        ///< the ruler and the words

/// The place of a sheet at its true size, upright where both ways fit; empty where none does.
std::optional<SheetPlace> place_on(const PaperFormat& paper, const PrintedSheet& sheet);

/// The paper by its name (capitals or not), or for "auto" the smallest of the A formats that takes
/// every sheet. Refuses a paper that is not known or too small, naming one that would do.
Result<PaperFormat> paper_for(const std::vector<PrintedSheet>& sheets, const std::string& name);

}  // namespace kambara
