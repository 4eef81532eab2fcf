// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/printed_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "core/calibration/point_planes.h"
#include "core/calibration/target_pdf.h"

namespace kambara {
namespace {

constexpr double mm_per_unit = 25.4 / 72.0;

struct Rectangle {
    double left_mm, bottom_mm, width_mm, height_mm;
};

// A page's content as it stands in the file: numbers before each operator.
struct Page {
    double width_mm = 0.0;
    double height_mm = 0.0;
    std::vector<Rectangle> rectangles;
};

std::vector<Page> pages_of(const std::string& pdf) {
    std::vector<Page> pages;
    for (std::size_t at = pdf.find("/MediaBox"); at != std::string::npos;
         at = pdf.find("/MediaBox", at + 1)) {
        std::istringstream numbers(pdf.substr(pdf.find('[', at) + 1, 80));
        double x = 0.0;
        double y = 0.0;
        Page page;
        numbers >> x >> y >> page.width_mm >> page.height_mm;
        page.width_mm *= mm_per_unit;
        page.height_mm *= mm_per_unit;
        pages.push_back(page);
    }
    std::size_t number = 0;
    for (std::size_t at = pdf.find("\nstream"); at != std::string::npos && number < pages.size();
         at = pdf.find("\nstream", at + 1), ++number) {
        std::istringstream lines(pdf.substr(at + 1, pdf.find("endstream", at) - at));
        std::string line;
        while (std::getline(lines, line)) {
            std::istringstream words(line);
            Rectangle r{};
            std::string operation;
            if (words >> r.left_mm >> r.bottom_mm >> r.width_mm >> r.height_mm >> operation &&
                operation == "re") {
                pages[number].rectangles.push_back(
                    {r.left_mm * mm_per_unit, r.bottom_mm * mm_per_unit, r.width_mm * mm_per_unit,
                     r.height_mm * mm_per_unit});
            }
        }
    }
    return pages;
}

TEST(PrintedSheet, TheTwoPlaneTargetFillsTwoA3PagesAtItsTrueSize) {
    const auto pdf = target_pdf(two_plane_24());
    ASSERT_TRUE(pdf) << pdf.error().text();
    EXPECT_EQ(pdf->paper.name, "A3");
    const auto pages = pages_of(pdf->bytes);
    ASSERT_EQ(pages.size(), 2U);
    for (const Page& page : pages) {
        EXPECT_NEAR(page.width_mm, 297.0, 0.01);
        EXPECT_NEAR(page.height_mm, 420.0, 0.01);
        ASSERT_EQ(page.rectangles.size(), 12U);
        const Rectangle& first = page.rectangles.front();
        for (std::size_t i = 0; i < 12; ++i) {
            const Rectangle& box = page.rectangles[i];
            EXPECT_NEAR(box.width_mm, 50.0, 0.001);
            EXPECT_NEAR(box.height_mm, 70.0, 0.001);
            EXPECT_NEAR(box.left_mm - first.left_mm, 75.0 * static_cast<double>(i % 3), 0.001);
            EXPECT_NEAR(first.bottom_mm - box.bottom_mm, 95.0 * static_cast<double>(i / 3), 0.001);
            EXPECT_GT(box.left_mm, paper_margin_mm);
            EXPECT_GT(box.bottom_mm, paper_margin_mm);
        }
    }
    // The cut at the shared edge: 25 mm beside the boxes on either plane.
    EXPECT_NEAR(pages[0].rectangles[2].left_mm + 50.0 + 25.0,
                pdf->places[0].left_mm + pdf->sheets[0].width_mm, 0.001);
    EXPECT_NEAR(pages[1].rectangles[0].left_mm - 25.0, pdf->places[1].left_mm, 0.001);
    EXPECT_NE(pdf->bytes.find("/PrintScaling"), std::string::npos);
}

TEST(PrintedSheet, ASheetThatDoesNotFitIsRefusedWithThePaperThatWouldDo) {
    const auto pdf = target_pdf(two_plane_24(), "A4");
    ASSERT_FALSE(pdf);
    EXPECT_NE(pdf.error().cause.find("does not fit on A4"), std::string::npos);
    EXPECT_NE(pdf.error().remedy.find("A3"), std::string::npos);
    EXPECT_FALSE(target_pdf(two_plane_24(), "letter"));
    EXPECT_TRUE(target_pdf(two_plane_24(), "a2"));
    EXPECT_NE(target_pdf(two_plane_24(), "B5").error().remedy.find("tabloid"), std::string::npos);
    const auto vast = target_pdf(ChessboardTarget{30, 30, 100.0});
    ASSERT_FALSE(vast);
    EXPECT_NE(vast.error().cause.find("A0"), std::string::npos);
}

TEST(PrintedSheet, PaperIsTurnedAsThePatternNeeds) {
    const auto wide = target_pdf(ChessboardTarget{9, 6, 25.0});
    ASSERT_TRUE(wide) << wide.error().text();
    EXPECT_EQ(wide->paper.name, "A4");
    EXPECT_GT(wide->places[0].paper_width_mm, wide->places[0].paper_height_mm);
    const auto high = target_pdf(ChessboardTarget{6, 9, 25.0});
    ASSERT_TRUE(high) << high.error().text();
    EXPECT_LT(high->places[0].paper_width_mm, high->places[0].paper_height_mm);
    EXPECT_EQ(target_pdf(ChessboardTarget{9, 6, 30.0})->paper.name, "A3");
}

// Any sheet and paper: inside the margins, and clear of the strip.
TEST(PrintedSheet, NothingLeavesThePaperOrRunsIntoTheRuler) {
    for (const PaperFormat& paper : paper_formats()) {
        int fit = 0;
        for (double width = 20.0; width < 1300.0; width += 37.0) {
            for (double height = 20.0; height < 1300.0; height += 41.0) {
                const PrintedSheet sheet{width, height, false, false, 10.0, {}};
                const auto at = place_on(paper, sheet);
                if (!at) {
                    continue;
                }
                ++fit;
                const double right = at->paper_width_mm - at->left_mm - width;
                const double below = at->paper_height_mm - at->top_mm - height;
                const double strip = paper_margin_mm + strip_mm;
                EXPECT_GE(at->left_mm, 10.0 - 1e-9);
                EXPECT_GE(at->top_mm, 10.0 - 1e-9);
                EXPECT_GE(right, 10.0 + (at->strip_below ? 0.0 : strip) - 1e-9);
                EXPECT_GE(below, 10.0 + (at->strip_below ? strip : 0.0) - 1e-9);
            }
        }
        EXPECT_GT(fit, 10) << paper.name;
    }
}

TEST(PrintedSheet, MarksArePrintedWhereTheFileHasThem) {
    BoxTarget target = two_plane_24();
    target.marks = {{1, 62.5, 177.5, 14.0}};
    const auto sheets = printed_sheets(target);
    ASSERT_TRUE(sheets);
    ASSERT_EQ((*sheets)[1].parts.size(), 13U);
    const SheetPart& mark = (*sheets)[1].parts.back();
    EXPECT_EQ(mark.kind, SheetPart::Kind::disc);
    // The second plane's boxes begin 25 mm from its edges.
    EXPECT_NEAR(mark.left_mm + 0.5 * mark.width_mm, 25.0 + 62.5, 1e-9);
    EXPECT_NEAR(mark.top_mm + 0.5 * mark.height_mm, 25.0 + 177.5, 1e-9);
    target.marks.front().across_mm = -80.0;
    EXPECT_NE(printed_sheets(target).error().cause.find("mark"), std::string::npos);
}

TEST(PrintedSheet, EveryPlaneOfAnyNumberGetsItsPage) {
    BoxTarget target;
    target.box_width_mm = 20.0;
    target.box_height_mm = 30.0;
    target.pitch_across_mm = 30.0;
    target.pitch_down_mm = 40.0;
    target.margin_mm = 10.0;
    target.planes = {{2, 180.0, 0.0, 12.0}, {1, 120.0, 8.0, 14.0}, {3, 180.0, 16.0, 0.0}};
    target.dark_on_light = false;
    const auto sheets = printed_sheets(target);
    ASSERT_TRUE(sheets) << sheets.error().text();
    ASSERT_EQ(sheets->size(), 3U);
    const double widths[] = {10.0 + 50.0 + 12.0, 8.0 + 20.0 + 14.0, 16.0 + 80.0 + 10.0};
    const std::size_t boxes[] = {8, 4, 12};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR((*sheets)[i].width_mm, widths[i], 1e-9);
        EXPECT_EQ((*sheets)[i].parts.size(), boxes[i]);
        EXPECT_TRUE((*sheets)[i].dark);
    }
}

TEST(PrintedSheet, FreePointsGoOntoTheirPlanes) {
    PointTarget target;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column) {
            target.points_mm.emplace_back(40.0 * column, 35.0 * row, 0.0);
        }
        target.points_mm.emplace_back(80.0, 35.0 * row, -30.0);
        target.points_mm.emplace_back(80.0, 35.0 * row, -60.0);
    }
    const auto planes = planes_of(target.points_mm);
    ASSERT_EQ(planes.size(), 2U);
    EXPECT_EQ(planes[0].points.size(), 12U);
    EXPECT_EQ(planes[1].points.size(), 12U);  // the edge's points are on both
    EXPECT_TRUE(planes[0].across.isApprox(Eigen::Vector3d::UnitX(), 1e-9));
    // The right plane runs towards the viewer, as a box target's does.
    EXPECT_TRUE(planes[1].across.isApprox(-Eigen::Vector3d::UnitZ(), 1e-9));
    for (const PointPlane& plane : planes) {
        EXPECT_TRUE(plane.down.isApprox(Eigen::Vector3d::UnitY(), 1e-9));
    }
    const auto sheets = printed_sheets(target);
    ASSERT_TRUE(sheets);
    // Distances between printed points are those of the target.
    for (const PrintedSheet& sheet : *sheets) {
        for (const SheetPart& a : sheet.parts) {
            for (const SheetPart& b : sheet.parts) {
                const auto& points = target.points_mm;
                EXPECT_NEAR(std::hypot(a.left_mm - b.left_mm, a.top_mm - b.top_mm),
                            (points[std::stoul(a.label)] - points[std::stoul(b.label)]).norm(),
                            1e-9);
            }
        }
    }
    target.points_mm.emplace_back(500.0, 20.0, 77.0);
    EXPECT_NE(printed_sheets(target).error().cause.find("plane"), std::string::npos);
}

TEST(PrintedSheet, TheSameTargetGivesTheSameFile) {
    EXPECT_EQ(target_pdf(CharucoTarget{})->bytes, target_pdf(CharucoTarget{})->bytes);
}

}  // namespace
}  // namespace kambara
