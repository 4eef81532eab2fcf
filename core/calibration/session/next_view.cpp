// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/next_view.h"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/calibration/session/candidate_poses.h"
#include "core/calibration/session/shot_checks.h"
#include "core/calibration/session/view_information.h"

namespace kambara {
namespace {

// The mean square error that this information leaves. The unknowns differ by many orders, so they
// are scaled to a diagonal of one first.
double left_open(const Eigen::MatrixXd& information, const Eigen::MatrixXd& goal) {
    const Eigen::VectorXd scale =
        information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * information * scale.asDiagonal();
    const Eigen::LDLT<Eigen::MatrixXd> factor(scaled);
    const Eigen::MatrixXd of_scaled = scale.asDiagonal() * goal * scale.asDiagonal();
    return std::max(0.0, factor.solve(of_scaled).trace());
}

Eigen::MatrixXd information_of(const RigGuess& guess, const Target& target,
                               const std::vector<RigView>& views, double noise_px) {
    const auto corners = corners_in_target_mm(target);
    Eigen::MatrixXd sum = guess_information(guess);
    for (const RigView& view : views) {
        const auto pose = first_from_target(guess, corners, view);
        if (!pose) {
            continue;
        }
        std::vector<std::vector<int>> ids(guess.places.size());
        for (std::size_t k = 0; k < ids.size(); ++k) {
            for (const DetectedCorner& corner : view.sights[guess.places[k]].corners) {
                ids[k].push_back(corner.id);
            }
        }
        sum += view_information(guess, corners, *pose, ids, noise_px);
    }
    return sum;
}

// The target as all cameras would see it.
RigView foreseen(const RigGuess& guess, const std::vector<Eigen::Vector3d>& corners,
                 const RigidTransform& T_first_from_target) {
    RigView view;
    for (std::size_t k = 0; k < guess.places.size(); ++k) {
        const BundleCamera& camera = guess.cameras[k];
        const Lens lens = lens_of(camera.lens, camera.model, camera.sensor);
        const RigidTransform T = transform_of(camera.camera_from_first) * T_first_from_target;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (const auto px = project(lens, T * corners[i])) {
                view.sights[guess.places[k]].corners.push_back({static_cast<int>(i), *px});
            }
        }
    }
    return view;
}

bool is_new(const RigView& view, const std::vector<RigView>& kept, double least_change_px) {
    return std::none_of(kept.begin(), kept.end(), [&](const RigView& before) {
        return repeats(view, before, least_change_px);
    });
}

// A pose moved by a share of its distance along the first camera's axes, and turned about them with
// the target's middle held.
RigidTransform moved(const RigidTransform& pose, const Eigen::Vector3d& middle_mm, int axis,
                     double share, double turn_rad) {
    const Eigen::Vector3d at = pose * middle_mm;
    const Eigen::Vector3d along = Eigen::Vector3d::Unit(axis);
    RigidTransform T;
    T.R = Eigen::AngleAxisd(turn_rad, along).toRotationMatrix() * pose.R;
    T.t_mm = at + share * at.z() * along - T.R * middle_mm;
    return T;
}

// Walks from a pose to better ones beside it, in ever smaller steps.
template <typename Value>
RigidTransform refined(RigidTransform pose, const Eigen::Vector3d& middle_mm, const Value& value) {
    constexpr double first_share = 0.08;
    constexpr double first_turn_rad = 0.2;
    constexpr int halvings = 3;
    constexpr int most_rounds = 4;
    double least = value(pose);
    for (int halving = 0; halving < halvings; ++halving) {
        const double size = std::pow(0.5, halving);
        bool better = true;
        for (int round = 0; better && round < most_rounds; ++round) {
            better = false;
            for (int move = 0; move < 12; ++move) {
                const double step = move % 2 == 0 ? size : -size;
                const bool turns = move >= 6;
                const RigidTransform next =
                    moved(pose, middle_mm, move / 2 % 3, turns ? 0.0 : step * first_share,
                          turns ? step * first_turn_rad : 0.0);
                const double now = value(next);
                if (now < least) {
                    least = now;
                    pose = next;
                    better = true;
                }
            }
        }
    }
    return pose;
}

void outline(const RigGuess& guess, const Target& target, NextView& view) {
    const RigView seen = foreseen(guess, corners_in_target_mm(target), view.T_left_from_target);
    for (std::size_t k = 0; k < guess.places.size(); ++k) {
        const std::size_t place = guess.places[k];
        for (const DetectedCorner& corner : seen.sights[place].corners) {
            view.corners_px[place].push_back(corner.px);
        }
        for (const TargetPatch& patch : patches_of(target)) {
            if (!patch.sheet) {
                continue;
            }
            std::vector<Eigen::Vector2d> shape;
            for (const Eigen::Vector3d& at :
                 {patch.origin_mm, Eigen::Vector3d(patch.origin_mm + patch.across_mm),
                  Eigen::Vector3d(patch.origin_mm + patch.across_mm + patch.down_mm),
                  Eigen::Vector3d(patch.origin_mm + patch.down_mm)}) {
                if (const auto px = pixel_in(guess, k, view.T_left_from_target, at)) {
                    shape.push_back(*px);
                }
            }
            view.outlines_px[place].push_back(std::move(shape));
        }
    }
}

}  // namespace

double predicted_range_error(const RigGuess& guess, const Target& target,
                             const std::vector<RigView>& views, const NextViewOptions& options) {
    return std::sqrt(left_open(information_of(guess, target, views, options.noise_px),
                               volume_goal(guess, options.volume)));
}

std::optional<NextView> next_view(const RigGuess& guess, const Target& target,
                                  const std::vector<RigView>& views,
                                  const NextViewOptions& options) {
    const auto corners = corners_in_target_mm(target);
    std::vector<int> every(corners.size());
    std::iota(every.begin(), every.end(), 0);
    const std::vector<std::vector<int>> ids(guess.cameras.size(), every);
    const Eigen::MatrixXd goal = volume_goal(guess, options.volume);
    const Eigen::MatrixXd so_far = information_of(guess, target, views, options.noise_px);
    const double never = std::numeric_limits<double>::infinity();
    const auto error_after = [&](const RigidTransform& pose) {
        return left_open(
            so_far + view_information(guess, corners, block_of(pose), ids, options.noise_px), goal);
    };
    double least = never;
    std::optional<NextView> best;
    for (const RigidTransform& pose : candidate_poses(guess, target)) {
        const double after = error_after(pose);
        if (after < least &&
            is_new(foreseen(guess, corners, pose), views, options.least_change_px)) {
            least = after;
            best.emplace();
            best->T_left_from_target = pose;
        }
    }
    if (best) {
        best->T_left_from_target =
            refined(best->T_left_from_target, middle_of(corners), [&](const RigidTransform& pose) {
                return can_be_found(guess, target, pose) && is_new(foreseen(guess, corners, pose),
                                                                   views, options.least_change_px)
                           ? error_after(pose)
                           : never;
            });
        best->range_error_before = std::sqrt(left_open(so_far, goal));
        best->range_error_after = std::sqrt(error_after(best->T_left_from_target));
        outline(guess, target, *best);
    }
    return best;
}

}  // namespace kambara
