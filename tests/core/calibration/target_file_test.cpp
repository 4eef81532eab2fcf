// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target_file.h"

#include <gtest/gtest.h>

namespace kambara {
namespace {

std::vector<Target> samples() {
    BoxTarget marked = two_plane_24();
    marked.dark_on_light = false;
    marked.marks = {{1, 60.0, 82.5, 12.0}};
    marked.accuracy = {0.03, {{7, {1.25, -2.5, 0.1}, 0.005}, {0, {0.01, 0.02, 0.03}, 0.006}}};
    return {two_plane_24(), marked, ChessboardTarget{7, 5, 25.4}, CharucoTarget{},
            PointTarget{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1.5}}, {0.1, {}}}};
}

TEST(TargetFile, WhatIsWrittenReadsBackTheSame) {
    for (const Target& target : samples()) {
        const auto again = target_from_text(target_to_text(target));
        ASSERT_TRUE(again) << again.error().text() << target_to_text(target);
        EXPECT_EQ(*again, target) << target_to_text(target);
    }
}

TEST(TargetFile, FaultsAreNamed) {
    const std::string good = target_to_text(two_plane_24());
    const auto spoiled = [&good](const std::string& from, const std::string& to) {
        std::string text = good;
        text.replace(text.find(from), from.size(), to);
        const auto target = target_from_text(text);
        EXPECT_FALSE(target) << text;
        return target ? std::string() : target.error().cause;
    };
    EXPECT_NE(spoiled("kambara_target: 1", "kambara_target: 2").find("version"), std::string::npos);
    EXPECT_NE(spoiled("length: mm", "length: m").find("units.length"), std::string::npos);
    EXPECT_NE(spoiled("box_mm: [50, 70]", "box_mm: [50]").find("box_mm"), std::string::npos);
    EXPECT_NE(spoiled("box_mm: [50, 70]", "box_mm: [80, 70]").find("touch"), std::string::npos);
    EXPECT_NE(spoiled("rows: 4", "rows: 4.5").find("whole"), std::string::npos);
    EXPECT_NE(spoiled("rows: 4", "rows: many").find("rows"), std::string::npos);
    EXPECT_NE(spoiled("kind: boxes", "kind: balls").find("balls"), std::string::npos);
    for (const char* text : {"", "{", "[]", "kambara_target: 1", "a: [b"}) {
        EXPECT_FALSE(target_from_text(text)) << text;
    }
}

TEST(TargetFile, AMissingFileIsSaid) {
    const auto target = parse_target("no-such-target.yaml");
    ASSERT_FALSE(target);
    EXPECT_NE(target.error().cause.find("no-such-target.yaml"), std::string::npos);
}

}  // namespace
}  // namespace kambara
