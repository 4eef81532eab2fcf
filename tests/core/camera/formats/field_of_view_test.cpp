// SPDX-License-Identifier: GPL-3.0-or-later
// Rigs that go to another program's format and back, compared over the whole field of view of both
// cameras; and the files as OpenCV itself reads them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "core/base/angles.h"
#include "core/camera/foreign_formats.h"
#include "core/camera/nominal_rig.h"

namespace kambara {
namespace {

// To another size than the usual, and no two numbers alike.
Rig brown_rig(const std::vector<double>& left, const std::vector<double>& right) {
    const Camera a{BrownLens(933.0, 934.5, 651.0, 355.0, left), 1280, 720, {}};
    const Camera b{BrownLens(936.0, 937.5, 626.0, 370.0, right), 1280, 720, {}};
    return rig_from_pair(a, b,
                         {rotation_about_y(rad_from_deg(6.0)) * rotation_about_x(rad_from_deg(1.0)),
                          {-449.8, 11.1, -22.0}});
}

// The largest distance between where both rigs have what the left camera sees: on a grid that
// takes in the pictures' borders, near and far.
double worst_difference_px(const Rig& a, const Rig& b) {
    double worst = 0.0;
    int in_right = 0;
    for (int j = 0; j <= 24; ++j) {
        for (int i = 0; i <= 32; ++i) {
            const Eigen::Vector2d pixel((a.left.width_px - 1.0) * i / 32.0,
                                        (a.left.height_px - 1.0) * j / 24.0);
            const auto ray = unproject(a.left.lens, pixel);
            const auto of_right = unproject(a.right->lens, pixel);
            EXPECT_TRUE(ray && of_right);
            if (!ray || !of_right) {
                return 1e9;
            }
            const auto left = project(b.left.lens, ray->direction);
            const auto right = project(b.right->lens, of_right->direction);
            EXPECT_TRUE(left && right);
            if (!left || !right) {
                return 1e9;
            }
            worst = std::max({worst, (*left - pixel).norm(), (*right - pixel).norm()});
            for (const double range_mm : {400.0, 1500.0, 8000.0}) {
                const Eigen::Vector3d point = range_mm * ray->direction;
                const auto in_a = project(a.right->lens, T_right_from_left(a) * point);
                if (!in_a || !a.right->sees(*in_a)) {
                    continue;
                }
                const auto in_b = project(b.right->lens, T_right_from_left(b) * point);
                EXPECT_TRUE(in_b);
                worst = std::max(worst, in_b ? (*in_b - *in_a).norm() : 1e9);
                ++in_right;
            }
        }
    }
    EXPECT_GT(in_right, 300);
    return worst;
}

struct Format {
    const char* name;
    std::function<Result<ExportedPair>(const Rig&)> write;
    std::function<Result<Rig>(const ExportedPair&)> read;
    int terms;
};

const std::vector<Format>& formats() {
    static const std::vector<Format> all{
        {"opencv", rig_to_opencv,
         [](const ExportedPair& f) { return rig_from_opencv(f.first, f.second, std::nullopt); }, 8},
        {"ros", rig_to_ros, [](const ExportedPair& f) { return rig_from_ros(f.first, f.second); },
         8},
        {"kalibr", rig_to_kalibr, [](const ExportedPair& f) { return rig_from_kalibr(f.first); },
         4},
    };
    return all;
}

const std::vector<double> none{0.0, 0.0, 0.0, 0.0, 0.0};
const std::vector<double> four{-0.28, 0.09, 0.001, -0.0003, 0.0};
const std::vector<double> five{-0.28, 0.09, 0.001, -0.0003, 0.01};
const std::vector<double> eight{0.12, -0.05, 0.001, -0.0003, 0.01, 0.4, 0.02, 0.003};

TEST(FieldOfView, RoundTripsAgreeWhereBothSidesHaveTheModel) {
    const std::vector<std::pair<std::vector<double>, int>> lenses{
        {none, 4}, {four, 4}, {five, 5}, {eight, 8}};
    for (const Format& format : formats()) {
        for (const auto& [left, left_terms] : lenses) {
            for (const auto& [right, right_terms] : lenses) {
                if (std::max(left_terms, right_terms) > format.terms) {
                    continue;
                }
                const Rig rig = brown_rig(left, right);
                const auto files = format.write(rig);
                ASSERT_TRUE(files) << format.name << ": " << files.error().text();
                EXPECT_EQ(files->worst_residual_px, 0.0);
                const auto back = format.read(*files);
                ASSERT_TRUE(back) << format.name << ": " << back.error().text();
                EXPECT_LT(worst_difference_px(rig, *back), 1e-6) << format.name;
                EXPECT_EQ(back->right->height_px, 720);
                EXPECT_NEAR(baseline_mm(*back), baseline_mm(rig), 1e-9);
                // What was read writes the same text again.
                const auto again = format.write(*back);
                ASSERT_TRUE(again);
                const auto once_more = format.read(*again);
                ASSERT_TRUE(once_more);
                EXPECT_LT(worst_difference_px(rig, *once_more), 1e-6) << format.name;
            }
        }
    }
}

// Tsai's lens goes over through the rational one, in air and water; the residual that is told holds
// everywhere in the picture.
TEST(FieldOfView, TsaisLensGoesThroughTheRationalModel) {
    for (const Medium medium : {Medium::air, Medium::water}) {
        const Rig rig = nominal_rig(medium);
        for (const Format& format : formats()) {
            if (format.terms < 8) {
                continue;
            }
            const auto files = format.write(rig);
            ASSERT_TRUE(files) << format.name << ": " << files.error().text();
            RecordProperty(std::string(format.name) + (medium == Medium::air ? "_air" : "_water"),
                           std::to_string(files->worst_residual_px));
            EXPECT_GT(files->worst_residual_px, 0.0);
            EXPECT_LT(files->worst_residual_px, most_export_residual_px);
            const auto back = format.read(*files);
            ASSERT_TRUE(back) << back.error().text();
            // The right camera's place in the left one's rays adds what both are off.
            EXPECT_LT(worst_difference_px(rig, *back), 1.1 * files->worst_residual_px + 1e-6);
        }
    }
}

TEST(FieldOfView, TsaisLensIsRefusedWhereTooMuchRemains) {
    const auto files = rig_to_kalibr(nominal_rig());
    ASSERT_FALSE(files);
    // The number that is told is above the bound.
    const std::string& cause = files.error().cause;
    const auto at = cause.find(": ");
    ASSERT_NE(at, std::string::npos);
    EXPECT_GT(std::stod(cause.substr(at + 2)), most_export_residual_px);
    // A lens that bends little fits into four terms.
    Rig mild = nominal_rig();
    std::get<TsaiLens>(mild.left.lens).kappa1_per_mm2 = 0.002;
    std::get<TsaiLens>(mild.right->lens).kappa1_per_mm2 = -0.002;
    const auto fits = rig_to_kalibr(mild);
    ASSERT_TRUE(fits) << fits.error().text();
    const auto back = rig_from_kalibr(fits->first);
    ASSERT_TRUE(back);
    EXPECT_LT(worst_difference_px(mild, *back), 1.1 * fits->worst_residual_px + 1e-6);
}

// Pincushion and barrel lenses of any strength: what is exported is as near as it says.
TEST(FieldOfView, TheResidualToldHoldsForManyLenses) {
    for (const double kappa : {-0.01, -0.004, 0.004, 0.01, 0.02, 0.03, 0.05, 0.06, 0.075, 0.08}) {
        Rig rig = nominal_rig();
        std::get<TsaiLens>(rig.left.lens).kappa1_per_mm2 = kappa;
        std::get<TsaiLens>(rig.right->lens).kappa1_per_mm2 = kappa;
        const auto files = rig_to_opencv(rig);
        ASSERT_TRUE(files) << kappa << ": " << files.error().text();
        RecordProperty("kappa_" + std::to_string(kappa), std::to_string(files->worst_residual_px));
        const auto back = rig_from_opencv(files->first, files->second, std::nullopt);
        ASSERT_TRUE(back);
        EXPECT_LT(worst_difference_px(rig, *back), 1.1 * files->worst_residual_px + 1e-6) << kappa;
    }
}

// OpenCV reads the files with its own reader and projects with its own code.
TEST(FieldOfView, OpenCvProjectsWithOurFilesAsWeDo) {
    for (const Rig& rig : {brown_rig(five, eight), nominal_rig()}) {
        const auto files = rig_to_opencv(rig);
        ASSERT_TRUE(files);
        cv::FileStorage intrinsics(files->first, cv::FileStorage::READ | cv::FileStorage::MEMORY);
        cv::FileStorage extrinsics(files->second, cv::FileStorage::READ | cv::FileStorage::MEMORY);
        cv::Mat M1, D1, M2, D2, R, T;
        intrinsics["M1"] >> M1;
        intrinsics["D1"] >> D1;
        intrinsics["M2"] >> M2;
        intrinsics["D2"] >> D2;
        extrinsics["R"] >> R;
        extrinsics["T"] >> T;
        ASSERT_EQ(T.total(), 3U);
        cv::Mat turn;
        cv::Rodrigues(R, turn);
        std::vector<cv::Point3d> points;
        std::vector<Eigen::Vector2d> in_left;
        std::vector<Eigen::Vector2d> in_right;
        for (int y = 0; y < rig.left.height_px; y += 40) {
            for (int x = 0; x < rig.left.width_px; x += 40) {
                const auto ray = unproject(rig.left.lens, Eigen::Vector2d(x, y));
                ASSERT_TRUE(ray);
                const Eigen::Vector3d p = 2000.0 * ray->direction;
                const auto right = project(rig.right->lens, T_right_from_left(rig) * p);
                if (right && rig.right->sees(*right)) {
                    points.emplace_back(p.x(), p.y(), p.z());
                    in_left.emplace_back(x, y);
                    in_right.push_back(*right);
                }
            }
        }
        ASSERT_GT(points.size(), 50U);
        std::vector<cv::Point2d> left;
        std::vector<cv::Point2d> right;
        const cv::Mat still = cv::Mat::zeros(3, 1, CV_64F);
        cv::projectPoints(points, still, still, M1, D1, left);
        cv::projectPoints(points, turn, T, M2, D2, right);
        const double allowed = files->worst_residual_px + 1e-6;
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_LT(std::hypot(left[i].x - in_left[i].x(), left[i].y - in_left[i].y()),
                      1.1 * allowed);
            EXPECT_LT(std::hypot(right[i].x - in_right[i].x(), right[i].y - in_right[i].y()),
                      1.1 * allowed);
        }
    }
}

}  // namespace
}  // namespace kambara
