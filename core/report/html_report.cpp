// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html_report.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "core/report/chart_axis.h"
#include "core/report/chart_parts.h"

namespace kambara {
namespace {

constexpr int bar_height = 16;
constexpr int bar_step = 20;
constexpr int least_label_width = 170;
constexpr int bars_width = 420;
constexpr int value_width = 110;
constexpr double square_side = 260.0;
constexpr double square_left = 56.0;
constexpr double square_top = 30.0;

constexpr double darkest = 0.55;  // opacity; the text stays readable on it

constexpr double lines_width = 460.0;
constexpr double lines_height = 240.0;

constexpr const char* style =
    "body{font:15px/1.5 sans-serif;max-width:62em;margin:2em auto;padding:0 1em;color:#1c2733}"
    "h1{font-size:1.6em}h2{font-size:1.2em;margin-top:2em}"
    "table{border-collapse:collapse;margin:1em 0}"
    "th,td{padding:.2em .8em;border-bottom:1px solid #d5dce3;text-align:right}"
    "th:first-child,td:first-child{text-align:left}"
    "svg{display:block;margin:1em 0;font:12px sans-serif}";

// 0 where the text begins with none, or with a negative one.
double leading_number(const std::string& text) {
    const double value = std::strtod(text.c_str(), nullptr);
    return std::isfinite(value) && value > 0.0 ? value : 0.0;
}

}  // namespace

std::string fixed_text(double value, int decimals) {
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value == 0.0 ? 0.0 : value);
    return text;
}

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
    add_table(header, rows, 0.0);
}

void HtmlReport::shaded_table(const std::vector<std::string>& header,
                              const std::vector<std::vector<std::string>>& rows) {
    double most = 0.0;
    for (const auto& row : rows) {
        for (std::size_t i = 1; i < row.size(); ++i) {
            most = std::max(most, leading_number(row[i]));
        }
    }
    add_table(header, rows, most);
}

// Cells are shaded where `most`, the number of the darkest, is above 0.
void HtmlReport::add_table(const std::vector<std::string>& header,
                           const std::vector<std::vector<std::string>>& rows, double most) {
    body_ += "<table>\n<tr>";
    for (const std::string& cell : header) {
        body_ += "<th>" + html_escaped(cell) + "</th>";
    }
    body_ += "</tr>\n";
    for (const auto& row : rows) {
        body_ += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i) {
            body_ += i > 0 && most > 0.0
                         ? "<td style=\"background:rgba(44,111,165," +
                               fixed_text(darkest * leading_number(row[i]) / most, 2) + ")\">"
                         : "<td>";
            body_ += html_escaped(row[i]) + "</td>";
        }
        body_ += "</tr>\n";
    }
    body_ += "</table>\n";
}

void HtmlReport::bars(std::string_view title, std::string_view unit, const std::vector<Bar>& bars,
                      int decimals) {
    double most = 0.0;
    int label_width = least_label_width;
    for (const Bar& bar : bars) {
        most = std::max(most, std::isfinite(bar.value) ? bar.value : 0.0);
        label_width = std::max(label_width, 16 + static_cast<int>(text_width(bar.label.size())));
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
                 "\" width=\"" + fixed_text(std::max(length, 0.0), 1) + "\" height=\"" +
                 std::to_string(bar_height) + "\" fill=\"" + (bar.marked ? "#c4502b" : "#2f6f9f") +
                 "\"/><text x=\"" + fixed_text(label_width + std::max(length, 0.0) + 6.0, 1) +
                 "\" y=\"" + std::to_string(y + 12) + "\">" +
                 (known ? fixed_text(bar.value, decimals) + " " + html_escaped(unit) : "-") +
                 "</text>\n";
        y += bar_step;
    }
    body_ += "</svg>\n";
}

void HtmlReport::unit_square(std::string_view title, std::string_view across, std::string_view up,
                             const std::vector<Point>& points) {
    const auto x_of = [](double x) { return fixed_text(square_left + square_side * x, 1); };
    const auto y_of = [](double y) { return fixed_text(square_top + square_side * (1.0 - y), 1); };
    const auto line = [&](double x1, double y1, double x2, double y2, const char* colour) {
        body_ += "<line x1=\"" + x_of(x1) + "\" y1=\"" + y_of(y1) + "\" x2=\"" + x_of(x2) +
                 "\" y2=\"" + y_of(y2) + "\" stroke=\"" + colour + "\"/>";
    };
    const auto text = [&](double x, double y, const std::string& more, std::string_view what) {
        body_ += "<text x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(y, 1) + "\"" + more +
                 ">" + html_escaped(what) + "</text>";
    };
    const double bottom = square_top + square_side;
    body_ += "<svg width=\"" + fixed_text(square_left + square_side + 20, 0) + "\" height=\"" +
             fixed_text(bottom + 44, 0) + "\" role=\"img\">";
    text(0, 14, " font-weight=\"bold\"", title);
    for (const double mark : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
        line(mark, 0.0, mark, 1.0, "#e4e9ee");
        line(0.0, mark, 1.0, mark, "#e4e9ee");
        text(square_left + square_side * mark, bottom + 16, " text-anchor=\"middle\"",
             fixed_text(mark, 1));
        text(square_left - 8, square_top + square_side * (1.0 - mark) + 4, " text-anchor=\"end\"",
             fixed_text(mark, 1));
    }
    line(0.0, 0.0, 1.0, 1.0, "#8796a5");
    text(square_left + 0.5 * square_side, bottom + 34, " text-anchor=\"middle\"", across);
    const std::string middle = fixed_text(square_top + 0.5 * square_side, 1);
    text(14, square_top + 0.5 * square_side,
         " text-anchor=\"middle\" transform=\"rotate(-90 14 " + middle + ")\"", up);
    for (const Point& point : points) {
        if (std::isfinite(point.x) && std::isfinite(point.y)) {
            const double radius = 3.0 + 18.0 * std::sqrt(std::clamp(point.share, 0.0, 1.0));
            body_ += "<circle cx=\"" + x_of(point.x) + "\" cy=\"" + y_of(point.y) + "\" r=\"" +
                     fixed_text(radius, 1) + "\" fill=\"#2f6f9f\" fill-opacity=\".7\"/>";
        }
    }
    body_ += "</svg>\n";
}

void HtmlReport::lines(std::string_view title, std::string_view across, std::string_view up,
                       double top, const std::vector<Series>& series) {
    double farthest = 0.0;
    for (const Series& one : series) {
        for (const Point& point : one.points) {
            farthest = std::max(farthest, std::isfinite(point.x) ? point.x : 0.0);
        }
    }
    const ChartAxis x_axis = axis_of(0.0, std::max(farthest, 1e-9));
    const ChartAxis y_axis = axis_of(0.0, top);
    const double bottom = square_top + lines_height;
    const double right = square_left + lines_width;
    const auto x_of = [&](double x) {
        return fixed_text(square_left + lines_width * x_axis.share(x), 1);
    };
    const auto y_of = [&](double y) {
        return fixed_text(bottom - lines_height * y_axis.share(y), 1);
    };
    const auto text = [&](const std::string& x, const std::string& y, const std::string& more,
                          std::string_view what) {
        body_ +=
            "<text x=\"" + x + "\" y=\"" + y + "\"" + more + ">" + html_escaped(what) + "</text>";
    };
    body_ += "<svg width=\"" + fixed_text(right + legend_width(series), 0) + "\" height=\"" +
             fixed_text(bottom + 44, 0) + "\" role=\"img\">";
    text("0", "14", " font-weight=\"bold\"", title);
    for (const double mark : x_axis.marks()) {
        text(x_of(mark), fixed_text(bottom + 16, 1), " text-anchor=\"middle\"",
             fixed_text(mark, x_axis.decimals));
    }
    for (const double mark : y_axis.marks()) {
        body_ += "<line x1=\"" + fixed_text(square_left, 1) + "\" y1=\"" + y_of(mark) + "\" x2=\"" +
                 fixed_text(right, 1) + "\" y2=\"" + y_of(mark) + "\" stroke=\"#e4e9ee\"/>";
        text(fixed_text(square_left - 8, 1), y_of(mark), " dy=\"4\" text-anchor=\"end\"",
             fixed_text(mark, y_axis.decimals));
    }
    text(fixed_text(square_left + 0.5 * lines_width, 1), fixed_text(bottom + 34, 1),
         " text-anchor=\"middle\"", across);
    const std::string middle = fixed_text(square_top + 0.5 * lines_height, 1);
    text("14", middle, " text-anchor=\"middle\" transform=\"rotate(-90 14 " + middle + ")\"", up);
    double label_y = square_top + 10.0;
    for (std::size_t i = 0; i < series.size(); ++i) {
        const std::string colour = series_colours[i % std::size(series_colours)];
        std::string path;
        bool drawing = false;
        for (const Point& point : series[i].points) {
            const bool known = std::isfinite(point.x) && std::isfinite(point.y);
            if (known) {
                path.append(drawing ? "L" : "M")
                    .append(x_of(point.x))
                    .append(" ")
                    .append(y_of(point.y));
                body_.append("<circle cx=\"")
                    .append(x_of(point.x))
                    .append("\" cy=\"")
                    .append(y_of(point.y))
                    .append("\" r=\"3\" fill=\"")
                    .append(colour)
                    .append("\"/>");
            }
            drawing = known;
        }
        // The later, the thinner: of two lines in one place both are seen.
        const double thickness = 2.0 + 1.5 * static_cast<double>(series.size() - 1 - i);
        body_ += "<path d=\"" + path + "\" fill=\"none\" stroke=\"" + colour +
                 "\" stroke-width=\"" + fixed_text(thickness, 1) + "\"/>";
        text(fixed_text(right + 14, 1), fixed_text(label_y, 1), " fill=\"" + colour + "\"",
             series[i].label);
        label_y += 18.0;
    }
    body_ += "</svg>\n";
}

void HtmlReport::picture_arrows(std::string_view title, double width, double height, double stretch,
                                const std::vector<Arrow>& arrows) {
    const double scale = 640.0 / std::max(width, 1.0);
    const double top = 24.0;
    body_ += "<svg width=\"642\" height=\"" + fixed_text(top + scale * height + 2.0, 0) +
             "\" role=\"img\"><text x=\"0\" y=\"14\" font-weight=\"bold\">" + html_escaped(title) +
             "</text><rect x=\"1\" y=\"" + fixed_text(top, 0) + "\" width=\"640\" height=\"" +
             fixed_text(scale * height, 1) + "\" fill=\"none\" stroke=\"#8796a5\"/>\n";
    for (const Arrow& arrow : arrows) {
        const double x = 1.0 + scale * (arrow.x + 0.5);
        const double y = top + scale * (arrow.y + 0.5);
        const std::string colour = arrow.marked ? "#c4502b" : "#2f6f9f";
        body_ += "<circle cx=\"" + fixed_text(x, 1) + "\" cy=\"" + fixed_text(y, 1) +
                 "\" r=\"1.2\" fill=\"" + colour + "\"/>";
        if (std::isfinite(arrow.dx) && std::isfinite(arrow.dy)) {
            body_ += "<line x1=\"" + fixed_text(x, 1) + "\" y1=\"" + fixed_text(y, 1) + "\" x2=\"" +
                     fixed_text(x + scale * stretch * arrow.dx, 1) + "\" y2=\"" +
                     fixed_text(y + scale * stretch * arrow.dy, 1) + "\" stroke=\"" + colour +
                     "\"/>\n";
        }
    }
    body_ += "</svg>\n";
}

std::string HtmlReport::text() const {
    return "<!DOCTYPE html>\n<html lang=\"en\">\n<head><meta charset=\"utf-8\"><title>" + title_ +
           "</title><style>" + style + "</style></head>\n<body>\n<h1>" + title_ + "</h1>\n" +
           body_ + "</body>\n</html>\n";
}

}  // namespace kambara
