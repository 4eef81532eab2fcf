// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kambara {

/// A page of results in one HTML file that needs no other: headings, paragraphs, tables, bar,
/// point and line charts (as inline SVG), one after the other as they are added. All text is
/// escaped.
class HtmlReport {
  public:
    explicit HtmlReport(std::string_view title);

    void heading(std::string_view text);
    void paragraph(std::string_view text);
    /// The first column to the left, the others, numbers for the most part, to the right.
    void table(const std::vector<std::string>& header,
               const std::vector<std::vector<std::string>>& rows);

    /// A table as a map: each cell but the first of its row is the darker, the larger the number
    /// that its text begins with is among them all; the largest is the darkest.
    void shaded_table(const std::vector<std::string>& header,
                      const std::vector<std::vector<std::string>>& rows);

    struct Bar {
        std::string label;
        double value = 0.0;
        bool marked = false;  ///< drawn in the second colour
    };
    /// Bars from 0 on, one below the other, with their values; `unit` stands behind each.
    void bars(std::string_view title, std::string_view unit, const std::vector<Bar>& bars,
              int decimals);

    struct Point {
        double x = 0.0;
        double y = 0.0;
        double share = 0.0;  ///< of all there is: the area it is drawn with
    };
    /// Points in a square whose axes run from 0 to 1, with its diagonal: what was said, across,
    /// beside what turned out, upwards.
    void unit_square(std::string_view title, std::string_view across, std::string_view up,
                     const std::vector<Point>& points);

    struct Series {
        std::string label;
        std::vector<Point> points;  ///< a gap where a number is not finite; `share` is not used
    };
    /// Lines over x, which runs from 0 to the largest there is, and y, from 0 to `top`. At most
    /// eight are told apart by their colours; the labels stand to the right.
    void lines(std::string_view title, std::string_view across, std::string_view up, double top,
               const std::vector<Series>& series);

    /// Points of several kinds over axes that fit around them, of either sign, with a line at zero;
    /// the labels stand to the right. At most eight are told apart by their colours.
    void scatter(std::string_view title, std::string_view across, std::string_view up,
                 const std::vector<Series>& series);

    struct Arrow {
        double x = 0.0;
        double y = 0.0;
        double dx = 0.0;
        double dy = 0.0;
        bool marked = false;  ///< drawn in the second colour
    };
    /// Arrows in a picture of width x height, x to the right and y down, each `stretch` times as
    /// long as it is: what is off, and where.
    void picture_arrows(std::string_view title, double width, double height, double stretch,
                        const std::vector<Arrow>& arrows);

    std::string text() const;

  private:
    void add_table(const std::vector<std::string>& header,
                   const std::vector<std::vector<std::string>>& rows, double most);

    std::string title_;
    std::string body_;
};

/// The text with the characters that mean something in HTML written as entities.
std::string html_escaped(std::string_view text);

}  // namespace kambara
