// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/printed_sheet.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <limits>

#include "core/calibration/point_planes.h"

namespace kambara {
namespace {

constexpr double point_mm = 8.0;   // a printed point's disc
constexpr double touching = 1e-6;  // of a sheet's size

bool lies_on(const TargetPatch& sheet, const Eigen::Vector3d& p) {
    const Eigen::Vector3d from = p - sheet.origin_mm;
    const double across = sheet.across_mm.norm();
    const double down = sheet.down_mm.norm();
    const Eigen::Vector3d normal = sheet.across_mm.cross(sheet.down_mm).normalized();
    const double u = from.dot(sheet.across_mm) / (across * across);
    const double v = from.dot(sheet.down_mm) / (down * down);
    return std::abs(from.dot(normal)) < touching * across && u > -touching && u < 1.0 + touching &&
           v > -touching && v < 1.0 + touching;
}

SheetPart part_on(const TargetPatch& sheet, const TargetPatch& patch) {
    const Eigen::Vector3d across = sheet.across_mm.normalized();
    const Eigen::Vector3d down = sheet.down_mm.normalized();
    const Eigen::Vector3d from = patch.origin_mm - sheet.origin_mm;
    return {patch.round ? SheetPart::Kind::disc : SheetPart::Kind::rectangle,
            from.dot(across),
            from.dot(down),
            patch.across_mm.dot(across),
            patch.down_mm.dot(down),
            patch.dark,
            {}};
}

// Around the parts instead of the whole sheet.
void shrink_to_parts(PrintedSheet& sheet) {
    constexpr double far = std::numeric_limits<double>::infinity();
    double left = far;
    double top = far;
    double right = -far;
    double bottom = -far;
    for (const SheetPart& part : sheet.parts) {
        left = std::min(left, part.left_mm);
        top = std::min(top, part.top_mm);
        right = std::max(right, part.left_mm + part.width_mm);
        bottom = std::max(bottom, part.top_mm + part.height_mm);
    }
    for (SheetPart& part : sheet.parts) {
        part.left_mm -= left;
        part.top_mm -= top;
    }
    sheet.width_mm = right - left;
    sheet.height_mm = bottom - top;
}

Result<std::vector<PrintedSheet>> sheets_of_patches(const Target& target) {
    std::vector<PrintedSheet> sheets;
    std::vector<TargetPatch> carriers;
    for (const TargetPatch& patch : patches_of(target)) {
        if (patch.sheet) {
            carriers.push_back(patch);
            sheets.push_back(
                {patch.across_mm.norm(), patch.down_mm.norm(), patch.dark, true, 5.0, {}});
            continue;
        }
        const Eigen::Vector3d end = patch.origin_mm + patch.across_mm + patch.down_mm;
        const auto carrier =
            std::find_if(carriers.begin(), carriers.end(), [&](const TargetPatch& sheet) {
                return lies_on(sheet, patch.origin_mm) && lies_on(sheet, end);
            });
        if (carrier == carriers.end()) {
            return Error{"A mark of the target does not lie on its sheet.",
                         "Move the mark in the target file, or give the target a wider margin_mm."};
        }
        sheets[static_cast<std::size_t>(carrier - carriers.begin())].parts.push_back(
            part_on(*carrier, patch));
    }
    return sheets;
}

Result<std::vector<PrintedSheet>> sheets_of_squares(const Target& target, double square_mm) {
    auto sheets = sheets_of_patches(target);
    for (PrintedSheet& sheet : *sheets) {
        shrink_to_parts(sheet);
        sheet.cut = false;
        sheet.clear_mm = std::max(paper_margin_mm, 0.5 * square_mm);
    }
    return sheets;
}

Result<std::vector<PrintedSheet>> sheets_of(const ChessboardTarget& target) {
    return sheets_of_squares(target, target.square_mm);
}

Result<std::vector<PrintedSheet>> sheets_of(const CharucoTarget& target) {
    return sheets_of_squares(target, target.square_mm);
}

Result<std::vector<PrintedSheet>> sheets_of(const BoxTarget& target) {
    return sheets_of_patches(target);
}

Result<std::vector<PrintedSheet>> sheets_of(const PointTarget& target) {
    const auto planes = planes_of(target.points_mm);
    if (planes.empty()) {
        return Error{
            "The target's points can't be printed: some lie on no plane with three others "
            "or more.",
            "Print targets whose points stand on up to 16 planes."};
    }
    std::vector<PrintedSheet> sheets;
    for (const PointPlane& plane : planes) {
        PrintedSheet sheet;
        for (const int number : plane.points) {
            const Eigen::Vector3d from =
                target.points_mm[static_cast<std::size_t>(number)] - plane.origin_mm;
            sheet.parts.push_back({SheetPart::Kind::point, from.dot(plane.across) - 0.5 * point_mm,
                                   from.dot(plane.down) - 0.5 * point_mm, point_mm, point_mm, true,
                                   std::to_string(number)});
        }
        shrink_to_parts(sheet);
        sheets.push_back(std::move(sheet));
    }
    return sheets;
}

// Upright or turned, the strip at one side; the rest of the paper evenly around the sheet.
std::optional<SheetPlace> place(double paper_width, double paper_height, const PrintedSheet& sheet,
                                bool strip_below) {
    const double strip = strip_mm + paper_margin_mm;
    const double free_width =
        paper_width - sheet.width_mm - sheet.clear_mm - (strip_below ? sheet.clear_mm : strip);
    const double free_height =
        paper_height - sheet.height_mm - sheet.clear_mm - (strip_below ? strip : sheet.clear_mm);
    // The clear strip lies between the sheet and the words, too.
    const double width_left = strip_below ? free_width : free_width - sheet.clear_mm;
    const double height_left = strip_below ? free_height - sheet.clear_mm : free_height;
    if (width_left < -1e-9 || height_left < -1e-9) {
        return std::nullopt;
    }
    return SheetPlace{paper_width, paper_height, sheet.clear_mm + 0.5 * width_left,
                      sheet.clear_mm + 0.5 * height_left, strip_below};
}

std::string lower(std::string text) {
    for (char& c : text) {
        c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    return text;
}

bool takes_all(const PaperFormat& paper, const std::vector<PrintedSheet>& sheets) {
    return std::all_of(sheets.begin(), sheets.end(),
                       [&](const PrintedSheet& sheet) { return place_on(paper, sheet); });
}

// The smallest A format that takes every sheet.
const PaperFormat* smallest_for(const std::vector<PrintedSheet>& sheets) {
    for (const PaperFormat& paper : paper_formats()) {
        if (paper.name.starts_with('A') && takes_all(paper, sheets)) {
            return &paper;
        }
    }
    return nullptr;
}

std::string size_text(double width_mm, double height_mm) {
    char text[64];
    std::snprintf(text, sizeof text, "%.4g x %.4g mm", width_mm, height_mm);
    return text;
}

}  // namespace

const std::vector<PaperFormat>& paper_formats() {
    static const std::vector<PaperFormat> formats{
        {"A4", 210.0, 297.0},    {"A3", 297.0, 420.0},     {"A2", 420.0, 594.0},
        {"A1", 594.0, 841.0},    {"A0", 841.0, 1189.0},    {"letter", 215.9, 279.4},
        {"legal", 215.9, 355.6}, {"tabloid", 279.4, 431.8}};
    return formats;
}

Result<std::vector<PrintedSheet>> printed_sheets(const Target& target) {
    return std::visit([](const auto& kind) { return sheets_of(kind); }, target);
}

std::optional<SheetPlace> place_on(const PaperFormat& paper, const PrintedSheet& sheet) {
    for (const bool turned : {false, true}) {
        const double width = turned ? paper.height_mm : paper.width_mm;
        const double height = turned ? paper.width_mm : paper.height_mm;
        for (const bool strip_below : {true, false}) {
            if (const auto found = place(width, height, sheet, strip_below)) {
                return found;
            }
        }
    }
    return std::nullopt;
}

Result<PaperFormat> paper_for(const std::vector<PrintedSheet>& sheets, const std::string& name) {
    const PaperFormat* smallest = smallest_for(sheets);
    if (lower(name) == "auto" && smallest != nullptr) {
        return *smallest;
    }
    for (const PaperFormat& paper : paper_formats()) {
        const bool asked =
            lower(paper.name) == lower(name) || (lower(name) == "auto" && paper.name == "A0");
        if (!asked) {
            continue;
        }
        for (const PrintedSheet& sheet : sheets) {
            if (!place_on(paper, sheet)) {
                return Error{
                    "A sheet of " + size_text(sheet.width_mm, sheet.height_mm) +
                        " with its ruler does not fit on " + paper.name + " (" +
                        size_text(paper.width_mm, paper.height_mm) + ") at its true size.",
                    smallest != nullptr
                        ? "Print it on " + smallest->name + ": --paper " + smallest->name + "."
                        : "Give the target smaller planes, or more of them."};
            }
        }
        return paper;
    }
    std::string known;
    for (const PaperFormat& paper : paper_formats()) {
        known += paper.name + ", ";
    }
    return Error{"There is no paper \"" + name + "\".", "Choose " + known + "or auto."};
}

}  // namespace kambara
