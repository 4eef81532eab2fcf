// SPDX-License-Identifier: GPL-3.0-or-later
// What can't be calibrated is refused with its cause; what merely has wrong lines is calibrated
// without them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "core/calibration/tsai_calibrator.h"
#include "tests/core/calibration/tsai_scenes.h"

namespace kambara {
namespace {

using testing_support::cramer_rao_sigma;
using testing_support::error_of;
using testing_support::Random;
using testing_support::target_scene;
using testing_support::TsaiScene;
using testing_support::uniform;
using testing_support::with_noise;

TsaiScene target_at(Random& random, double distance_mm) {
    for (;;) {
        if (auto scene = target_scene(random, distance_mm)) {
            return *scene;
        }
    }
}

void expect_refused(const std::vector<SeenPoint>& points, const TsaiOptions& options,
                    const std::string& cause) {
    const auto report = calibrate_tsai(points, options);
    ASSERT_FALSE(report) << "expected: " << cause;
    EXPECT_NE(report.error().cause.find(cause), std::string::npos) << report.error().cause;
    EXPECT_FALSE(report.error().remedy.empty());
}

class TsaiRefusal : public testing::Test {
  protected:
    Random random_{3};
    TsaiScene scene_ = target_at(random_, 900.0);
    std::vector<SeenPoint>& points_ = scene_.points;
};

TEST_F(TsaiRefusal, FewerThanSevenPoints) {
    points_.resize(6);
    expect_refused(points_, scene_.options, "6 points");
    expect_refused({}, scene_.options, "0 points");
}

TEST_F(TsaiRefusal, NumbersThatAreNotFinite) {
    points_[4].seen_px.x() = std::numeric_limits<double>::quiet_NaN();
    expect_refused(points_, scene_.options, "point 5 is not finite");
    points_[4].seen_px.x() = 100.0;
    points_[7].in_world_mm.z() = std::numeric_limits<double>::infinity();
    expect_refused(points_, scene_.options, "point 8 is not finite");
}

TEST_F(TsaiRefusal, APointGivenTwice) {
    points_.push_back(points_[10]);
    expect_refused(points_, scene_.options, "given twice, by point 11 and point 97");
    const std::vector<int> lines = [&] {
        std::vector<int> numbers;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            numbers.push_back(static_cast<int>(i) + 3);
        }
        return numbers;
    }();
    const auto report = calibrate_tsai(points_, scene_.options, lines);
    ASSERT_FALSE(report);
    EXPECT_NE(report.error().cause.find("line 13 and line 99"), std::string::npos);
}

TEST_F(TsaiRefusal, PointsOnOneLine) {
    for (std::size_t i = 0; i < points_.size(); ++i) {
        points_[i].in_world_mm = static_cast<double>(i) * Eigen::Vector3d(3, -1, 2);
    }
    expect_refused(points_, scene_.options, "collinear");
    TsaiOptions plane = scene_.options;
    plane.coplanar = true;
    expect_refused(points_, plane, "collinear");
}

TEST_F(TsaiRefusal, PointsOnOnePlane) {
    std::erase_if(points_, [](const SeenPoint& p) { return p.in_world_mm.z() != 0.0; });
    ASSERT_EQ(points_.size(), 48U);
    expect_refused(points_, scene_.options, "coplanar");
}

TEST_F(TsaiRefusal, PointsInSpaceWhereAPlaneIsSaid) {
    scene_.options.coplanar = true;
    expect_refused(points_, scene_.options, "not on one plane");
}

TEST_F(TsaiRefusal, PixelsThatHaveNothingToDoWithThePoints) {
    for (SeenPoint& point : points_) {
        point.seen_px = {uniform(random_, 0, 639), uniform(random_, 0, 479)};
    }
    expect_refused(points_, scene_.options, "fit no camera");
    for (SeenPoint& point : points_) {
        point.seen_px = {320.0, 240.0};
    }
    expect_refused(points_, scene_.options, "fit no camera");
}

TEST(TsaiHandedness, ALeftHandedWorldIsSaid) {
    Random random(21);
    for (int run = 0; run < 15; ++run) {
        TsaiScene scene = target_at(random, uniform(random, 700.0, 1500.0));
        scene.points = with_noise(scene.points, 0.05, random);
        for (SeenPoint& point : scene.points) {
            point.in_world_mm[run % 3] *= -1.0;
        }
        expect_refused(scene.points, scene.options, "left-handed");
    }
}

TEST(TsaiHandedness, AMirroredPictureIsSaidEvenWithWrongLines) {
    Random random(22);
    for (int run = 0; run < 6; ++run) {
        TsaiScene scene = target_at(random, 1000.0);
        scene.points = with_noise(scene.points, 0.1, random);
        for (SeenPoint& point : scene.points) {
            point.seen_px.x() = 639.0 - point.seen_px.x();
        }
        for (int i = 0; i < 10; ++i) {
            scene.points[random() % 96].seen_px = {uniform(random, 0, 639),
                                                   uniform(random, 0, 479)};
        }
        expect_refused(scene.points, scene.options, "mirrored");
    }
}

// Up to a third of the lines wrong: by a little, by much, or for the pixel of another corner.
TEST(TsaiOutliers, WrongLinesAreFoundAndLeftOut) {
    Random random(31);
    for (int run = 0; run < 20; ++run) {
        TsaiScene scene = target_at(random, uniform(random, 700.0, 1500.0));
        scene.points = with_noise(scene.points, 0.1, random);
        const auto before = scene.points;
        const auto wrong = random() % 33;
        for (std::size_t i = 0; i < wrong; ++i) {
            SeenPoint& point = scene.points[random() % 96];
            if (i % 3 == 0) {
                point.seen_px += Eigen::Vector2d(3.0, -3.0);
            } else if (i % 3 == 1) {
                point.seen_px = {uniform(random, 0, 639), uniform(random, 0, 479)};
            } else {
                point.seen_px = before[random() % 96].seen_px;
            }
        }
        std::vector<int> truly;
        for (std::size_t i = 0; i < 96; ++i) {
            if ((scene.points[i].seen_px - before[i].seen_px).norm() > 2.0) {
                truly.push_back(static_cast<int>(i));
            }
        }
        const auto report = calibrate_tsai(scene.points, scene.options);
        ASSERT_TRUE(report) << run << ": " << report.error().text();
        EXPECT_EQ(report->outliers, truly) << run;
        const TsaiVector ratio =
            error_of(report->view, scene.truth).cwiseQuotient(cramer_rao_sigma(scene, 0.1));
        EXPECT_LE(ratio.cwiseAbs().maxCoeff(), 5.0) << run;
    }
}

TEST(TsaiOutliers, TheSameListGivesTheSameCamera) {
    Random random(32);
    TsaiScene scene = target_at(random, 1200.0);
    scene.points = with_noise(scene.points, 0.1, random);
    for (std::size_t i = 0; i < 20; ++i) {
        scene.points[3 * i].seen_px += Eigen::Vector2d(40.0, 10.0);
    }
    const auto once = calibrate_tsai(scene.points, scene.options);
    const auto again = calibrate_tsai(scene.points, scene.options);
    ASSERT_TRUE(once && again);
    EXPECT_EQ(once->view.lens, again->view.lens);
    EXPECT_EQ(once->view.T_camera_from_world.R, again->view.T_camera_from_world.R);
    EXPECT_EQ(once->sigma, again->sigma);
}

}  // namespace
}  // namespace kambara
