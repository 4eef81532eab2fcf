// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/report/html_report.h"

#include <gtest/gtest.h>

#include <limits>

namespace kambara {
namespace {

TEST(HtmlReport, EscapesWhatIsWrittenAndKeepsTheOrder) {
    HtmlReport report("A < B & \"C\"");
    report.heading("First");
    report.paragraph("<script>alert(1)</script>");
    report.table({"name", "value"}, {{"a&b", "1"}, {"c", "2"}});
    const std::string text = report.text();
    EXPECT_NE(text.find("<title>A &lt; B &amp; &quot;C&quot;</title>"), std::string::npos);
    EXPECT_EQ(text.find("<script>"), std::string::npos);
    EXPECT_NE(text.find("<td>a&amp;b</td><td>1</td>"), std::string::npos);
    EXPECT_LT(text.find("First"), text.find("&lt;script"));
    EXPECT_LT(text.find("&lt;script"), text.find("<table>"));
}

TEST(HtmlReport, BarsAreAsLongAsTheirValues) {
    HtmlReport report("t");
    report.bars("speeds", "ms",
                {{"one", 10.0, false},
                 {"half", 5.0, true},
                 {"none", std::numeric_limits<double>::quiet_NaN(), false}},
                1);
    const std::string text = report.text();
    EXPECT_NE(text.find("width=\"420.0\""), std::string::npos);
    EXPECT_NE(text.find("width=\"210.0\""), std::string::npos);
    EXPECT_NE(text.find("10.0 ms"), std::string::npos);
    EXPECT_NE(text.find(">-</text>"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(HtmlReport, PointsLieWhereTheirCoordinatesSay) {
    HtmlReport report("t");
    report.unit_square(
        "kept promises", "said", "so",
        {{0.0, 0.0, 1.0}, {1.0, 0.5, 0.25}, {std::numeric_limits<double>::quiet_NaN(), 0.5, 0.1}});
    const std::string text = report.text();
    EXPECT_NE(text.find("<circle cx=\"56.0\" cy=\"290.0\" r=\"21.0\""), std::string::npos);
    EXPECT_NE(text.find("<circle cx=\"316.0\" cy=\"160.0\" r=\"12.0\""), std::string::npos);
    EXPECT_NE(text.find(">said</text>"), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

TEST(HtmlReport, AShadedTableIsDarkestWhereTheNumberIsLargest) {
    HtmlReport report("t");
    report.shaded_table({"", "a", "b"}, {{"9", "0.5 (7)", "2.0"}, {"8", "-", "nan"}});
    const std::string text = report.text();
    EXPECT_NE(text.find("<td>9</td>"), std::string::npos);
    EXPECT_NE(text.find(",0.14)\">0.5 (7)</td>"), std::string::npos);
    EXPECT_NE(text.find(",0.55)\">2.0</td>"), std::string::npos);
    EXPECT_NE(text.find(",0.00)\">-</td>"), std::string::npos);
}

// A picture of 320 px is drawn 640 wide; the arrow from its pixel (9.5, 4.5), ten times as long.
TEST(HtmlReport, ArrowsBeginWhereTheyBelongAndAreStretched) {
    HtmlReport report("r");
    report.picture_arrows("off", 320, 240, 10.0, {{9.5, 4.5, 0.5, -0.25}, {1, 1, 0, 0, true}});
    const std::string text = report.text();
    EXPECT_NE(text.find("<line x1=\"21.0\" y1=\"34.0\" x2=\"31.0\" y2=\"29.0\""),
              std::string::npos);
    EXPECT_NE(text.find("#c4502b"), std::string::npos);
}

}  // namespace
}  // namespace kambara
