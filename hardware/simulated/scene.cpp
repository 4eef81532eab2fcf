// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/base/angles.h"
#include "hardware/simulated/camera_tilt.h"
#include "hardware/simulated/station_path.h"
#include "hardware/simulated/tones.h"

namespace kambara {
namespace {

constexpr double seabed_below_mm = 1500.0;
constexpr double pose_held_s = 1.0;
constexpr double book_range_mm = 950.0;
constexpr double book_reach_mm = 250.0;
constexpr double step_held_s = 3.0;
constexpr double circle_speed_mm_s = 300.0;
constexpr double circle_range_mm = 1500.0;
// So that even the widest circle stays within the head's tilt.
constexpr double circle_down_mm = 350.0;
constexpr double like_apart_mm = 320.0;  // a little more than the target's side
constexpr float paper_grey = 215.0F;
constexpr float mark_grey = 30.0F;

// The vehicle's bow, in the rig's frame.
const Eigen::Vector3d forward(0.0, -std::sin(cameras_down_rad), std::cos(cameras_down_rad));

// What is moved on a plumb line.
const Eigen::Vector3d plumb_middle_mm(225.0, 100.0, 1300.0);
constexpr double plumb_reach_mm = 300.0;

// The box in which particles drift; leaving it on one side they come in on the other.
const Eigen::Vector3d box_from(-900.0, -600.0, 450.0);
const Eigen::Vector3d box_size(2250.0, 1300.0, 2200.0);

double wave(double time_s, double period_s, double phase) {
    return std::sin(2.0 * std::numbers::pi * time_s / period_s + phase);
}

}  // namespace

Scene::Scene(const SimulatedProfile& profile, std::shared_ptr<HeldTarget> hand,
             const RigidTransform& T_left_from_rig)
    : profile_(profile),
      hand_(std::move(hand)),
      T_left_from_rig_(T_left_from_rig),
      water_(
          water_like(profile.water, profile.haze_per_m, profile.veil_grey, profile.forward_share)),
      snow_(profile.snow_per_litre, profile.seed) {
    std::mt19937 random(profile.seed * 7919U + 17U);
    const TileTexture::Options of_seabed{4096.0, 8.0, 24.0, 400.0, 105.0, 28.0};
    seabed_[0] = std::make_unique<TileTexture>(of_seabed, random());
    if (profile.swap_s > 0.0) {
        seabed_[1] = std::make_unique<TileTexture>(of_seabed, profile.seed * 104729U + 3U);
    }
    if (profile.colour) {
        tones_ = std::make_unique<TileTexture>(
            TileTexture::Options{4096.0, 8.0, 48.0, 400.0, 128.0, 45.0},
            profile.seed * 611953U + 7U);
    }
    pattern_ = std::make_unique<TileTexture>(
        TileTexture::Options{512.0, 1.0, 9.0, 80.0, 128.0, 50.0}, random());
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    for (double& phase : phase_) {
        phase = 2.0 * std::numbers::pi * unit(random);
    }
    for (int i = 0; i < profile.particles; ++i) {
        const Eigen::Vector3d share(unit(random), unit(random), unit(random));
        particles_.push_back(
            {box_from + box_size.cwiseProduct(share),
             Eigen::Vector3d(40.0 * normal(random), 25.0 * normal(random), 25.0 * normal(random)),
             0.8 + 1.6 * unit(random), unit(random) < 0.7 ? 45.0 : -35.0});
    }
    if (profile.calibration_target) {
        arrange_calibration_target(*profile.calibration_target);
    } else {
        const double s = target_half_side_mm;
        for (int i = 0; i <= profile.likes; ++i) {
            // The target, then by turns right and left of it, ever farther.
            const int place = i % 2 == 1 ? (i + 1) / 2 : -i / 2;
            sheets_.push_back({{like_apart_mm * place - s, -s, 0.0},
                               {2.0 * s, 0.0, 0.0},
                               {0.0, 2.0 * s, 0.0},
                               false});
        }
    }
}

void Scene::arrange_calibration_target(const Target& target) {
    for (const TargetPatch& patch : patches_of(target)) {
        if (patch.sheet) {
            sheets_.push_back(patch);
            marks_.emplace_back();
            continue;
        }
        // A mark belongs to the sheet in whose plane it lies.
        for (std::size_t i = 0; i < sheets_.size(); ++i) {
            const Eigen::Vector3d across = sheets_[i].across_mm.normalized();
            const Eigen::Vector3d along = sheets_[i].down_mm.normalized();
            const Eigen::Vector3d from = patch.origin_mm - sheets_[i].origin_mm;
            const Eigen::Vector3d to = from + patch.across_mm + patch.down_mm;
            const Eigen::Vector3d normal = across.cross(along);
            if (std::abs(from.dot(normal)) < 1e-6 && std::abs(to.dot(normal)) < 1e-6) {
                marks_[i].push_back({static_cast<float>(from.dot(across)),
                                     static_cast<float>(from.dot(along)),
                                     static_cast<float>(to.dot(across)),
                                     static_cast<float>(to.dot(along)), patch.dark, patch.round});
                break;
            }
        }
    }
    const auto corners = corners_in_target_mm(target);
    for (const auto& corner : corners) {
        middle_mm_ += corner / static_cast<double>(corners.size());
    }
    double radius = 0.0;
    for (const auto& corner : corners) {
        radius = std::max(radius, (corner - middle_mm_).norm());
    }
    typical_range_mm_ = std::max(600.0, 5.0 * radius);
}

bool Scene::Mark::covers(float across_mm, float down_mm) const {
    if (across_mm < left || across_mm >= right || down_mm < top || down_mm >= bottom) {
        return false;
    }
    const float u = (2.0F * across_mm - left - right) / (right - left);
    const float v = (2.0F * down_mm - top - bottom) / (bottom - top);
    return !round || u * u + v * v < 1.0F;
}

int Scene::seabed_at(double time_s) const {
    return profile_.swap_s > 0.0 ? static_cast<int>(std::floor(time_s / profile_.swap_s)) % seabeds
                                 : 0;
}

double Scene::light(double time_s) const {
    const bool dim = static_cast<int>(std::floor(time_s / step_held_s)) % 2 == 1;
    return dim ? 1.0 - profile_.step : 1.0;
}

double Scene::blur_px_at(double range_mm) const {
    const double range_m = 1e-3 * range_mm;
    return profile_.blur_px * profile_.haze_per_m * range_m;
}

double Scene::seabed_range_mm(const Ray& ray) const {
    const double falls = ray.direction.dot(down_in_rig);
    return falls < 1e-3 ? no_seabed : (seabed_below_mm - ray.origin_mm.dot(down_in_rig)) / falls;
}

float Scene::seabed_grey(int which, const Eigen::Vector3d& hit, double footprint_mm) const {
    return seabed_[which]->at(hit.x(), hit.dot(forward), footprint_mm);
}

template <>
float Scene::seabed(int which, const Ray& ray, double range_mm, double spread) const {
    const double footprint = range_mm * spread / std::sqrt(ray.direction.dot(down_in_rig));
    return seabed_grey(which, ray.at(range_mm), footprint);
}

template <>
Colour Scene::seabed(int which, const Ray& ray, double range_mm, double spread) const {
    const double footprint = range_mm * spread / std::sqrt(ray.direction.dot(down_in_rig));
    const Eigen::Vector3d hit = ray.at(range_mm);
    return seabed_grey(which, hit, footprint) *
           seabed_tone(tones_->at(hit.x(), hit.dot(forward), footprint));
}

std::optional<HeldTarget::At> Scene::held_at(double time_s) const {
    if (!hand_ || !profile_.calibration_target) {
        return std::nullopt;
    }
    const RigidTransform T_left_from_target = T_left_from_rig_ * own_pose(time_s);
    return hand_->at(time_s,
                     {T_left_from_target * middle_mm_, Eigen::Quaterniond(T_left_from_target.R)});
}

RigidTransform Scene::T_rig_from_target(double time_s) const {
    const auto held = held_at(time_s);
    if (!held) {
        return own_pose(time_s);
    }
    const Eigen::Matrix3d R = held->pose.turned.toRotationMatrix();
    return T_left_from_rig_.inverse() * RigidTransform{R, held->pose.middle_mm - R * middle_mm_};
}

RigidTransform Scene::own_pose(double time_s) const {
    if (profile_.calibration_target) {
        // Every pose has its own random numbers, so that any one can be asked for alone.
        const auto pose = static_cast<std::uint32_t>(std::floor(time_s / pose_held_s));
        std::mt19937 random(profile_.seed * 31U + pose * 101U + 5U);
        std::uniform_real_distribution<double> unit(-1.0, 1.0);
        const auto* boxes = std::get_if<BoxTarget>(&*profile_.calibration_target);
        const bool book = boxes != nullptr && boxes->planes.size() > 1;
        const double turn = book ? rad_from_deg(-45.0) : 0.0;  // the edge away from us
        // Farther away, the boxes of two planes are too small for the detector at 640 x 480.
        const double range = book ? book_range_mm + book_reach_mm * unit(random)
                                  : typical_range_mm_ * (1.0 + 0.3 * unit(random));
        const Eigen::Vector3d place(225.0 + 0.12 * range * unit(random),
                                    0.10 * range * unit(random), range);
        Eigen::Matrix3d R =
            rotation_about_y(rad_from_deg(book ? 12.0 : 32.0) * unit(random) + turn) *
            rotation_about_x(rad_from_deg(book ? 12.0 : 28.0) * unit(random));
        const double roll = rad_from_deg(15.0) * unit(random);
        R = Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()).toRotationMatrix() * R;
        return {R, place - R * middle_mm_};
    }
    if (profile_.path == TargetPath::plumb) {
        return {Eigen::Matrix3d::Identity(),
                plumb_middle_mm + plumb_reach_mm * wave(time_s, 8.0, 0.0) * down_in_rig};
    }
    if (profile_.path == TargetPath::stations) {
        return {Eigen::Matrix3d::Identity(), station_path::place_at_mm(time_s)};
    }
    if (profile_.circle_mm > 0.0) {
        // In the plane across the view, so that the head follows all the way.
        const double turned = circle_speed_mm_s * time_s / profile_.circle_mm;
        return {Eigen::Matrix3d::Identity(),
                Eigen::Vector3d(225.0 + profile_.circle_mm * std::cos(turned),
                                circle_down_mm + profile_.circle_mm * std::sin(turned),
                                circle_range_mm)};
    }
    const double middle_mm = 0.5 * (profile_.farthest_mm + profile_.nearest_mm);
    const double reach_mm = 0.5 * (profile_.farthest_mm - profile_.nearest_mm);
    const Eigen::Vector3d place(225.0 + 280.0 * wave(time_s, 10.0, phase_[0]),
                                150.0 + 120.0 * wave(time_s, 7.0, phase_[1]),
                                middle_mm + reach_mm * wave(time_s, 16.0, phase_[2]));
    const double wobble = rad_from_deg(3.0);
    return {rotation_about_y(wobble * wave(time_s, 8.0, phase_[3])) *
                rotation_about_x(wobble * wave(time_s, 11.0, phase_[4])),
            place};
}

std::int64_t Scene::still_since(double time_s) const {
    if (const auto held = held_at(time_s)) {
        return held->still_since;
    }
    if (profile_.path == TargetPath::stations) {
        return station_path::station_at(time_s);
    }
    return profile_.calibration_target ? static_cast<std::int64_t>(std::floor(time_s / pose_held_s))
                                       : -1;
}

float Scene::sheet_grey(std::size_t sheet, float across_mm, float down_mm) const {
    if (marks_.empty()) {
        return pattern_->at(across_mm, down_mm);
    }
    const auto mark = std::find_if(marks_[sheet].rbegin(), marks_[sheet].rend(),
                                   [&](const auto& one) { return one.covers(across_mm, down_mm); });
    if (mark != marks_[sheet].rend()) {
        return mark->dark ? mark_grey : paper_grey;
    }
    return sheets_[sheet].dark ? mark_grey : paper_grey;
}

template <>
float Scene::surface(std::size_t sheet, float across_mm, float down_mm) const {
    return sheet_grey(sheet, across_mm, down_mm);
}

template <>
Colour Scene::surface(std::size_t sheet, float across_mm, float down_mm) const {
    const float grey = sheet_grey(sheet, across_mm, down_mm);
    return marks_.empty() ? Colour(grey * target_tone(across_mm, down_mm)) : Colour::Constant(grey);
}

Eigen::Vector3d Scene::particle_place_mm(const Particle& particle, double time_s) const {
    Eigen::Vector3d place = particle.start_mm + time_s * particle.drift_mm_s - box_from;
    for (int i = 0; i < 3; ++i) {
        place[i] -= box_size[i] * std::floor(place[i] / box_size[i]);
    }
    return place + box_from;
}

}  // namespace kambara
