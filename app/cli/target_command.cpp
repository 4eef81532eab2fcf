// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/target_command.h"

#include <nlohmann/json.hpp>

#include "core/base/text_file.h"
#include "core/calibration/target_pdf.h"

namespace kambara::cli {
namespace {

using Json = nlohmann::json;

Outcome failed(const Error& error) {
    return {error, Json{{"error", error.text()}}.dump(2), ""};
}

}  // namespace

Outcome run_target(const TargetOptions& options) {
    const auto target = parse_target(options.target);
    if (!target) {
        Outcome outcome = failed(target.error());
        outcome.wrong_usage = true;
        return outcome;
    }
    const auto pdf = target_pdf(*target, options.paper);
    if (!pdf) {
        return failed(pdf.error());
    }
    if (const auto written = write_text_file_atomically(options.out, pdf->bytes); !written) {
        return failed(written.error());
    }
    Json pages = Json::array();
    for (std::size_t i = 0; i < pdf->places.size(); ++i) {
        const SheetPlace& at = pdf->places[i];
        const PrintedSheet& sheet = pdf->sheets[i];
        pages.push_back({{"width_mm", at.paper_width_mm},
                         {"height_mm", at.paper_height_mm},
                         {"sheet_mm", {sheet.width_mm, sheet.height_mm}},
                         {"sheet_at_mm", {at.left_mm, at.top_mm}}});
    }
    const std::string count = std::to_string(pages.size());
    return {std::nullopt,
            Json{{"out", options.out.string()},
                 {"paper", pdf->paper.name},
                 {"paper_mm", {pdf->paper.width_mm, pdf->paper.height_mm}},
                 {"pages", pages}}
                .dump(2),
            to_string(*target) + ": " + count + (pages.size() == 1 ? " page " : " pages ") +
                pdf->paper.name + " in " + options.out.string() +
                ". Print it at 100 % and measure the ruler.\n"};
}

}  // namespace kambara::cli
