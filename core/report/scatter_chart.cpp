// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/report/chart_axis.h"
#include "core/report/chart_parts.h"
#include "core/report/html_report.h"

namespace kambara {
namespace {

constexpr double width = 460.0;
constexpr double height = 260.0;
constexpr double left = 70.0;
constexpr double top = 30.0;

std::string text_at(double x, double y, const std::string& more, std::string_view what) {
    return "<text x=\"" + fixed_text(x, 1) + "\" y=\"" + fixed_text(y, 1) + "\"" + more + ">" +
           html_escaped(what) + "</text>";
}

}  // namespace

void HtmlReport::scatter(std::string_view title, std::string_view across, std::string_view up,
                         const std::vector<Series>& series) {
    double range[4] = {HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
    const auto known = [](const Point& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    for (const Series& one : series) {
        for (const Point& point : one.points) {
            if (known(point)) {
                range[0] = std::min(range[0], point.x);
                range[1] = std::max(range[1], point.x);
                range[2] = std::min(range[2], point.y);
                range[3] = std::max(range[3], point.y);
            }
        }
    }
    if (range[0] > range[1]) {
        paragraph(std::string(title) + ": there are no points to draw.");
        return;
    }
    const ChartAxis x_axis = axis_of(range[0], range[1]);
    const ChartAxis y_axis = axis_of(range[2], range[3]);
    const auto x_of = [&](double x) { return left + width * x_axis.share(x); };
    const auto y_of = [&](double y) { return top + height * (1.0 - y_axis.share(y)); };
    const double bottom = top + height;
    const double right = left + width;
    body_ += "<svg width=\"" + fixed_text(right + legend_width(series), 0) + "\" height=\"" +
             fixed_text(bottom + 44, 0) + "\" role=\"img\">" +
             text_at(0, 14, " font-weight=\"bold\"", title);
    const auto grid = [&](double x1, double y1, double x2, double y2, bool zero) {
        body_ += "<line x1=\"" + fixed_text(x1, 1) + "\" y1=\"" + fixed_text(y1, 1) + "\" x2=\"" +
                 fixed_text(x2, 1) + "\" y2=\"" + fixed_text(y2, 1) + "\" stroke=\"" +
                 (zero ? "#8796a5" : "#e4e9ee") + "\"/>";
    };
    for (const double mark : x_axis.marks()) {
        grid(x_of(mark), top, x_of(mark), bottom, std::abs(mark) < 1e-6 * x_axis.step);
        body_ += text_at(x_of(mark), bottom + 16, " text-anchor=\"middle\"",
                         fixed_text(mark, x_axis.decimals));
    }
    for (const double mark : y_axis.marks()) {
        grid(left, y_of(mark), right, y_of(mark), std::abs(mark) < 1e-6 * y_axis.step);
        body_ += text_at(left - 8, y_of(mark) + 4, " text-anchor=\"end\"",
                         fixed_text(mark, y_axis.decimals));
    }
    body_ += text_at(left + 0.5 * width, bottom + 34, " text-anchor=\"middle\"", across);
    body_ += text_at(14, top + 0.5 * height,
                     " text-anchor=\"middle\" transform=\"rotate(-90 14 " +
                         fixed_text(top + 0.5 * height, 1) + ")\"",
                     up);
    for (std::size_t i = 0; i < series.size(); ++i) {
        const std::string colour = series_colours[i % std::size(series_colours)];
        for (const Point& point : series[i].points) {
            if (known(point)) {
                body_ += "<circle cx=\"" + fixed_text(x_of(point.x), 1) + "\" cy=\"" +
                         fixed_text(y_of(point.y), 1) + "\" r=\"3\" fill=\"" + colour +
                         "\" fill-opacity=\".75\"/>";
            }
        }
        const double y = top + 10.0 + 18.0 * static_cast<double>(i);
        body_ += "<circle cx=\"" + fixed_text(right + 16, 1) + "\" cy=\"" + fixed_text(y - 4, 1) +
                 "\" r=\"4\" fill=\"" + colour + "\"/>" +
                 text_at(right + 26, y, "", series[i].label);
    }
    body_ += "</svg>\n";
}

}  // namespace kambara
