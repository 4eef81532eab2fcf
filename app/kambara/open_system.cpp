// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/open_system.h"

#include <memory>

#include "app/sources/heads.h"
#include "app/sources/sources.h"
#include "hardware/simulated/held_target.h"
#include "hardware/simulated/simulated_world.h"
#include "hardware/simulated/station_path.h"

namespace kambara {
namespace {

ui::TargetHand hand_of(const Sources& sources) {
    if (!sources.hand) {
        return {};
    }
    const Target target = *sources.world->profile().calibration_target;
    const auto corners = corners_in_target_mm(target);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& corner : corners) {
        middle += corner / static_cast<double>(corners.size());
    }
    ui::TargetHand hand;
    hand.target = to_string(target);
    hand.hold = [held = sources.hand, middle](const RigidTransform& T, bool by_helper) {
        held->hold({T * middle, Eigen::Quaterniond(T.R)}, by_helper);
    };
    hand.let_go = [held = sources.hand] { held->let_go(); };
    return hand;
}

ui::SimulatedStations stations_of(const Sources& sources) {
    ui::SimulatedStations stations;
    if (!sources.world || sources.world->profile().path != TargetPath::stations) {
        return stations;
    }
    const auto world = sources.world;
    stations.count = station_path::stations;
    stations.target = [world](std::int64_t frame) { return world->suggested_template(31, frame); };
    stations.station_in = [world](std::int64_t frame) {
        return station_path::station_at(static_cast<double>(frame) / world->profile().rate_hz);
    };
    stations.known_in_left_mm = [world](const Eigen::Vector2d& left_px, std::int64_t seen_in,
                                        std::int64_t frame) -> std::optional<Eigen::Vector3d> {
        const auto point = world->target_point_under(left_px, seen_in);
        return point ? std::optional(world->point_in_left_mm(*point, frame)) : std::nullopt;
    };
    return stations;
}

}  // namespace

ui::SystemOpener system_opener(Clock& clock, const std::string& pan_tilt) {
    return [&clock, pan_tilt, head = std::shared_ptr<PanTiltCamera>()](
               const ui::SourceRequest& request) mutable -> Result<ui::OpenedSystem> {
        SourceOptions options;
        if (!pan_tilt.empty() && !head) {
            auto opened = open_head(pan_tilt, clock);
            if (!opened) {
                return opened.error();
            }
            head = std::move(*opened);
        }
        options.head = head;
        options.left = request.left;
        options.right = request.right;
        options.rig = request.rig;
        options.pictures_rate_hz = request.pictures_rate_hz;
        options.live = true;
        options.pan_tilt_pictures = true;
        auto sources = open_sources(options, clock);
        if (!sources) {
            return sources.error();
        }
        VisionSystemOptions system_options;
        system_options.every_frame = sources->every_frame;
        system_options.in_real_time = sources->every_frame;
        system_options.start_paused = sources->every_frame;
        const ui::TargetHand hand = hand_of(*sources);
        const ui::SimulatedStations stations = stations_of(*sources);
        auto system = open_vision_system(std::move(sources->parts), system_options, clock);
        if (!system) {
            return system.error();
        }
        return ui::OpenedSystem{std::move(*system), hand, stations};
    };
}

}  // namespace kambara
