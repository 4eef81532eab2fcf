// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "core/camera/lens.h"
#include "core/geometry/rigid_transform.h"

namespace kambara {

enum class LensModel { brown, tsai };

/// A lens as the adjustment sees it. Brown: fx fy cx cy k1 k2 p1 p2 k3 k4 k5 k6; Tsai: f_mm
/// kappa1_per_mm2 cx_px cy_px sx, and nothing behind.
using LensBlock = std::array<double, 12>;
LensBlock block_of(const Lens& lens);
Lens lens_of(const LensBlock& block, LensModel model, const Sensor& sensor);

/// The names of a block's parameters, in its order, with units.
std::vector<std::string> parameter_names(LensModel model);

/// A pose as an angle-axis rotation and a translation in mm.
using PoseBlock = std::array<double, 6>;
RigidTransform transform_of(const PoseBlock& pose);
PoseBlock block_of(const RigidTransform& T);

struct BundleCamera {
    LensModel model = LensModel::brown;
    Sensor sensor;         ///< Tsai's
    bool free_k3 = false;  ///< Brown's third radial term; narrow lenses can't tell it
    LensBlock lens{};
    PoseBlock camera_from_first{};  ///< of the first camera: nothing, and held so
};

/// A corner as one camera saw it in one view.
struct BundleCorner {
    int view = 0;
    int camera = 0;
    int id = 0;
    Eigen::Vector2d px;
    double sigma_px = 0.1;
    bool used = true;
};

/// A distance of a camera's centre from the first one's, measured otherwise.
struct BaselinePrior {
    int camera = 1;
    double baseline_mm = 0.0;
    double sigma_mm = 0.0;
};

/// The joint problem: lenses, the cameras' poses, the target's pose in every view, and where asked
/// for the target's own corners.
struct Bundle {
    std::vector<Eigen::Vector3d> target_mm;
    std::vector<double> target_sigma_mm;  ///< a corner each; counts where the target is estimated
    bool estimate_target = false;
    std::vector<BundleCamera> cameras;
    std::vector<PoseBlock> first_from_target;  ///< a view each
    std::vector<BundleCorner> corners;
    std::optional<BaselinePrior> baseline;
};

/// The residual of one corner, predicted minus seen, px; empty where the prediction fails.
std::optional<Eigen::Vector2d> residual_px(const Bundle& bundle, const BundleCorner& corner);

/// Adjusts the bundle in place by Levenberg and Marquardt's method on one thread, so that the same
/// input gives the same digits; every residual counts by its corner's sigma. `robust_px` above 0: a
/// corner that far off counts less (Cauchy's loss). False where it doesn't converge or was stopped.
bool adjust(Bundle& bundle, double robust_px, std::stop_token stop = {});

/// What the corners used leave open.
struct BundleCovariance {
    bool determined = false;       ///< false: the views leave a parameter open
    double variance_factor = 1.0;  ///< of the residuals, in units of the sigmas given
    /// Of all cameras' parameters, 18 each: the lens block, then camera_from_first; zeros for what
    /// is held fixed. Scaled by the residuals' own variance.
    Eigen::MatrixXd cameras;
};
BundleCovariance covariance_of(Bundle& bundle);

inline constexpr int camera_parameters = 18;

}  // namespace kambara
