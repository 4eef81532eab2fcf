// SPDX-License-Identifier: GPL-3.0-or-later
// A recording by a renderer that shares nothing with the project, followed as `track` follows it:
// the true places against the ellipsoids that are told with the positions.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <string>
#include <vector>

#include "app/sources/sources.h"
#include "core/image/rectangle.h"
#include "core/vsystem/vision_system.h"
#include "tests/support/process.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;
constexpr double of_95_percent = 7.815;  // chi squared of three degrees of freedom

TEST(MovingTarget, IsWithinItsEllipsoidOf95PercentAtAlmostAllPlaces) {
    const fs::path folder = fs::path(KAMBARA_DATA) / "moving_target";
    if (!fs::is_directory(folder)) {
        GTEST_SKIP() << "skipped: there is no folder of real recordings at " << KAMBARA_DATA;
    }
    SteadyClock clock;
    SourceOptions source;
    source.rig = std::string(KAMBARA_SOURCE) + "/resources/rigs/nominal-air.yaml";
    source.left = (folder / "left/%06d.png").string();
    source.right = (folder / "right/%06d.png").string();
    auto sources = open_sources(source, clock);
    ASSERT_TRUE(sources) << sources.error().text();
    VisionSystemOptions options;
    options.every_frame = true;
    options.start_paused = true;
    auto opened = open_vision_system(std::move(sources->parts), options, clock);
    ASSERT_TRUE(opened) << opened.error().text();
    std::ifstream template_file(folder / "template.txt");
    std::string rectangle;
    template_file >> rectangle;
    ASSERT_TRUE((*opened)->execute(SelectTemplate{*parse_rectangle(rectangle), std::nullopt}));
    std::mutex mutex;
    std::condition_variable changed;
    std::vector<std::optional<Position>> seen;
    std::vector<double> turns;
    bool over = false;
    const auto observation = (*opened)->observe([&](const SnapshotPtr& snapshot) {
        const std::lock_guard lock(mutex);
        seen.resize(std::max(seen.size(), static_cast<std::size_t>(snapshot->frame + 1)));
        turns.resize(seen.size());
        turns[static_cast<std::size_t>(snapshot->frame)] = steered_estimate(*snapshot).turn_rad;
        const TrackEstimate estimate = steered_estimate(*snapshot);
        if (estimate.position && estimate.state == TrackState::tracking) {
            seen[static_cast<std::size_t>(snapshot->frame)] = estimate.position;
        }
        over = over || snapshot->run == RunState::ended;
        changed.notify_all();
    });
    ASSERT_TRUE((*opened)->execute(StartTracking{}));
    ASSERT_TRUE((*opened)->execute(Flow{Flow::Kind::run}));
    std::unique_lock lock(mutex);
    ASSERT_TRUE(changed.wait_for(lock, std::chrono::seconds(120), [&] { return over; }));
    int places = 0;
    int inside = 0;
    for (const auto& row : testing_support::rows_of_csv(folder / "truth.csv")) {
        if (std::stoi(row[1]) < 0) {
            continue;
        }
        ++places;
        const auto frame = static_cast<std::size_t>(std::stoi(row[0]));
        ASSERT_TRUE(frame < seen.size() && seen[frame]) << "no position in frame " << frame;
        const Eigen::Vector3d truth(std::stod(row[2]), std::stod(row[3]), std::stod(row[4]));
        const Eigen::Vector3d error = seen[frame]->point_in_left_mm - truth;
        const double chi2 = error.dot(seen[frame]->covariance_mm2.ldlt().solve(error));
        const Eigen::Vector3d sigma = seen[frame]->covariance_mm2.diagonal().cwiseSqrt();
        std::printf("turn %.1f ", turns[frame] * 57.3);
        std::printf("place %2s: error (%+.2f %+.2f %+.2f) mm, sigma (%.2f %.2f %.2f), chi2 %.1f\n",
                    row[1].c_str(), error.x(), error.y(), error.z(), sigma.x(), sigma.y(),
                    sigma.z(), chi2);
        inside += chi2 <= of_95_percent ? 1 : 0;
    }
    std::printf("%d of %d places within their ellipsoids of 95 %%\n", inside, places);
    EXPECT_EQ(places, 15);
    EXPECT_GE(inside, 13);
}

}  // namespace
}  // namespace kambara::cli
