// SPDX-License-Identifier: GPL-3.0-or-later
// What a match says of its own uncertainty, against many matches of known truth: the noise part of
// a position's covariance.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/tracking/match_pair.h"
#include "core/tracking/target_search.h"
#include "tests/support/textured_plane.h"

namespace kambara {
namespace {

using testing_support::drawn;
using testing_support::TexturedPlane;

constexpr double noise_grey = 2.0;
constexpr int side_px = 31;
constexpr int margin_px = 60;            // drawn about the target, for the searches
constexpr double of_95_percent = 7.815;  // chi squared of three degrees of freedom

class Noise {
  public:
    Frame on(const std::shared_ptr<const Image>& picture, const Rectangle& part) {
        Image noisy = *picture;
        for (int y = std::max(0, part.y); y < std::min(noisy.height(), part.y + part.height); ++y) {
            for (int x = std::max(0, part.x); x < std::min(noisy.width(), part.x + part.width);
                 ++x) {
                noisy.at(x, y) = static_cast<std::uint8_t>(std::lround(
                    std::clamp(noisy.at(x, y) + noise_grey * normal_(random_), 0.0, 255.0)));
            }
        }
        Frame frame;
        frame.picture = std::make_shared<const Image>(std::move(noisy));
        return frame;
    }

  private:
    std::mt19937 random_{5};
    std::normal_distribution<double> normal_;
};

// A picture of the plane about a point, without noise.
struct Seen {
    Rectangle part;
    std::shared_ptr<const Image> picture;

    Seen(const TexturedPlane& plane, const Camera& camera, const Eigen::Vector3d& at)
        : part(part_about(camera, at)),
          picture(std::make_shared<const Image>(drawn(plane, camera, part))) {}

  private:
    static Rectangle part_about(const Camera& camera, const Eigen::Vector3d& at) {
        const Eigen::Vector2d pixel = camera.project(at).value();
        const int half = side_px / 2 + margin_px;
        return {static_cast<int>(std::lround(pixel.x())) - half,
                static_cast<int>(std::lround(pixel.y())) - half, 2 * half + 1, 2 * half + 1};
    }
};

struct Coverage {
    int trials = 0;
    int missed = 0;
    int inside = 0;
    double chi2 = 0.0;           // of the position, mean; 3 where the covariance is right
    double chi2_left = 0.0;      // of the left pixel, 2
    double chi2_range = 0.0;     // 1
    double chi2_epipolar = 0.0;  // 1
    Eigen::Vector2d error_left = Eigen::Vector2d::Zero();
    Eigen::Vector2d sigma_left = Eigen::Vector2d::Zero();
    double share() const { return static_cast<double>(inside) / std::max(1, trials); }
};

// The target is cut at one place and found again a little farther on, each time with other noise.
void add_matches(const Rig& rig, const Eigen::Vector2d& left_px, double depth_mm, int places,
                 int repeats, std::uint32_t seed, Coverage& sum) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    Noise noise;
    TrackerOptions options;
    for (int place = 0; place < places; ++place) {
        // The template's centre is the middle of a pixel; the pattern under it is another each
        // time.
        const Ray ray = *rig.left.unproject(left_px);
        const Eigen::Vector3d first = ray.at((depth_mm - ray.origin_mm.z()) / ray.direction.z());
        TexturedPlane plane{first, 55.0, 125.0, depth_mm / 1500.0};
        const Eigen::Vector3d slip(300.0 * anywhere(random), 300.0 * anywhere(random), 0.0);
        plane.origin_in_rig_mm += slip * plane.size;
        const Eigen::Vector3d step =
            0.01 * depth_mm *
            Eigen::Vector3d(anywhere(random), anywhere(random), 0.5 * anywhere(random));
        TexturedPlane moved = plane;
        moved.origin_in_rig_mm += step;
        const Eigen::Vector3d second = first + step;
        const Seen before(plane, rig.left, first);
        const Seen left(moved, rig.left, second);
        const Seen right(moved, *rig.right, second);
        for (int i = 0; i < repeats; ++i) {
            const Frame cut = noise.on(before.picture, before.part);
            const StereoFrame pair{noise.on(left.picture, left.part),
                                   noise.on(right.picture, right.part)};
            const ReferencePatch patch{cut.picture, left_px, {side_px, side_px}, first, {}};
            SearchScope scope{second};
            scope.range_known = true;
            const auto found = search_target(rig, options, patch, pair, scope);
            ++sum.trials;
            if (!found || !found->position) {
                ++sum.missed;
                continue;
            }
            const Eigen::Vector3d truth = rig.left.T_camera_from_rig * second;
            const Eigen::Vector3d error = found->position->point_in_left_mm - truth;
            const Eigen::Matrix3d& C = found->position->covariance_mm2;
            const double chi2 = error.dot(C.ldlt().solve(error));
            sum.inside += chi2 <= of_95_percent ? 1 : 0;
            sum.chi2 += chi2;
            const Eigen::Vector3d along = truth.normalized();
            sum.chi2_range += std::pow(error.dot(along), 2) / along.dot(C * along);
            const EpipolarOffset& e = found->position->epipolar;
            sum.chi2_epipolar += std::pow(e.offset_px / e.noise_sigma_px, 2);
            const Eigen::Vector2d left_error = found->left.pixel - rig.left.project(second).value();
            sum.chi2_left += left_error.dot(found->left.covariance_px2.ldlt().solve(left_error));
            sum.error_left += left_error.cwiseAbs2();
            sum.sigma_left += found->left.covariance_px2.diagonal();
        }
    }
}

TEST(MatchUncertaintySlow, EllipsoidsOf95PercentHoldTheTruthThatOften) {
    const Rig rig = nominal_rig();
    struct Case {
        const char* name;
        Eigen::Vector2d left_px;
        double depth_mm;
    };
    const Case cases[] = {{"centre 1 m", {360, 240}, 1000.0}, {"edge 1 m", {560, 90}, 1000.0},
                          {"centre 2 m", {340, 240}, 2000.0}, {"edge 2 m", {570, 80}, 2000.0},
                          {"centre 5 m", {330, 240}, 5000.0}, {"edge 5 m", {590, 60}, 5000.0}};
    int trials = 0;
    int inside = 0;
    for (const Case& c : cases) {
        Coverage coverage;
        add_matches(rig, c.left_px, c.depth_mm, 100, 4, 7, coverage);
        const double n = std::max(1, coverage.trials - coverage.missed);
        std::printf(
            "%-11s inside %.1f %% of %d (%d not found); mean chi2 %.2f of 3, left %.2f of "
            "2, range %.2f, epipolar %.2f; left rms %.4f %.4f sigma %.4f %.4f px\n",
            c.name, 100.0 * coverage.share(), coverage.trials, coverage.missed, coverage.chi2 / n,
            coverage.chi2_left / n, coverage.chi2_range / n, coverage.chi2_epipolar / n,
            std::sqrt(coverage.error_left.x() / n), std::sqrt(coverage.error_left.y() / n),
            std::sqrt(coverage.sigma_left.x() / n), std::sqrt(coverage.sigma_left.y() / n));
        // 400 matches tell a share to 1.1 %.
        EXPECT_NEAR(coverage.share(), 0.95, 0.035) << c.name;
        trials += coverage.trials;
        inside += coverage.inside;
    }
    std::printf("all: %.1f %% of %d\n", 100.0 * inside / trials, trials);
    EXPECT_GE(inside, 0.93 * trials);
    EXPECT_LE(inside, 0.97 * trials);
}

}  // namespace
}  // namespace kambara
