// SPDX-License-Identifier: GPL-3.0-or-later
// Targets with round marks: any roll, any part with a mark in it, and nothing wrong.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include "core/calibration/box_detector.h"
#include "core/camera/nominal_rig.h"
#include "tests/support/box_scene.h"

namespace kambara {
namespace {

using testing_support::BoxScene;
using testing_support::narrowest_box_px;
using testing_support::rendered;
using testing_support::target_pose;
using testing_support::true_corners_px;

constexpr double degree = std::numbers::pi / 180.0;

// As resources/targets/two-plane-24-marked.yaml has them.
BoxTarget marked_target() {
    BoxTarget target = two_plane_24();
    target.marks = {{0, 62.5, 82.5, 14.0}, {1, 62.5, 177.5, 14.0}};
    return target;
}

BoxScene scene_with(const BoxTarget& target, std::uint32_t seed, double roll_deg) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    BoxScene scene;
    scene.target = target;
    scene.lens = seed % 2 == 0 ? nominal_rig().left.lens : nominal_rig().right->lens;
    scene.seed = seed;
    if (!target.dark_on_light) {
        std::swap(scene.paper, scene.ink);
    }
    for (;;) {
        const double range = uniform(550.0, 1000.0);
        scene.camera_from_target = target_pose(
            scene.target, {range * uniform(-0.25, 0.25), range * uniform(-0.15, 0.15), range},
            uniform(-25.0, 25.0) * degree, uniform(-25.0, 25.0) * degree, roll_deg * degree);
        const auto corners = true_corners_px(scene);
        bool inside = true;
        for (const auto& p : corners) {
            inside = inside && p.x() > 12 && p.y() > 12 && p.x() < scene.width_px - 13 &&
                     p.y() < scene.height_px - 13;
        }
        if (inside && narrowest_box_px(corners) >= 7.0) {
            return scene;
        }
    }
}

struct Tally {
    int found = 0;
    int wrong = 0;
    int corners = 0;
};

void add(Tally& tally, const BoxScene& scene, const BoxTarget& target) {
    const auto detection = detect_boxes(rendered(scene), target);
    if (!detection) {
        return;
    }
    ++tally.found;
    const auto truth = true_corners_px(scene);
    bool wrong = false;
    for (const DetectedCorner& corner : detection->corners) {
        wrong = wrong || (corner.px - truth[static_cast<std::size_t>(corner.id)]).norm() > 2.0;
        ++tally.corners;
    }
    tally.wrong += wrong ? 1 : 0;
}

TEST(BoxMarks, AMarkedTargetIsKnownInAnyRoll) {
    Tally tally;
    int pictures = 0;
    for (int roll = -180; roll < 180; roll += 15) {
        const BoxScene scene =
            scene_with(marked_target(), static_cast<std::uint32_t>(700 + roll), roll);
        add(tally, scene, marked_target());
        ++pictures;
    }
    RecordProperty("found", tally.found);
    EXPECT_GE(tally.found, pictures - 1);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.corners, 90 * tally.found);
}

TEST(BoxMarks, LightMarksOnADarkSheetDoTheSame) {
    BoxTarget target = marked_target();
    target.dark_on_light = false;
    Tally tally;
    for (int i = 0; i < 8; ++i) {
        add(tally, scene_with(target, static_cast<std::uint32_t>(40 + i), 45.0 * i + 10.0), target);
    }
    EXPECT_GE(tally.found, 7);
    EXPECT_EQ(tally.wrong, 0);
}

// The top row and the bottom row are lost: without marks such a part is ambiguous.
TEST(BoxMarks, APartWithAMarkIsEnough) {
    Tally marked;
    Tally plain;
    for (int i = 0; i < 12; ++i) {
        const auto seed = static_cast<std::uint32_t>(300 + i);
        for (const bool top : {true, false}) {
            BoxScene scene = scene_with(marked_target(), seed, 30.0 * i);
            for (int box = 0; box < 6; ++box) {
                scene.hidden.insert(top ? box : 18 + box);
            }
            add(marked, scene, marked_target());
            BoxScene bare = scene_with(two_plane_24(), seed, 10.0);
            bare.hidden = scene.hidden;
            add(plain, bare, two_plane_24());
        }
    }
    RecordProperty("found", marked.found);
    EXPECT_GE(marked.found, 22);
    EXPECT_EQ(marked.wrong, 0);
    EXPECT_EQ(plain.found, 0);
}

// Nothing tells which way up the target is: refused, and the reason names the marks.
TEST(BoxMarks, WithoutAMarkInSightItIsRefused) {
    for (int i = 0; i < 8; ++i) {
        const BoxScene scene =
            scene_with(two_plane_24(), static_cast<std::uint32_t>(500 + i), 45.0 * i);
        const auto detection = detect_boxes(rendered(scene), marked_target());
        ASSERT_FALSE(detection);
        EXPECT_NE(detection.error().cause.find("round marks"), std::string::npos)
            << detection.error().text();
    }
}

// Marks that half a turn maps onto each other tell nothing.
TEST(BoxMarks, MarksThatAreSymmetricThemselvesAreNotTrusted) {
    BoxTarget target = two_plane_24();
    target.marks = {{0, 62.5, 82.5, 14.0}, {1, 137.5, 272.5, 14.0}};
    Tally tally;
    for (int i = 0; i < 4; ++i) {
        add(tally, scene_with(target, static_cast<std::uint32_t>(600 + i), 90.0 * i), target);
    }
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_EQ(tally.found, 0);
}

// Other marks than the file's: none of the placements has them, or one that is wrong would.
TEST(BoxMarks, AnotherTargetsMarksAreNotTakenForThese) {
    BoxTarget other = two_plane_24();
    other.marks = {{0, 137.5, 272.5, 14.0}, {1, 137.5, 82.5, 14.0}};
    Tally tally;
    for (int i = 0; i < 8; ++i) {
        add(tally, scene_with(other, static_cast<std::uint32_t>(650 + i), 45.0 * i),
            marked_target());
    }
    EXPECT_EQ(tally.found, 0);
}

TEST(BoxMarks, AMarkedFlatSheetIsKnownInAnyRoll) {
    BoxTarget flat = two_plane_24();
    flat.planes = {{4, 180.0, 0.0, 0.0}};
    flat.box_height_mm = 50.0;
    flat.pitch_down_mm = 75.0;
    flat.marks = {{0, 62.5, 62.5, 14.0}};
    Tally tally;
    for (int i = 0; i < 12; ++i) {
        add(tally, scene_with(flat, static_cast<std::uint32_t>(800 + i), 30.0 * i), flat);
    }
    EXPECT_GE(tally.found, 11);
    EXPECT_EQ(tally.wrong, 0);
}

}  // namespace
}  // namespace kambara
