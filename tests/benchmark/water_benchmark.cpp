// SPDX-License-Identifier: GPL-3.0-or-later
// How long the target is kept in simulated water, by the attenuation lengths (one way) that lie
// between it and the camera: with the default method, and with the methods of 1999 beside it.
// Beam attenuation 0.5 and 1.5 per m, drifting particles, a brightness step of 40 % every 3 s, the
// seabed swapped every 2 s. Kept: the state is Tracking and the place in the left picture is within
// 2 px, the position (where there is one) within 3 % of the range. Usage: water_benchmark
// [SEEDS [SECONDS]]
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "core/tracking/stereo_tracker.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

constexpr double bin_lengths = 0.5;
constexpr std::size_t bins = 8;
constexpr double within_px = 2.0;
constexpr double within_share = 0.03;
constexpr double template_share = 0.7;  // of the target's side

struct Tally {
    std::array<int, bins> frames{};
    std::array<int, bins> kept{};
    std::array<int, bins> wrong{};  // said to be tracked, and somewhere else
    int refused = 0;
};

struct Scene0 {
    Rig rig;
    Rectangle templ;
    std::vector<StereoFrame> pairs;
    std::vector<Eigen::Vector3d> truth_in_left_mm;
    double attenuation_per_m = 0.0;
};

std::optional<Eigen::Vector2d> pixel_of(const Rig& rig, const Eigen::Vector3d& point_in_left_mm) {
    return rig.left.project(rig.left.T_camera_from_rig.inverse() * point_in_left_mm);
}

Scene0 drawn(const std::string& profile_text, int frames) {
    const SimulatedWorld world(simulated_profile(profile_text).value());
    Scene0 scene;
    scene.rig = world.rig();
    scene.attenuation_per_m = world.profile().haze_per_m;
    const RigidTransform pose = world.T_left_from_target(0);
    const auto middle = pixel_of(scene.rig, pose.t_mm);
    const auto edge = pixel_of(scene.rig, pose * Eigen::Vector3d(150.0, 0.0, 0.0));
    const int side_px = static_cast<int>(2.0 * template_share * (*edge - *middle).norm());
    scene.templ = world.suggested_template(side_px);
    const auto point =
        world.target_point_under({scene.templ.centre_x_px(), scene.templ.centre_y_px()}, 0);
    for (int i = 0; i < frames; ++i) {
        StereoFrame pair;
        for (auto [camera, frame] : {std::pair(FixedCamera::left, &pair.left),
                                     std::pair(FixedCamera::right, &pair.right)}) {
            frame->picture = std::make_shared<const Image>(world.picture(camera, i));
            frame->index = i;
            frame->time_ns = world.time_ns(i);
        }
        scene.pairs.push_back(std::move(pair));
        scene.truth_in_left_mm.push_back(world.point_in_left_mm(*point, i));
    }
    return scene;
}

bool close(const Scene0& scene, const TrackEstimate& estimate, const Eigen::Vector3d& truth_mm) {
    const auto pixel = pixel_of(scene.rig, truth_mm);
    if (!pixel || !estimate.left_px || (*estimate.left_px - *pixel).norm() > within_px) {
        return false;
    }
    return !estimate.position || (estimate.position->point_in_left_mm - truth_mm).norm() <=
                                     within_share * truth_mm.norm();
}

void follow(const Scene0& scene, const MatchMethod& method, Tally& tally) {
    TrackerOptions options;
    options.search.method = method;
    StereoTracker tracker(scene.rig, options);
    if (!tracker.set_template(scene.pairs.front(), scene.templ) || !tracker.start()) {
        ++tally.refused;
        return;
    }
    for (std::size_t i = 1; i < scene.pairs.size(); ++i) {
        const Eigen::Vector3d& truth_mm = scene.truth_in_left_mm[i];
        const TrackEstimate estimate = tracker.process(scene.pairs[i]);
        const double lengths = scene.attenuation_per_m * 1e-3 * truth_mm.norm();
        const std::size_t bin =
            std::min(bins - 1, static_cast<std::size_t>(lengths / bin_lengths));
        const bool tracking = estimate.state == TrackState::tracking;
        const bool right = close(scene, estimate, truth_mm);
        ++tally.frames[bin];
        tally.kept[bin] += tracking && right ? 1 : 0;
        tally.wrong[bin] += tracking && !right ? 1 : 0;
        if (std::getenv("VERBOSE") != nullptr && !(tracking && right)) {
            std::printf("    %zu %.2f %s q %.2f %s off %.2f %s\n", i, lengths,
                        to_string(estimate.state).c_str(), estimate.quality,
                        right ? "right" : "wrong",
                        estimate.left_px ? (*estimate.left_px -
                                            *pixel_of(scene.rig, truth_mm))
                                               .norm()
                                         : -1.0,
                        estimate.reason.c_str());
        }
    }
}

void print(const char* name, const Tally& tally) {
    int frames = 0;
    int kept = 0;
    int wrong = 0;
    std::printf("  %-22s", name);
    for (std::size_t i = 0; i < bins; ++i) {
        if (tally.frames[i] > 0) {
            std::printf(" %6.1f", 100.0 * tally.kept[i] / tally.frames[i]);
        } else {
            std::printf("      -");
        }
        if (i < 6) {
            frames += tally.frames[i];
            kept += tally.kept[i];
            wrong += tally.wrong[i];
        }
    }
    std::printf("   %6.2f %%  wrong %5.2f %%  refused %d\n", 100.0 * kept / std::max(1, frames),
                100.0 * wrong / std::max(1, frames), tally.refused);
}

int run(int seeds, int frames) {
    const std::vector<std::pair<const char*, MatchMethod>> methods = {
        {"default", TrackerOptions{}.search.method},
        {"zncc", {Measure::zncc, Transform::none}},
        {"zncc after gauss", {Measure::zncc, Transform::gaussian}},
        {"census", {Measure::hamming, Transform::census}},
        {"sdog", {Measure::hamming, Transform::sdog}},
        {"ncc", {Measure::ncc, Transform::none}},
        {"sad", {Measure::sad, Transform::none}}};
    const char* only = std::getenv("ONLY");
    for (const char* water :
         {"haze=0.5&nearest=2&farthest=5.8", "haze=1.5&nearest=0.9&farthest=1.9"}) {
        std::vector<Tally> tallies(methods.size());
        for (int seed = 1; seed <= seeds; ++seed) {
            const Scene0 scene = drawn("default?rate=15&medium=water&particles=200&step=0.4&swap=2&blur=0.3&seed=" +
                                           std::to_string(seed) + "&" + water,
                                       frames);
            for (std::size_t m = 0; m < methods.size(); ++m) {
                if (only == nullptr || std::string(only) == methods[m].first) {
                    Tally before = tallies[m];
                    follow(scene, methods[m].second, tallies[m]);
                    int n = 0, k = 0;
                    for (std::size_t b = 0; b < 6; ++b) { n += tallies[m].frames[b] - before.frames[b]; k += tallies[m].kept[b] - before.kept[b]; }
                    std::printf("    seed %d %-18s template %d px: %.1f %%\n", seed, methods[m].first, scene.templ.width, 100.0*k/std::max(1,n));
                }
            }
        }
        std::printf("%s: frames kept, %%, by attenuation lengths from 0, 0.5, ... 3.5; up to 3\n", water);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            print(methods[m].first, tallies[m]);
        }
    }
    return 0;
}

}  // namespace
}  // namespace kambara

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    const int seeds = argc > 1 ? std::atoi(argv[1]) : 5;
    const double seconds = argc > 2 ? std::atof(argv[2]) : 16.0;
    return kambara::run(seeds, static_cast<int>(15.0 * seconds));
}
