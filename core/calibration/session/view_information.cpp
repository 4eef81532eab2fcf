// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/view_information.h"

#include <ceres/jet.h>
#include <ceres/rotation.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>

#include "core/base/angles.h"
#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

// Of a camera beside the pair that measures: it only has to aim.
constexpr double bearing_weight = 0.1;

// One camera's parameters, then the pose of what is seen.
constexpr int pose_at = camera_parameters;
constexpr int unknowns = camera_parameters + 6;
using Jet = ceres::Jet<double, unknowns>;

struct Seen {
    Eigen::Vector2d px;
    Eigen::Matrix<double, 2, unknowns> by;
};

template <std::size_t n>
std::array<Jet, n> free(const std::array<double, n>& values, int first) {
    std::array<Jet, n> jets;
    for (std::size_t i = 0; i < n; ++i) {
        jets[i] = Jet(values[i], first + static_cast<int>(i));
    }
    return jets;
}

void move(const std::array<Jet, 6>& pose, std::array<Jet, 3>& point) {
    std::array<Jet, 3> turned;
    ceres::AngleAxisRotatePoint(pose.data(), point.data(), turned.data());
    for (std::size_t i = 0; i < 3; ++i) {
        point[i] = turned[i] + pose[3 + i];
    }
}

// The pixel of a corner and its derivatives; empty where the camera can't see it.
std::optional<Seen> seen(const BundleCamera& camera, const PoseBlock& first_from_target,
                         const Eigen::Vector3d& on_target_mm) {
    const auto lens = free(camera.lens, 0);
    std::array<Jet, 3> point{Jet(on_target_mm.x()), Jet(on_target_mm.y()), Jet(on_target_mm.z())};
    move(free(first_from_target, pose_at), point);
    move(free(camera.camera_from_first, 12), point);
    if (!(point[2].a > 1e-3)) {
        return std::nullopt;
    }
    const Jet x = point[0] / point[2];
    const Jet y = point[1] / point[2];
    std::array<Jet, 2> pixel;
    if (camera.model == LensModel::brown) {
        brown_pixel(lens.data(), x, y, pixel.data());
    } else {
        tsai_pixel(lens.data(), camera.sensor.dx_prime_mm(), camera.sensor.dy_mm, x, y,
                   pixel.data());
    }
    Seen result;
    result.px = {pixel[0].a, pixel[1].a};
    result.by.row(0) = pixel[0].v.transpose();
    result.by.row(1) = pixel[1].v.transpose();
    if (!result.px.allFinite() || !result.by.allFinite()) {
        return std::nullopt;
    }
    return result;
}

// A point of the first camera's frame, which is the target's then.
std::optional<Seen> seen_point(const BundleCamera& camera, const Eigen::Vector3d& in_first_mm) {
    return seen(camera, {0.0, 0.0, 0.0, in_first_mm.x(), in_first_mm.y(), in_first_mm.z()},
                Eigen::Vector3d::Zero());
}

bool inside(const Eigen::Vector2d& px, const PictureSize& size) {
    return px.minCoeff() >= 0.0 && px.x() <= size.width_px - 1 && px.y() <= size.height_px - 1;
}

int lens_parameters(const BundleCamera& camera) {
    return camera.model == LensModel::tsai ? 5 : camera.free_k3 ? 9 : 8;
}

// Sums of what single places add to the goal.
class Goal {
  public:
    explicit Goal(const RigGuess& guess)
        : guess_(guess),
          matrix_(Eigen::MatrixXd::Zero(all(), all())),
          pair_(guess.places.size() > 1 && guess.places[1] == 1) {}

    void add(const Eigen::Vector3d& at_mm) {
        if (pair_ && !add_range(at_mm)) {
            return;
        }
        ++places_;
        for (std::size_t k = pair_ ? 2 : 0; k < guess_.cameras.size(); ++k) {
            add_bearing(k, at_mm);
        }
    }

    Eigen::MatrixXd mean() const {
        const std::vector<int> open = open_parameters(guess_);
        return matrix_(open, open) / std::max(1, places_);
    }

  private:
    Eigen::Index all() const {
        return static_cast<Eigen::Index>(guess_.cameras.size()) * camera_parameters;
    }

    // How the range of least reprojection error answers to the parameters.
    bool add_range(const Eigen::Vector3d& at_mm) {
        const auto left = seen_point(guess_.cameras[0], at_mm);
        const auto right = seen_point(guess_.cameras[1], at_mm);
        if (!left || !right || !inside(left->px, guess_.sizes[0]) ||
            !inside(right->px, guess_.sizes[1])) {
            return false;
        }
        Eigen::Matrix<double, 4, 3> by_point;
        by_point << left->by.middleCols<3>(pose_at + 3), right->by.middleCols<3>(pose_at + 3);
        const Eigen::RowVector4d range_by_pixel = at_mm.normalized().transpose() *
                                                  (by_point.transpose() * by_point).inverse() *
                                                  by_point.transpose();
        Eigen::VectorXd by = Eigen::VectorXd::Zero(all());
        by.head<camera_parameters>() =
            (range_by_pixel.head<2>() * left->by.leftCols<camera_parameters>()).transpose();
        by.segment<camera_parameters>(camera_parameters) =
            (range_by_pixel.tail<2>() * right->by.leftCols<camera_parameters>()).transpose();
        matrix_ += by * by.transpose() / at_mm.squaredNorm();
        return true;
    }

    void add_bearing(std::size_t camera, const Eigen::Vector3d& at_mm) {
        const auto there = seen_point(guess_.cameras[camera], at_mm);
        if (!there || !inside(there->px, guess_.sizes[camera])) {
            return;
        }
        const BundleCamera& c = guess_.cameras[camera];
        const double f_px = pinhole_parameters(lens_of(c.lens, c.model, c.sensor)).fy_px;
        const auto from = static_cast<Eigen::Index>(camera) * camera_parameters;
        matrix_.block<camera_parameters, camera_parameters>(from, from) +=
            (pair_ ? bearing_weight : 1.0) / (f_px * f_px) *
            there->by.leftCols<camera_parameters>().transpose() *
            there->by.leftCols<camera_parameters>();
    }

    const RigGuess& guess_;
    Eigen::MatrixXd matrix_;
    bool pair_;
    int places_ = 0;
};

// The rig's frame, of which only the direction of its axes counts for one camera.
RigidTransform left_from_rig(const RigGuess& guess) {
    if (guess.cameras.size() < 2 || guess.places[1] != 1) {
        return {};
    }
    Camera left;
    Camera right;
    return rig_from_pair(left, right, transform_of(guess.cameras[1].camera_from_first))
        .left.T_camera_from_rig;
}

}  // namespace

std::vector<int> open_parameters(const RigGuess& guess) {
    std::vector<int> open;
    for (std::size_t k = 0; k < guess.cameras.size(); ++k) {
        const int first = static_cast<int>(k) * camera_parameters;
        for (int i = 0; i < lens_parameters(guess.cameras[k]); ++i) {
            open.push_back(first + i);
        }
        for (int i = 12; k > 0 && i < camera_parameters; ++i) {
            open.push_back(first + i);
        }
    }
    return open;
}

Eigen::MatrixXd view_information(const RigGuess& guess,
                                 const std::vector<Eigen::Vector3d>& target_mm,
                                 const PoseBlock& first_from_target,
                                 const std::vector<std::vector<int>>& ids, double noise_px) {
    const auto all = static_cast<Eigen::Index>(guess.cameras.size()) * camera_parameters;
    Eigen::MatrixXd cameras = Eigen::MatrixXd::Zero(all, all);
    Eigen::MatrixXd mixed = Eigen::MatrixXd::Zero(all, 6);
    Eigen::Matrix<double, 6, 6> pose = Eigen::Matrix<double, 6, 6>::Zero();
    for (std::size_t k = 0; k < guess.cameras.size(); ++k) {
        Eigen::Matrix<double, unknowns, unknowns> sum =
            Eigen::Matrix<double, unknowns, unknowns>::Zero();
        for (const int id : ids[k]) {
            if (const auto corner = seen(guess.cameras[k], first_from_target,
                                         target_mm[static_cast<std::size_t>(id)])) {
                sum.noalias() += corner->by.transpose() * corner->by;
            }
        }
        const auto from = static_cast<Eigen::Index>(k) * camera_parameters;
        cameras.block<camera_parameters, camera_parameters>(from, from) =
            sum.topLeftCorner<camera_parameters, camera_parameters>();
        mixed.middleRows<camera_parameters>(from) = sum.topRightCorner<camera_parameters, 6>();
        pose += sum.bottomRightCorner<6, 6>();
    }
    const std::vector<int> open = open_parameters(guess);
    const Eigen::MatrixXd of_open = mixed(open, Eigen::all);
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factor(pose);
    if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 0.0)) {
        return Eigen::MatrixXd::Zero(of_open.rows(), of_open.rows());
    }
    const Eigen::MatrixXd left_over =
        cameras(open, open) - of_open * factor.solve(of_open.transpose());
    return left_over / (noise_px * noise_px);
}

Eigen::MatrixXd guess_information(const RigGuess& guess) {
    const std::vector<int> open = open_parameters(guess);
    Eigen::VectorXd weights(static_cast<Eigen::Index>(open.size()));
    for (std::size_t i = 0; i < open.size(); ++i) {
        const auto k = static_cast<std::size_t>(open[i] / camera_parameters);
        const int parameter = open[i] % camera_parameters;
        const BundleCamera& camera = guess.cameras[k];
        const double centre_px = 0.1 * guess.sizes[k].width_px;
        double sigma = parameter >= 15 ? 200.0 : 0.2;  // mm; rad
        if (parameter < 12 && camera.model == LensModel::brown) {
            constexpr std::array distortion{0.5, 0.5, 0.02, 0.02, 0.5};
            sigma = parameter < 2   ? 0.2 * camera.lens[static_cast<std::size_t>(parameter)]
                    : parameter < 4 ? centre_px
                                    : distortion[std::min<std::size_t>(
                                          4, static_cast<std::size_t>(std::max(0, parameter - 4)))];
        } else if (parameter < 12) {
            const double half_mm = 0.5 * guess.sizes[k].width_px * camera.sensor.dx_prime_mm();
            const std::array tsai{0.2 * camera.lens[0], 0.3 / (half_mm * half_mm), centre_px,
                                  centre_px, 0.05};
            sigma = tsai[static_cast<std::size_t>(parameter)];
        }
        weights[static_cast<Eigen::Index>(i)] = 1.0 / (sigma * sigma);
    }
    return weights.asDiagonal();
}

Eigen::MatrixXd volume_goal(const RigGuess& guess, const RangeErrorOptions& options) {
    Goal goal(guess);
    const RigidTransform T_left_from_rig = left_from_rig(guess);
    Eigen::Vector3d middle_in_rig = Eigen::Vector3d::Zero();
    if (guess.cameras.size() > 1 && guess.places[1] == 1) {
        middle_in_rig = 0.5 * (T_left_from_rig.inverse() *
                               transform_of(guess.cameras[1].camera_from_first).centre_mm());
    }
    for (int azimuth = -2; azimuth <= 2; ++azimuth) {
        for (int height = -1; height <= 1; ++height) {
            for (int depth = 0; depth < 5; ++depth) {
                const double z =
                    options.nearest_mm + 0.25 * depth * (options.farthest_mm - options.nearest_mm);
                const double x = z * std::tan(rad_from_deg(0.5 * azimuth * options.azimuth_deg));
                goal.add(T_left_from_rig *
                         (middle_in_rig + Eigen::Vector3d(x, height * options.height_mm, z)));
            }
        }
    }
    return goal.mean();
}

}  // namespace kambara
