// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/head_kind.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "hardware/visca/built_in_heads.h"
#include "hardware/visca/measured_zoom.h"
#include "hardware/visca/position_estimate.h"

namespace kambara::visca {
namespace {

const HeadKind& head(const char* name) {
    static HeadKind found;
    found = find_head(built_in_heads(), std::string_view(name)).value();
    return found;
}

TEST(HeadKind, TheTableHoldsWhatTheManualsSay) {
    const HeadKind d30 = head("evi-d30");
    EXPECT_EQ(d30.pan.steps_from_deg(100.0), 0x370);
    EXPECT_EQ(d30.pan.steps_from_deg(-100.0), -880);
    EXPECT_EQ(d30.tilt.steps_from_deg(25.0), 300);
    EXPECT_EQ(d30.limits(), HeadLimits{});
    EXPECT_NEAR(deg_from_rad(d30.zoom.horizontal_view_rad(0.0)), 48.8, 0.1);
    EXPECT_NEAR(deg_from_rad(d30.zoom.horizontal_view_rad(0x3FF)), 4.4, 0.1);
    const HeadKind d70 = head("evi-d70");
    EXPECT_EQ(d70.pan.steps_from_deg(170.0), 2266);
    EXPECT_EQ(d70.tilt.steps_from_deg(90.0), 0x4B0);
    EXPECT_EQ(d70.tilt.steps_from_deg(-30.0), -400);
    EXPECT_NEAR(deg_from_rad(d70.limits().tilt_rad), 30.0, 1e-9) << "the same on both sides";
    EXPECT_EQ(head("evi-d80").pan.steps_from_deg(170.0), 0x1E1B);
    EXPECT_EQ(head("evi-d100").pan.steps_from_deg(100.0), 0x5A0);
    EXPECT_EQ(head("evi-d100").tilt.steps_from_deg(25.0), 0x168);
    const HeadKind brc = head("brc");
    EXPECT_EQ(brc.pan.steps_from_deg(-170.0), 0x08A58) << "left is positive";
    EXPECT_EQ(brc.pan.steps_from_deg(170.0), -0x08A58);
    EXPECT_NEAR(brc.pan.deg_from_steps(0x08A58), -170.0, 1e-3);
    EXPECT_EQ(brc.dialect().pan_nibbles, 5);
    EXPECT_EQ(brc.tilt.code_for(30.0), 0);
    EXPECT_EQ(head("ptzoptics").pan.steps_from_deg(170.0), 0x990);
    EXPECT_EQ(head("ptzoptics").tilt.steps_from_deg(90.0), 0x510);
    EXPECT_EQ(find_head(built_in_heads(), 0x402)->name, "evi-d30");
    EXPECT_EQ(find_head(built_in_heads(), 0x50D)->name, "evi-d80");
    EXPECT_FALSE(find_head(built_in_heads(), 0x999).has_value());
}

TEST(HeadKind, AWrittenTableIsReadBackAsItWas) {
    std::vector<HeadKind> heads = built_in_heads();
    heads[0].zoom.curve = {{0.0, 5.4}, {512.0, 17.123456}, {1023.0, 64.8}};
    const auto read = heads_from_text(heads_to_text(heads));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(*read, heads);
}

TEST(HeadKind, AMeasuredZoomTakesThePlaceOfWhatWasAssumed) {
    const auto measured =
        with_measured_zoom(head("evi-d30"), {{0.0, 1.0}, {0.5, 2.0}, {1.0, 11.5}});
    ASSERT_TRUE(measured) << measured.error().text();
    const auto widths = [&](double position) {
        return std::tan(0.5 * measured->zoom.horizontal_view_rad(0.0)) /
               std::tan(0.5 * measured->zoom.horizontal_view_rad(position));
    };
    EXPECT_NEAR(widths(512.0), 2.0, 1e-9);
    EXPECT_NEAR(widths(1023.0), 11.5, 1e-9);
    EXPECT_NEAR(widths(256.0), std::sqrt(2.0), 1e-9) << "straight in the logarithm";
    EXPECT_NEAR(measured->zoom.tele_f_mm, 5.4 * 11.5, 1e-9);
}

TEST(HeadKind, AnUnknownLensMustBeToldForItsMeasuredZoom) {
    EXPECT_FALSE(with_measured_zoom(head("evi-d70"), {{0.0, 1.0}, {1.0, 18.0}}));
    const auto told =
        with_measured_zoom(head("evi-d70"), {{0.0, 1.0}, {1.0, 18.0}}, WidestLens{4.1, 3.2});
    ASSERT_TRUE(told);
    EXPECT_NEAR(told->zoom.horizontal_view_rad(0.0), 2.0 * std::atan2(3.2, 8.2), 1e-12);
    EXPECT_NEAR(told->zoom.tele_f_mm, 4.1 * 18.0, 1e-9);
}

TEST(HeadKind, TheDocumentedExampleIsTheEviD30) {
    std::ifstream file(std::string(KAMBARA_SOURCE) + "/resources/README.md");
    const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const auto fence = page.find("```", page.find("<!-- example: heads -->"));
    ASSERT_NE(fence, std::string::npos);
    const auto begin = page.find('\n', fence) + 1;
    const auto heads = heads_from_text(page.substr(begin, page.find("```", begin) - begin));
    ASSERT_TRUE(heads.ok()) << heads.error().text();
    EXPECT_EQ(*heads, std::vector{built_in_heads()[0]});
}

TEST(HeadKind, NeverGoesBeyondItsEnds) {
    for (const HeadKind& model : built_in_heads()) {
        for (const AxisModel& axis : {model.pan, model.tilt}) {
            for (double deg = -400.0; deg < 400.0; deg += 0.37) {
                const double reached = axis.deg_from_steps(axis.steps_from_deg(deg));
                EXPECT_GE(reached, axis.least_deg - 1e-6) << model.name;
                EXPECT_LE(reached, axis.most_deg + 1e-6) << model.name;
                if (deg > axis.least_deg + 0.2 && deg < axis.most_deg - 0.2) {
                    EXPECT_NEAR(reached, deg, 0.5 / axis.steps_per_deg + 1e-9);
                }
            }
        }
    }
}

TEST(HeadKind, SpeedsHaveTheCodeBelow) {
    const AxisModel pan = head("evi-d30").pan;
    EXPECT_EQ(pan.code_for(80.0), 0x18);
    EXPECT_EQ(pan.code_for(-40.0), 12);
    EXPECT_EQ(pan.code_for(500.0), 0x18);
    EXPECT_EQ(pan.code_for(0.1), 1) << "never 0, which is no speed";
}

TEST(HeadKind, ATableNamesTheKeyAtFault) {
    const std::string good = built_in_heads_text();
    ASSERT_TRUE(heads_from_text(good).ok());
    const std::pair<const char*, const char*> faults[] = {
        {"version: 1", "version: 2"},
        {"presets: 6", "presets: many"},
        {"steps_per_deg: 8.8", "steps_per_deg: -8.8"},
        {"tele: 0x03FF", "tele: 0"},
        {"replaces_moves: true", "replaces_moves: 7.5"},
        {"models: [0x0402]", "models: 0x0402"},
        {"steps_per_deg: 8.8", "steps_per_deg: 800"},
    };
    for (const auto& [was, is] : faults) {
        std::string text = good;
        text.replace(text.find(was), std::string(was).size(), is);
        const auto read = heads_from_text(text);
        ASSERT_FALSE(read.ok()) << is;
        const std::string key = std::string(was).substr(0, std::string(was).find(':'));
        const bool names_it = read.error().cause.find(key) != std::string::npos ||
                              read.error().cause.find("pan") != std::string::npos;
        EXPECT_TRUE(names_it) << read.error().cause;
    }
    for (const char* text : {"", "[", "a: b", "heads: []", "\xFF\xFE"}) {
        EXPECT_FALSE(heads_from_text(text).ok()) << text;
    }
}

TEST(ZoomModel, FollowsAMeasuredCurve) {
    ZoomModel zoom;
    zoom.tele = 1000;
    zoom.sensor_width_mm = 4.0;
    EXPECT_EQ(zoom.horizontal_view_rad(10.0), 0.0) << "not known";
    zoom.curve = {{0.0, 5.0}, {500.0, 10.0}, {1000.0, 50.0}};
    EXPECT_NEAR(zoom.horizontal_view_rad(750.0), 2.0 * std::atan(2.0 / std::sqrt(500.0)), 1e-12)
        << "straight in the logarithm";
    EXPECT_NEAR(zoom.horizontal_view_rad(2000.0), 2.0 * std::atan(4.0 / 100.0), 1e-12);
}

TEST(PositionEstimate, MovesOnAndDoubtsWhatCannotBe) {
    constexpr std::int64_t ms = 1'000'000;
    PositionEstimate estimate;
    estimate.set_speeds(1.0, 0.5);
    EXPECT_FALSE(estimate.known());
    EXPECT_TRUE(estimate.add_reading({0.0, 0.0}, 0));
    EXPECT_FALSE(estimate.at(100 * ms).moving);
    estimate.set_target(HeadAngles{0.5, -0.1}, 100 * ms);
    EXPECT_NEAR(estimate.at(300 * ms).angles.pan_rad, 0.2, 1e-12);
    EXPECT_NEAR(estimate.at(300 * ms).angles.tilt_rad, -0.1, 1e-12);
    EXPECT_TRUE(estimate.at(300 * ms).moving);
    EXPECT_TRUE(estimate.add_reading({0.15, -0.05}, 300 * ms));
    EXPECT_NEAR(estimate.at(400 * ms).angles.pan_rad, 0.25, 1e-12);
    EXPECT_FALSE(estimate.add_reading({1.5, -0.1}, 400 * ms)) << "no motor turns so fast";
    EXPECT_NEAR(estimate.at(400 * ms).angles.pan_rad, 0.25, 1e-12);
    EXPECT_TRUE(estimate.add_reading({1.5, -0.1}, 500 * ms)) << "said twice";
    EXPECT_EQ(estimate.at(500 * ms).angles.pan_rad, 1.5);
    estimate.set_drive(-0.2, 0.0, 500 * ms);
    EXPECT_NEAR(estimate.at(1500 * ms).angles.pan_rad, 1.3, 1e-12);
    estimate.forget();
    EXPECT_FALSE(estimate.known());
}

}  // namespace
}  // namespace kambara::visca
