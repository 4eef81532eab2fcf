// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace kambara {
namespace {

constexpr int bar_height = 16;
constexpr int bar_step = 20;
constexpr int label_width = 170;
constexpr int bars_width = 420;
constexpr int value_width = 110;

constexpr const char* style =
    "body{font:15px/1.5 sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#1c2733}"
    "h1{font-size:1.6em}h2{font-size:1.2em;margin-top:2em}"
    "table{border-collapse:collapse;margin:1em 0}"
    "th,td{padding:.2em .8em;border-bottom:1px solid #d5dce3;text-align:right}"
    "th:first-child,td:first-child{text-align:left}"
    "svg{display:block;margin:1em 0;font:12px sans-serif}";

std::string number(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return text;
}

}  // namespace

std::string html_escaped(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

HtmlReport::HtmlReport(std::string_view title) : title_(html_escaped(title)) {}

void HtmlReport::heading(std::string_view text) {
    body_ += "<h2>" + html_escaped(text) + "</h2>\n";
}

void HtmlReport::paragraph(std::string_view text) {
    body_ += "<p>" + html_escaped(text) + "</p>\n";
}

void HtmlReport::table(const std::vector<std::string>& header,
                       const std::vector<std::vector<std::string>>& rows) {
    const auto add = [this](const std::vector<std::string>& cells, const char* tag) {
        body_ += "<tr>";
        for (const std::string& cell : cells) {
            body_ += std::string("<") + tag + ">" + html_escaped(cell) + "</" + tag + ">";
        }
        body_ += "</tr>\n";
    };
    body_ += "<table>\n";
    add(header, "th");
    for (const auto& row : rows) {
        add(row, "td");
    }
    body_ += "</table>\n";
}

void HtmlReport::bars(std::string_view title, std::string_view unit, const std::vector<Bar>& bars,
                      int decimals) {
    double most = 0.0;
    for (const Bar& bar : bars) {
        most = std::max(most, std::isfinite(bar.value) ? bar.value : 0.0);
    }
    const int height = static_cast<int>(bars.size()) * bar_step + 30;
    const int width = label_width + bars_width + value_width;
    body_ += "<svg width=\"" + std::to_string(width) + "\" height=\"" + std::to_string(height) +
             "\" role=\"img\"><text x=\"0\" y=\"14\" font-weight=\"bold\">" + html_escaped(title) +
             "</text>\n";
    int y = 26;
    for (const Bar& bar : bars) {
        const bool known = std::isfinite(bar.value);
        const double length = known && most > 0.0 ? bars_width * bar.value / most : 0.0;
        body_ += "<text x=\"" + std::to_string(label_width - 8) + "\" y=\"" +
                 std::to_string(y + 12) + "\" text-anchor=\"end\">" + html_escaped(bar.label) +
                 "</text><rect x=\"" + std::to_string(label_width) + "\" y=\"" + std::to_string(y) +
                 "\" width=\"" + number(std::max(length, 0.0), 1) + "\" height=\"" +
                 std::to_string(bar_height) + "\" fill=\"" + (bar.marked ? "#c4502b" : "#2f6f9f") +
                 "\"/><text x=\"" + number(label_width + std::max(length, 0.0) + 6.0, 1) +
                 "\" y=\"" + std::to_string(y + 12) + "\">" +
                 (known ? number(bar.value, decimals) + " " + html_escaped(unit) : "-") +
                 "</text>\n";
        y += bar_step;
    }
    body_ += "</svg>\n";
}

std::string HtmlReport::text() const {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>" + title_ +
           "</title><style>" + style + "</style></head>\n<body>\n<h1>" + title_ + "</h1>\n" +
           body_ + "</body>\n</html>\n";
}

}  // namespace kambara
