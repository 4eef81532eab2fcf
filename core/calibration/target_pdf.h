// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/result.h"
#include "core/calibration/printed_sheet.h"
#include "core/calibration/target.h"

namespace kambara {

/// A target as a document to print.
struct TargetPdf {
    std::string bytes;  ///< the PDF file; the same for the same target
    PaperFormat paper;
    std::vector<PrintedSheet> sheets;  ///< a page each, in this order
    std::vector<SheetPlace> places;
};

/// The target at its true size (one PDF unit is 25.4 / 72 mm), a page a plane, each with a ruler
/// and a length of the target to check the print by, and marks to cut along where planes meet. The
/// pages ask viewers not to scale them. `paper` as in paper_for. Refuses what can't be printed or
/// does not fit. Any thread.
Result<TargetPdf> target_pdf(const Target& target, const std::string& paper = "auto");

}  // namespace kambara
