// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/murky_water.h"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

#include "core/tracking/stereo_tracker.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

constexpr double rate_hz = 15.0;
constexpr double within_px = 2.0;
constexpr double within_share = 0.03;
constexpr double template_share = 0.7;

std::optional<Eigen::Vector2d> left_pixel(const Rig& rig, const Eigen::Vector3d& in_left_mm) {
    return rig.left.project(rig.left.T_camera_from_rig.inverse() * in_left_mm);
}

Rectangle template_on(const SimulatedWorld& world) {
    const RigidTransform pose = world.T_left_from_target(0);
    const Eigen::Vector3d to_edge_mm(Scene::target_half_side_mm, 0.0, 0.0);
    const auto middle = left_pixel(world.rig(), pose.t_mm);
    const auto edge = left_pixel(world.rig(), pose * to_edge_mm);
    const double side_px = 2.0 * template_share * (edge.value() - middle.value()).norm();
    return world.suggested_template(static_cast<int>(side_px));
}

bool is_there(const Rig& rig, const TrackEstimate& estimate, const Eigen::Vector3d& truth_mm) {
    const auto pixel = left_pixel(rig, truth_mm);
    if (!pixel || !estimate.left_px || (*estimate.left_px - *pixel).norm() > within_px) {
        return false;
    }
    return !estimate.position || (estimate.position->point_in_left_mm - truth_mm).norm() <=
                                     within_share * truth_mm.norm();
}

double share_to_3_lengths(const KeptFrames& of, const std::array<int, KeptFrames::bins>& counts) {
    const auto sum = [](const auto& all) {
        return std::accumulate(all.begin(), all.begin() + KeptFrames::bins_to_3_lengths, 0);
    };
    return static_cast<double>(sum(counts)) / std::max(1, sum(of.frames));
}

}  // namespace

double KeptFrames::kept_to_3_lengths() const {
    return share_to_3_lengths(*this, kept);
}

double KeptFrames::wrong_to_3_lengths() const {
    return share_to_3_lengths(*this, wrong);
}

MurkyScene murky_scene(const std::string& water, int seed, double seconds) {
    const SimulatedWorld world(
        simulated_profile("default?rate=15&medium=water&particles=200&step=0.4&swap=2&blur=0.3&"
                          "seed=" +
                          std::to_string(seed) + "&" + water)
            .value());
    MurkyScene scene;
    scene.rig = world.rig();
    scene.attenuation_per_m = world.profile().haze_per_m;
    scene.templ = template_on(world);
    const auto point =
        world.target_point_under({scene.templ.centre_x_px(), scene.templ.centre_y_px()}, 0);
    for (int i = 0; i < static_cast<int>(rate_hz * seconds); ++i) {
        StereoFrame pair;
        for (auto [camera, frame] : {std::pair(FixedCamera::left, &pair.left),
                                     std::pair(FixedCamera::right, &pair.right)}) {
            frame->picture = std::make_shared<const Image>(world.picture(camera, i));
            frame->index = i;
            frame->time_ns = world.time_ns(i);
        }
        scene.pairs.push_back(std::move(pair));
        scene.truth_in_left_mm.push_back(world.point_in_left_mm(point.value(), i));
    }
    return scene;
}

void follow(const MurkyScene& scene, const MatchMethod& method, KeptFrames& counts) {
    TrackerOptions options;
    options.search.method = method;
    StereoTracker tracker(scene.rig, options);
    if (!tracker.set_template(scene.pairs.front(), scene.templ) || !tracker.start()) {
        ++counts.refused;
    }
    for (std::size_t i = 1; i < scene.pairs.size(); ++i) {
        const Eigen::Vector3d& truth_mm = scene.truth_in_left_mm[i];
        const double lengths = scene.attenuation_per_m * 1e-3 * truth_mm.norm();
        const auto bin = std::min(KeptFrames::bins - 1,
                                  static_cast<std::size_t>(lengths / KeptFrames::bin_lengths));
        const TrackEstimate estimate = tracker.process(scene.pairs[i]);
        const bool tracking = estimate.state == TrackState::tracking;
        const bool there = is_there(scene.rig, estimate, truth_mm);
        ++counts.frames[bin];
        counts.kept[bin] += tracking && there ? 1 : 0;
        counts.wrong[bin] += tracking && !there ? 1 : 0;
    }
}

}  // namespace kambara
