// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_detector.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/camera/nominal_rig.h"
#include "tests/support/box_scene.h"

namespace kambara {
namespace {

using testing_support::BoxScene;
using testing_support::decoys;
using testing_support::narrowest_box_px;
using testing_support::rendered;
using testing_support::target_pose;
using testing_support::true_corners_px;

constexpr double degree = std::numbers::pi / 180.0;

// A target somewhere before one of the nominal cameras, wholly in the picture, no box narrower than
// 6 px, within 45 degrees of upright.
BoxScene random_scene(std::uint32_t seed, double nearest_mm, double farthest_mm,
                      double tilt_deg = 30.0, double bending = 1.0) {
    std::mt19937 random(seed);
    const auto uniform = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    BoxScene scene;
    scene.lens = seed % 2 == 0 ? nominal_rig().left.lens : nominal_rig().right->lens;
    std::get<TsaiLens>(scene.lens).kappa1_per_mm2 *= bending;
    scene.seed = seed;
    for (;;) {
        const double range = uniform(nearest_mm, farthest_mm);
        scene.camera_from_target = target_pose(
            scene.target, {range * uniform(-0.4, 0.4), range * uniform(-0.25, 0.25), range},
            uniform(-25.0, 25.0) * degree, uniform(-tilt_deg, tilt_deg) * degree,
            uniform(-40.0, 40.0) * degree);
        const auto corners = true_corners_px(scene);
        bool inside = true;
        for (const auto& p : corners) {
            inside = inside && p.x() > 12 && p.y() > 12 && p.x() < scene.width_px - 13 &&
                     p.y() < scene.height_px - 13;
        }
        if (inside && narrowest_box_px(corners) >= 6.0) {
            return scene;
        }
    }
}

struct Errors {
    double squares = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double outward = 0.0;    // away from the box's middle
    double in_sigmas = 0.0;  // squares by variance
    int corners = 0;
    int pictures = 0;
    int wrong = 0;  // a corner that is none, or another one

    void add(const BoxScene& scene, const BoxDetection& detection) {
        const auto truth = true_corners_px(scene);
        bool is_wrong = false;
        for (const DetectedCorner& corner : detection.corners) {
            const auto id = static_cast<std::size_t>(corner.id);
            const Eigen::Vector2d off = corner.px - truth[id];
            if (off.norm() > 2.0 || scene.hidden.contains(corner.id / 4)) {
                is_wrong = true;
                continue;
            }
            const std::size_t first = id / 4 * 4;
            const Eigen::Vector2d middle =
                0.25 * (truth[first] + truth[first + 1] + truth[first + 2] + truth[first + 3]);
            squares += off.squaredNorm();
            sum += off;
            outward += off.dot((truth[id] - middle).normalized());
            in_sigmas += 0.5 * off.squaredNorm() / (corner.sigma_px * corner.sigma_px);
            ++corners;
        }
        wrong += is_wrong ? 1 : 0;
        ++pictures;
    }
    double rms_px() const { return std::sqrt(squares / (2.0 * corners)); }
};

Errors measured(int pictures, double nearest_mm, double farthest_mm, double blur_px = 0.0,
                double tilt_deg = 30.0) {
    Errors errors;
    for (int i = 0; i < pictures; ++i) {
        BoxScene scene =
            random_scene(static_cast<std::uint32_t>(100 + i), nearest_mm, farthest_mm, tilt_deg);
        scene.blur_px = blur_px;
        if (const auto detection = detect_boxes(rendered(scene), two_plane_24())) {
            errors.add(scene, *detection);
        }
    }
    return errors;
}

TEST(BoxDetector, CornersAreGoodToThreeHundredthsOfAPixelUpToAMetre) {
    const Errors errors = measured(20, 450.0, 1000.0);
    testing::Test::RecordProperty("rms_px", std::to_string(errors.rms_px()));
    EXPECT_GE(errors.pictures, 19);
    EXPECT_EQ(errors.wrong, 0);
    EXPECT_LT(errors.rms_px(), 0.03);
    EXPECT_LT((errors.sum / errors.corners).norm(), 0.01);
    EXPECT_LT(std::abs(errors.outward / errors.corners), 0.01);
    EXPECT_LT(errors.in_sigmas / errors.corners, 1.5);
}

TEST(BoxDetector, CornersAreGoodToAFiftiethOfAPixelBeyond) {
    const Errors errors = measured(20, 1000.0, 1600.0);
    testing::Test::RecordProperty("rms_px", std::to_string(errors.rms_px()));
    EXPECT_GE(errors.pictures, 18);
    EXPECT_EQ(errors.wrong, 0);
    EXPECT_LT(errors.rms_px(), 0.05);
    EXPECT_LT((errors.sum / errors.corners).norm(), 0.01);
    EXPECT_LT(std::abs(errors.outward / errors.corners), 0.01);
}

// Twenty times as many, and tilted by up to 45 degrees.
TEST(BoxDetectorSlow, CornersAreGoodInHundredsOfPictures) {
    for (const bool is_near : {true, false}) {
        const Errors errors = is_near ? measured(300, 450.0, 1000.0, 0.0, 45.0)
                                      : measured(300, 1000.0, 1600.0, 0.0, 45.0);
        const double bias_px = (errors.sum / errors.corners).norm();
        const double outward_px = std::abs(errors.outward / errors.corners);
        std::printf("%s a metre: %d pictures, %d corners, %.4f px RMS, bias %.4f, outward %.4f\n",
                    is_near ? "up to" : "beyond", errors.pictures, errors.corners, errors.rms_px(),
                    bias_px, outward_px);
        EXPECT_GE(errors.pictures, 285);
        EXPECT_EQ(errors.wrong, 0);
        EXPECT_LT(errors.rms_px(), is_near ? 0.03 : 0.05);
        EXPECT_LT(bias_px, 0.01);
        EXPECT_LT(outward_px, 0.01);
    }
}

// A lens that is known leaves nothing of its bending for the sides to tell: here a third more of it
// than the nominal lenses have, in pictures of small boxes whose sides tell little.
TEST(BoxDetector, AKnownLensHelpsWhereFewSidesTellItsBending) {
    // The target whole, then five boxes of it, near the picture's borders, too.
    for (const bool is_whole : {true, false}) {
        Errors without;
        Errors with;
        for (std::uint32_t seed = 700; seed < 724; ++seed) {
            BoxScene scene = random_scene(seed, 500.0, 1000.0, 30.0, 1.35);
            for (int box = 0; !is_whole && box < 24; ++box) {
                if (box != 0 && box != 5 && box != 8 && box != 18 && box != 21 && box != 23) {
                    scene.hidden.insert(box);
                }
            }
            const Image picture = rendered(scene);
            BoxDetectorOptions options;
            options.lens = scene.lens;
            const auto by_sides = detect_boxes(picture, two_plane_24());
            const auto by_lens = detect_boxes(picture, two_plane_24(), options);
            if (by_sides && by_lens) {
                without.add(scene, *by_sides);
                with.add(scene, *by_lens);
            }
        }
        std::printf("%s: %.4f px RMS by the sides, %.4f by the lens (%d pictures)\n",
                    is_whole ? "whole" : "six boxes", without.rms_px(), with.rms_px(),
                    with.pictures);
        EXPECT_GE(with.pictures, 12);
        EXPECT_EQ(with.wrong, 0);
        EXPECT_LT(with.rms_px(), 0.03);
        EXPECT_LT(with.rms_px(), (is_whole ? 1.02 : 1.0) * without.rms_px());
    }
}

TEST(BoxDetector, BlurMovesNoCorner) {
    const Errors errors = measured(8, 450.0, 900.0, 0.8);
    EXPECT_EQ(errors.pictures, 8);
    EXPECT_LT(errors.rms_px(), 0.03);
    EXPECT_LT(std::abs(errors.outward / errors.corners), 0.01);
}

// With up to 16 boxes hidden among 50 decoys and before a black disc, the boxes found are the ones
// they are taken for, or none are.
void strew(int pictures) {
    Errors errors;
    int few_hidden = 0;
    int few_hidden_found = 0;
    for (int i = 0; i < pictures; ++i) {
        BoxScene scene = random_scene(static_cast<std::uint32_t>(5000 + i), 500.0, 1500.0);
        std::mt19937 random(static_cast<std::uint32_t>(i));
        const int hide = i % 17;
        while (static_cast<int>(scene.hidden.size()) < hide) {
            scene.hidden.insert(static_cast<int>(random() % 24));
        }
        scene.behind = decoys(scene, 50, static_cast<std::uint32_t>(i));
        const auto detection = detect_boxes(rendered(scene), two_plane_24());
        if (hide <= 4) {
            ++few_hidden;
            few_hidden_found += detection ? 1 : 0;
        }
        if (detection) {
            errors.add(scene, *detection);
        }
    }
    testing::Test::RecordProperty("found_with_few_hidden", few_hidden_found);
    testing::Test::RecordProperty("with_few_hidden", few_hidden);
    testing::Test::RecordProperty("found", errors.pictures);
    EXPECT_EQ(errors.wrong, 0);
    EXPECT_GE(few_hidden_found, std::ceil(0.95 * few_hidden));
    EXPECT_GT(errors.pictures, pictures / 2);
    EXPECT_LT(errors.rms_px(), 0.05);
}

TEST(BoxDetector, NeverTakesABoxForAnotherOne) {
    strew(102);
}

TEST(BoxDetectorSlow, NeverTakesABoxForAnotherOneInAThousandPictures) {
    strew(1000);
}

TEST(BoxDetector, RefusesWhatCouldStandElsewhere) {
    BoxScene scene = random_scene(7, 700.0, 900.0);
    const auto refused_without = [&](auto is_hidden) {
        scene.hidden.clear();
        for (int box = 0; box < 24; ++box) {
            if (is_hidden(box)) {
                scene.hidden.insert(box);
            }
        }
        const auto detection = detect_boxes(rendered(scene), two_plane_24());
        return !detection && !detection.error().cause.empty() && !detection.error().remedy.empty();
    };
    EXPECT_TRUE(refused_without([](int box) { return box < 6; }));        // the top row
    EXPECT_TRUE(refused_without([](int box) { return box >= 18; }));      // the bottom row
    EXPECT_TRUE(refused_without([](int box) { return box % 6 < 3; }));    // the left plane
    EXPECT_TRUE(refused_without([](int box) { return box % 6 >= 3; }));   // the right plane
    EXPECT_FALSE(refused_without([](int box) { return box % 2 == 0; }));  // enough of it all
}

TEST(BoxDetector, GlareOverBoxesLeavesOutTheseAlone) {
    BoxScene scene = random_scene(11, 600.0, 700.0);
    const auto truth = true_corners_px(scene);
    // Over the right half of box 8 and a corner of box 9.
    const Eigen::Vector2d centre = truth[4 * 8 + 1];
    testing_support::Polygon glare;
    for (int i = 0; i < 32; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 32.0;
        glare.push_back(centre + 0.3 * (truth[4 * 8 + 2] - centre).norm() *
                                     Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    scene.over_it.push_back({glare, 250.0});
    const auto detection = detect_boxes(rendered(scene), two_plane_24());
    ASSERT_TRUE(detection) << detection.error().text();
    EXPECT_GE(detection->corners.size(), 84U);
    for (const DetectedCorner& corner : detection->corners) {
        EXPECT_LT((corner.px - truth[static_cast<std::size_t>(corner.id)]).norm(), 0.15)
            << corner.id;
    }
}

TEST(BoxDetector, FindsLightBoxesOnDark) {
    BoxScene scene = random_scene(3, 600.0, 900.0);
    scene.paper = 35.0;
    scene.ink = 200.0;
    scene.background = 20.0;
    BoxTarget target = two_plane_24();
    target.dark_on_light = false;
    const auto detection = detect_boxes(rendered(scene), target);
    ASSERT_TRUE(detection) << detection.error().text();
    Errors errors;
    errors.add(scene, *detection);
    EXPECT_EQ(errors.wrong, 0);
    EXPECT_LT(errors.rms_px(), 0.03);
}

TEST(BoxDetector, SaysWhyItRefuses) {
    BoxScene scene = random_scene(5, 600.0, 700.0);
    scene.blur_px = 8.0;
    const auto blurred = detect_boxes(rendered(scene), two_plane_24());
    ASSERT_FALSE(blurred);
    EXPECT_NE(blurred.error().cause.find("blurred"), std::string::npos) << blurred.error().text();
    scene.blur_px = 0.0;
    scene.camera_from_target = target_pose(scene.target, {0.0, 0.0, 5000.0}, 0.0, 0.0, 0.0);
    const auto far = detect_boxes(rendered(scene), two_plane_24());
    ASSERT_FALSE(far);
    EXPECT_FALSE(far.error().remedy.empty());
    EXPECT_FALSE(detect_boxes(Image(640, 480, 1, 128), two_plane_24()));
}

TEST(BoxDetector, SaysWhereOnePlaneIsSeenTooMuchFromItsSide) {
    BoxScene scene = random_scene(5, 600.0, 700.0);
    scene.camera_from_target =
        target_pose(scene.target, {0.0, 0.0, 1300.0}, 37.0 * degree, 0.0, 0.0);
    const auto askew = detect_boxes(rendered(scene), two_plane_24());
    ASSERT_FALSE(askew);
    EXPECT_NE(askew.error().cause.find("too small"), std::string::npos) << askew.error().text();
    EXPECT_NE(askew.error().remedy.find("both planes"), std::string::npos);
}

// Planes of black plastic: light boxes on dark, some of them under glare, among round and
// four-sided things in the background.
TEST(BoxDetector, LightOnDarkIsAsExactAsDarkOnLight) {
    BoxTarget light_on_dark = two_plane_24();
    light_on_dark.dark_on_light = false;
    Errors dark;
    Errors light;
    for (std::uint32_t seed = 300; seed < 312; ++seed) {
        BoxScene scene = random_scene(seed, 500.0, 1200.0);
        if (const auto found = detect_boxes(rendered(scene), two_plane_24())) {
            dark.add(scene, *found);
        }
        std::swap(scene.paper, scene.ink);
        scene.background = 120.0;
        if (const auto found = detect_boxes(rendered(scene), light_on_dark)) {
            light.add(scene, *found);
        }
    }
    testing::Test::RecordProperty("dark_rms_px", std::to_string(dark.rms_px()));
    testing::Test::RecordProperty("light_rms_px", std::to_string(light.rms_px()));
    EXPECT_EQ(dark.pictures, 12);
    EXPECT_EQ(light.pictures, 12);
    EXPECT_EQ(light.wrong, 0);
    EXPECT_LT(light.rms_px(), 0.03);
    EXPECT_LT(light.rms_px(), 1.5 * dark.rms_px());
    EXPECT_LT((light.sum / light.corners).norm(), 0.01);
    EXPECT_LT(std::abs(light.outward / light.corners), 0.01);
}

testing_support::Polygon disc(const Eigen::Vector2d& centre, double radius) {
    testing_support::Polygon outline;
    for (int i = 0; i < 48; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 48.0;
        outline.push_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    return outline;
}

// Round things as large as boxes are no boxes, before or beside the target; nor is what shows
// through glare.
void strew_discs(int pictures) {
    Errors errors;
    for (int i = 0; i < pictures; ++i) {
        BoxScene scene = random_scene(static_cast<std::uint32_t>(9000 + i), 500.0, 1300.0);
        std::mt19937 random(static_cast<std::uint32_t>(i));
        std::uniform_real_distribution<double> unit(0.0, 1.0);
        for (int k = 0; k < 12; ++k) {
            // On a grid of their own, so that they don't overlap: behind the target's own sheets.
            const Eigen::Vector2d centre(60.0 + 160.0 * (k % 4) + 40.0 * unit(random),
                                         60.0 + 160.0 * std::floor(k / 4) + 40.0 * unit(random));
            scene.behind.push_back({disc(centre, 8.0 + 22.0 * unit(random)), 10.0});
        }
        const auto truth = true_corners_px(scene);
        const auto box = static_cast<std::size_t>(random() % 24);
        const double height = (truth[4 * box + 3] - truth[4 * box]).norm();
        scene.over_it.push_back(
            {disc(truth[4 * box + random() % 4], (0.2 + 0.8 * unit(random)) * height), 250.0});
        if (const auto detection = detect_boxes(rendered(scene), two_plane_24())) {
            errors.add(scene, *detection);
        }
    }
    testing::Test::RecordProperty("found", errors.pictures);
    testing::Test::RecordProperty("rms_px", std::to_string(errors.rms_px()));
    EXPECT_EQ(errors.wrong, 0);
    EXPECT_GE(errors.pictures, std::ceil(0.95 * pictures));
    EXPECT_LT(errors.rms_px(), 0.05);
}

TEST(BoxDetector, DiscsAndGlareTakeNoBoxesPlace) {
    strew_discs(40);
}

TEST(BoxDetectorSlow, DiscsAndGlareTakeNoBoxesPlaceInThreeHundredPictures) {
    strew_discs(300);
}

TEST(BoxDetector, TellsHowWideEdgesAre) {
    double before = 0.0;
    for (const double blur_px : {0.0, 0.8, 1.5, 2.0}) {
        BoxScene scene = random_scene(21, 450.0, 600.0);
        scene.blur_px = blur_px;
        const auto detection = detect_boxes(rendered(scene), two_plane_24());
        ASSERT_TRUE(detection) << blur_px << ": " << detection.error().text();
        const double width = detection->corners.front().blur_px;
        const double expected =
            std::sqrt(2.0 * std::numbers::pi * (blur_px * blur_px + 5.0 / 12.0));
        EXPECT_NEAR(width, expected, 0.15 * expected) << blur_px;
        EXPECT_GT(width, before);
        before = width;
    }
    EXPECT_GT(before, 4.0);
}

}  // namespace
}  // namespace kambara
