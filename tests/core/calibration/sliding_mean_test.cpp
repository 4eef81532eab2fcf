// SPDX-License-Identifier: GPL-3.0-or-later
// The reference method of 1999, and where it fails while the detector does not.
#include "core/calibration/sliding_mean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/calibration/box_detector.h"
#include "core/calibration/point_sorting.h"
#include "core/camera/nominal_rig.h"
#include "tests/support/box_scene.h"

namespace kambara {
namespace {

using testing_support::BoxScene;
using testing_support::rendered;
using testing_support::target_pose;
using testing_support::true_corners_px;

BoxScene scene_at(double range_mm) {
    BoxScene scene;
    scene.lens = nominal_rig().left.lens;
    scene.background = scene.paper;  // no edge around the sheets, whose centre would be the mean
    scene.camera_from_target = target_pose(scene.target, {0.0, 0.0, range_mm}, 0.0, 0.0, 0.0);
    return scene;
}

std::vector<Eigen::Vector2d> box_centres(const BoxScene& scene) {
    const auto corners = true_corners_px(scene);
    std::vector<Eigen::Vector2d> centres;
    for (std::size_t i = 0; i < corners.size(); i += 4) {
        centres.push_back(0.25 * (corners[i] + corners[i + 1] + corners[i + 2] + corners[i + 3]));
    }
    return centres;
}

// Whether the sliding mean over all closed chains of the picture ends with the boxes.
bool sliding_mean_finds_boxes(const BoxScene& scene, const BoxStages& stages) {
    std::vector<Eigen::Vector2d> centroids;
    for (const EdgeChain& chain : stages.chains) {
        centroids.push_back(centroid_of(chain));
    }
    const SlidingMean result = sliding_mean(centroids, 24);
    const auto centres = box_centres(scene);
    const auto is_box = [&](std::size_t i) {
        return std::any_of(centres.begin(), centres.end(), [&](const auto& centre) {
            return (centre - centroids[i]).norm() < 2.0;
        });
    };
    return result.kept.size() == 24 && std::all_of(result.kept.begin(), result.kept.end(), is_box);
}

// A dark square that stands free, this far to the left of the target's middle.
testing_support::CoverageCanvas::Piece square_beside(const BoxScene& scene, double left_px) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const auto& centre : box_centres(scene)) {
        middle += centre / 24.0;
    }
    const Eigen::Vector2d at = middle - Eigen::Vector2d(left_px, 0.0);
    const auto corner = [&](double x, double y) {
        return Eigen::Vector2d(at + Eigen::Vector2d(x, y));
    };
    return {{corner(-8, -8), corner(8, -8), corner(8, 8), corner(-8, 8)}, 5.0};
}

TEST(SlidingMean, FindsTheBoxesAmongOutliersFarAway) {
    BoxScene scene = scene_at(900.0);
    scene.behind.push_back(square_beside(scene, 250.0));
    BoxStages stages;
    EXPECT_TRUE(detect_boxes(rendered(scene), two_plane_24(), {}, &stages));
    EXPECT_TRUE(sliding_mean_finds_boxes(scene, stages));
}

// The target is higher than wide: what stands close beside it lies within the circle that reaches
// its farthest boxes.
TEST(SlidingMean, FailsInItsForbiddenRegionWhereTheDetectorDoesNot) {
    BoxScene scene = scene_at(900.0);
    scene.behind.push_back(square_beside(scene, 78.0));
    BoxStages stages;
    const auto detection = detect_boxes(rendered(scene), two_plane_24(), {}, &stages);
    ASSERT_TRUE(detection) << detection.error().text();
    EXPECT_EQ(detection->corners.size(), 96U);
    EXPECT_FALSE(sliding_mean_finds_boxes(scene, stages));
}

TEST(SlidingMean, TakesAnOutlierForABoxThatIsMissing) {
    BoxScene scene = scene_at(900.0);
    scene.hidden.insert(9);
    scene.behind.push_back(square_beside(scene, 250.0));
    BoxStages stages;
    const auto detection = detect_boxes(rendered(scene), two_plane_24(), {}, &stages);
    ASSERT_TRUE(detection) << detection.error().text();
    EXPECT_EQ(detection->corners.size(), 92U);
    EXPECT_FALSE(sliding_mean_finds_boxes(scene, stages));
}

std::vector<Eigen::Vector2d> grid(double roll_rad) {
    std::vector<Eigen::Vector2d> points;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 6; ++column) {
            const Eigen::Vector2d p(30.0 * column - 75.0, 40.0 * row - 60.0);
            points.emplace_back(320.0 + std::cos(roll_rad) * p.x() - std::sin(roll_rad) * p.y(),
                                240.0 + std::sin(roll_rad) * p.x() + std::cos(roll_rad) * p.y());
        }
    }
    return points;
}

bool in_order(double roll_rad, TopLeftRule rule) {
    const auto sorted = sort_points(grid(roll_rad), rule, 480);
    return std::is_sorted(sorted.begin(), sorted.end());
}

TEST(PointSorting, OneOfTheRulesSortsAnUprightTarget) {
    EXPECT_TRUE(in_order(0.1, TopLeftRule::topleft_bottomright));
}

TEST(PointSorting, NoRuleSortsEveryTargetWithin45Degrees) {
    for (const TopLeftRule rule : {TopLeftRule::max_theta, TopLeftRule::topleft_bottomright,
                                   TopLeftRule::bottomleft_topright}) {
        bool always = true;
        for (const double roll : {-0.7, -0.35, 0.0, 0.35, 0.7}) {
            always = always && in_order(roll, rule);
        }
        EXPECT_FALSE(always);
    }
}

}  // namespace
}  // namespace kambara
