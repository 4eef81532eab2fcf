// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/station_path.h"

#include <algorithm>
#include <cmath>

#include "core/base/angles.h"

namespace kambara::station_path {
namespace {

constexpr int across = 5;
constexpr int depths = 5;
constexpr double middle_mm = 225.0;  // half the nominal baseline
constexpr double height_step_mm = 250.0;
constexpr double nearest_mm = 1000.0;
constexpr double depth_step_mm = 250.0;
constexpr double angle_step_rad = rad_from_deg(13.0);

// To and fro, so that the next one is always a neighbour.
int serpentine(int index, int count) {
    const int within = index % count;
    return (index / count) % 2 == 0 ? within : count - 1 - within;
}

struct Moment {
    int station;
    double passed_s;
};

// A frame's time may lie a rounding before the station that begins with it.
Moment moment(double time_s) {
    const double whole = std::floor(time_s / station_s + 1e-9);
    const int station = static_cast<int>(std::clamp(whole, 0.0, double(stations - 1)));
    return {station, time_s - station * station_s};
}

}  // namespace

Eigen::Vector3d place_mm(int station) {
    const int row = station / across;
    const double angle = angle_step_rad * (serpentine(station, across) - 2);
    const double depth = nearest_mm + depth_step_mm * serpentine(row, depths);
    const double below = height_step_mm * (row / depths - 1);
    return {middle_mm + depth * std::tan(angle), below, depth};
}

Eigen::Vector3d place_at_mm(double time_s) {
    const auto [station, passed_s] = moment(time_s);
    Eigen::Vector3d from = place_mm(station);
    if (station == stations - 1 || passed_s <= still_s) {
        return from;
    }
    const double share = std::min(1.0, (passed_s - still_s) / (station_s - still_s));
    return from + share * share * (3.0 - 2.0 * share) * (place_mm(station + 1) - from);
}

int station_at(double time_s) {
    const auto [station, passed_s] = moment(time_s);
    return station == stations - 1 || passed_s <= still_s ? station : -1;
}

}  // namespace kambara::station_path
