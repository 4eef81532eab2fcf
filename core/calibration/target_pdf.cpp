// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target_pdf.h"

#include <hpdf.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace kambara {
namespace {

constexpr double units_per_mm = 72.0 / 25.4;
constexpr double text_mm = 2.6;
constexpr double hairline_mm = 0.1;
constexpr double longest_ruler_mm = 200.0;
constexpr double cut_mark_mm = 5.0;

HPDF_REAL units(double mm) {
    return static_cast<HPDF_REAL>(mm * units_per_mm);
}

// Out of memory, or a call that can't be: nothing a user could mend.
void fail(HPDF_STATUS error, HPDF_STATUS detail, void*) {
    throw std::runtime_error("the PDF library gave up: " + std::to_string(error) + ", " +
                             std::to_string(detail));
}

// Draws on one page in mm from the top-left corner of a frame, right and down. The frame is the
// page itself, or a strip of it that reads upwards.
class Pen {
  public:
    Pen(HPDF_Page page, HPDF_Font font, double page_height_mm)
        : page_(page), font_(font), height_mm_(page_height_mm) {}

    // From here on the frame's x runs up the page from (x, y), y to the right.
    void turn_upwards(double x_mm, double y_mm) {
        HPDF_Page_Concat(page_, 0.0F, 1.0F, -1.0F, 0.0F, units(x_mm), units(height_mm_ - y_mm));
        height_mm_ = 0.0;
    }
    // ... or stays as it is, from (x, y).
    void move(double x_mm, double y_mm) {
        HPDF_Page_Concat(page_, 1.0F, 0.0F, 0.0F, 1.0F, units(x_mm), units(height_mm_ - y_mm));
        height_mm_ = 0.0;
    }

    void grey(double level) {
        HPDF_Page_SetGrayFill(page_, static_cast<HPDF_REAL>(level));
        HPDF_Page_SetGrayStroke(page_, static_cast<HPDF_REAL>(level));
    }
    void line(double x0, double y0, double x1, double y1) {
        HPDF_Page_SetLineWidth(page_, units(hairline_mm));
        HPDF_Page_MoveTo(page_, x(x0), y(y0));
        HPDF_Page_LineTo(page_, x(x1), y(y1));
        HPDF_Page_Stroke(page_);
    }
    void text(double left, double base, const std::string& words) {
        HPDF_Page_BeginText(page_);
        HPDF_Page_SetFontAndSize(page_, font_, units(text_mm));
        HPDF_Page_TextOut(page_, x(left), y(base), words.c_str());
        HPDF_Page_EndText(page_);
    }
    void centred_text(double middle, double base, const std::string& words) {
        text(middle - 0.5 * width_of(words), base, words);
    }
    double width_of(const std::string& words) {
        HPDF_Page_SetFontAndSize(page_, font_, units(text_mm));
        return static_cast<double>(HPDF_Page_TextWidth(page_, words.c_str())) / units_per_mm;
    }

    void rectangle(double left, double top, double width, double height) {
        HPDF_Page_Rectangle(page_, x(left), y(top + height), units(width), units(height));
    }
    // Each quarter of an ellipse as a cubic curve (four of them are 0.03 % of the radius off).
    void disc(double left, double top, double width, double height) {
        HPDF_Page_Ellipse(page_, x(left + 0.5 * width), y(top + 0.5 * height), units(0.5 * width),
                          units(0.5 * height));
    }
    // The quarters at the top left and at the bottom right.
    void point(double left, double top, double diameter) {
        const double radius = 0.5 * diameter;
        const double cx = left + radius;
        const double cy = top + radius;
        const double k = radius * 4.0 / 3.0 * (std::numbers::sqrt2 - 1.0);
        for (const double s : {-1.0, 1.0}) {
            HPDF_Page_MoveTo(page_, x(cx), y(cy));
            HPDF_Page_LineTo(page_, x(cx + s * radius), y(cy));
            HPDF_Page_CurveTo(page_, x(cx + s * radius), y(cy + s * k), x(cx + s * k),
                              y(cy + s * radius), x(cx), y(cy + s * radius));
            HPDF_Page_ClosePath(page_);
        }
    }
    void fill() { HPDF_Page_Fill(page_); }

  private:
    HPDF_REAL x(double mm) const { return units(mm); }
    HPDF_REAL y(double mm) const { return units(height_mm_ - mm); }

    HPDF_Page page_;
    HPDF_Font font_;
    double height_mm_;
};

void draw_parts(Pen& pen, const PrintedSheet& sheet, const SheetPlace& at) {
    if (sheet.dark) {
        pen.grey(0.0);
        pen.rectangle(at.left_mm, at.top_mm, sheet.width_mm, sheet.height_mm);
        pen.fill();
    }
    for (std::size_t i = 0; i < sheet.parts.size();) {
        // Parts of a colour in one path: filled by themselves, neighbours would show seams.
        const bool dark = sheet.parts[i].dark;
        pen.grey(dark ? 0.0 : 1.0);
        for (; i < sheet.parts.size() && sheet.parts[i].dark == dark; ++i) {
            const SheetPart& part = sheet.parts[i];
            const double left = at.left_mm + part.left_mm;
            const double top = at.top_mm + part.top_mm;
            switch (part.kind) {
                case SheetPart::Kind::rectangle:
                    pen.rectangle(left, top, part.width_mm, part.height_mm);
                    break;
                case SheetPart::Kind::disc:
                    pen.disc(left, top, part.width_mm, part.height_mm);
                    break;
                case SheetPart::Kind::point:
                    pen.point(left, top, part.width_mm);
                    break;
            }
        }
        pen.fill();
    }
    pen.grey(0.0);
    for (const SheetPart& part : sheet.parts) {
        if (!part.label.empty()) {
            pen.text(at.left_mm + part.left_mm + 0.5 * part.width_mm + 1.0,
                     at.top_mm + part.top_mm + 0.5 * part.height_mm - 1.0, part.label);
        }
    }
}

// Outside the corners, so that nothing of them is left on the sheet.
void draw_cut_marks(Pen& pen, const PrintedSheet& sheet, const SheetPlace& at) {
    if (!sheet.cut) {
        return;
    }
    pen.grey(0.0);
    const double right = at.left_mm + sheet.width_mm;
    const double bottom = at.top_mm + sheet.height_mm;
    const double gap = 1.0;
    for (const double x : {at.left_mm, right}) {
        pen.line(x, at.top_mm - gap, x, at.top_mm - cut_mark_mm);
        pen.line(x, bottom + gap, x, bottom + cut_mark_mm);
    }
    for (const double y : {at.top_mm, bottom}) {
        pen.line(at.left_mm - gap, y, at.left_mm - cut_mark_mm, y);
        pen.line(right + gap, y, right + cut_mark_mm, y);
    }
}

std::string number(double mm) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f", mm);
    return text;
}

// How far the printed parts reach: what can be measured on the target itself.
std::string extent_text(const PrintedSheet& sheet) {
    double left = sheet.width_mm;
    double top = sheet.height_mm;
    double right = 0.0;
    double bottom = 0.0;
    bool points = false;
    for (const SheetPart& part : sheet.parts) {
        // A point is measured from its middle.
        points = part.kind == SheetPart::Kind::point;
        const double inset = points ? 0.5 : 0.0;
        left = std::min(left, part.left_mm + inset * part.width_mm);
        top = std::min(top, part.top_mm + inset * part.height_mm);
        right = std::max(right, part.left_mm + (1.0 - inset) * part.width_mm);
        bottom = std::max(bottom, part.top_mm + (1.0 - inset) * part.height_mm);
    }
    return std::string(points ? "The outermost points span " : "The pattern is ") +
           number(right - left) + " mm wide and " + number(bottom - top) + " mm high.";
}

void draw_ruler(Pen& pen, double length_mm) {
    const int steps = static_cast<int>(std::lround(length_mm));
    pen.line(0.0, 0.0, length_mm, 0.0);
    for (int i = 0; i <= steps; ++i) {
        const double tick = i % 10 == 0 ? 4.0 : i % 5 == 0 ? 3.0 : 2.0;
        pen.line(i, 0.0, i, tick);
        if (i % 10 == 0) {
            pen.centred_text(i, 4.0 + text_mm, std::to_string(i));
        }
    }
}

// An arrow of 12 mm to the top of the page, in the strip's frame.
void draw_up_arrow(Pen& pen, double length_mm, bool strip_below) {
    const double x = length_mm - 2.0;
    if (strip_below) {
        pen.line(x, 12.0, x, 0.0);
        pen.line(x, 0.0, x - 1.5, 3.0);
        pen.line(x, 0.0, x + 1.5, 3.0);
        pen.text(x - 7.0, 7.0, "up");
    } else {
        pen.line(x - 10.0, 5.0, x + 2.0, 5.0);
        pen.line(x + 2.0, 5.0, x - 1.0, 3.5);
        pen.line(x + 2.0, 5.0, x - 1.0, 6.5);
        pen.text(x - 15.0, 6.0, "up");
    }
}

// In words as many as the strip takes: the second line may be long.
void draw_strip(Pen pen, const PrintedSheet& sheet, const SheetPlace& at, const std::string& name) {
    const double length_mm = (at.strip_below ? at.paper_width_mm : at.paper_height_mm) - 20.0;
    if (at.strip_below) {
        pen.move(10.0, at.paper_height_mm - paper_margin_mm - strip_mm);
    } else {
        pen.turn_upwards(at.paper_width_mm - paper_margin_mm - strip_mm, at.paper_height_mm - 10.0);
    }
    pen.grey(0.0);
    const double ruler_mm =
        std::min(longest_ruler_mm, 10.0 * std::floor((length_mm - 20.0) / 10.0));
    draw_ruler(pen, ruler_mm);
    pen.text(0.0, 11.5,
             name + ". Print at 100 % (\"actual size\"), then measure: this ruler is " +
                 number(ruler_mm) + " mm long.");
    pen.text(0.0, 15.0,
             extent_text(sheet) +
                 (sheet.cut ? " Cut the sheet along the marks at its corners: " +
                                  number(sheet.width_mm) + " x " + number(sheet.height_mm) + " mm."
                            : ""));
    draw_up_arrow(pen, length_mm, at.strip_below);
}

using Document = std::unique_ptr<std::remove_pointer_t<HPDF_Doc>, void (*)(HPDF_Doc)>;

std::string bytes_of(HPDF_Doc document) {
    HPDF_SaveToStream(document);
    std::string bytes(HPDF_GetStreamSize(document), '\0');
    HPDF_UINT32 size = static_cast<HPDF_UINT32>(bytes.size());
    HPDF_ReadFromStream(document, reinterpret_cast<HPDF_BYTE*>(bytes.data()), &size);
    bytes.resize(size);
    return bytes;
}

}  // namespace

Result<TargetPdf> target_pdf(const Target& target, const std::string& paper) {
    auto sheets = printed_sheets(target);
    if (!sheets) {
        return sheets.error();
    }
    const auto format = paper_for(*sheets, paper);
    if (!format) {
        return format.error();
    }
    const Document document(HPDF_New(fail, nullptr), [](HPDF_Doc it) { HPDF_Free(it); });
    HPDF_SetInfoAttr(document.get(), HPDF_INFO_CREATOR, "Kambara Vision");
    HPDF_SetInfoAttr(document.get(), HPDF_INFO_TITLE, to_string(target).c_str());
    HPDF_SetViewerPreference(document.get(), HPDF_PRINT_SCALING_NONE);
    const HPDF_Font font = HPDF_GetFont(document.get(), "Helvetica", "WinAnsiEncoding");
    TargetPdf pdf{{}, *format, std::move(*sheets), {}};
    for (std::size_t i = 0; i < pdf.sheets.size(); ++i) {
        const PrintedSheet& sheet = pdf.sheets[i];
        const SheetPlace at = place_on(pdf.paper, sheet).value();
        const HPDF_Page page = HPDF_AddPage(document.get());
        HPDF_Page_SetWidth(page, units(at.paper_width_mm));
        HPDF_Page_SetHeight(page, units(at.paper_height_mm));
        Pen pen(page, font, at.paper_height_mm);
        draw_parts(pen, sheet, at);
        draw_cut_marks(pen, sheet, at);
        std::string name = to_string(target);
        if (pdf.sheets.size() > 1) {
            name += ", plane " + std::to_string(i + 1) + " of " +
                    std::to_string(pdf.sheets.size()) + (sheet.cut ? " from the left" : "");
        }
        draw_strip(pen, sheet, at, name);
        pdf.places.push_back(at);
    }
    pdf.bytes = bytes_of(document.get());
    return pdf;
}

}  // namespace kambara
