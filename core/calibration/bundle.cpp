// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <cmath>
#include <utility>

#include "core/camera/lens_functions.h"

namespace kambara {
namespace {

template <class T>
void moved(const T* pose, const T* point, T* result) {
    ceres::AngleAxisRotatePoint(pose, point, result);
    for (int i = 0; i < 3; ++i) {
        result[i] += pose[3 + i];
    }
}

template <class T>
void pixel_residual(const T* lens, const T* point, const Eigen::Vector2d& seen, T* residual) {
    T pixel[2];
    const T x = point[0] / point[2];
    const T y = point[1] / point[2];
    brown_pixel(lens, x, y, pixel);
    residual[0] = pixel[0] - seen.x();
    residual[1] = pixel[1] - seen.y();
}

struct LeftCorner {
    Eigen::Vector3d on_board_mm;
    Eigen::Vector2d seen_px;

    template <class T>
    bool operator()(const T* lens, const T* left_from_board, T* residual) const {
        const T point[3] = {T(on_board_mm.x()), T(on_board_mm.y()), T(on_board_mm.z())};
        T in_left[3];
        moved(left_from_board, point, in_left);
        pixel_residual(lens, in_left, seen_px, residual);
        return true;
    }
};

struct RightCorner {
    Eigen::Vector3d on_board_mm;
    Eigen::Vector2d seen_px;

    template <class T>
    bool operator()(const T* lens, const T* right_from_left, const T* left_from_board,
                    T* residual) const {
        const T point[3] = {T(on_board_mm.x()), T(on_board_mm.y()), T(on_board_mm.z())};
        T in_left[3];
        T in_right[3];
        moved(left_from_board, point, in_left);
        moved(right_from_left, in_left, in_right);
        pixel_residual(lens, in_right, seen_px, residual);
        return true;
    }
};

// Ends the solver when the caller has had enough.
class StopWhenAsked final : public ceres::IterationCallback {
  public:
    explicit StopWhenAsked(std::stop_token stop) : stop_(std::move(stop)) {}
    ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
        return stop_.stop_requested() ? ceres::SOLVER_ABORT : ceres::SOLVER_CONTINUE;
    }

  private:
    std::stop_token stop_;
};

double squared_residuals(ceres::Problem& problem,
                         const std::vector<ceres::ResidualBlockId>& blocks) {
    ceres::Problem::EvaluateOptions options;
    options.residual_blocks = blocks;
    double cost = 0.0;
    if (blocks.empty() || !problem.Evaluate(options, &cost, nullptr, nullptr, nullptr)) {
        return 0.0;
    }
    return 2.0 * cost;
}

}  // namespace

BundleResult adjust(Bundle& bundle, std::stop_token stop) {
    const bool stereo = !bundle.right_px.empty();
    ceres::Problem problem;
    std::vector<ceres::ResidualBlockId> left_blocks;
    std::vector<ceres::ResidualBlockId> right_blocks;
    for (std::size_t view = 0; view < bundle.left_px.size(); ++view) {
        double* pose = bundle.left_from_board[view].data();
        for (std::size_t i = 0; i < bundle.board_mm.size(); ++i) {
            left_blocks.push_back(problem.AddResidualBlock(
                new ceres::AutoDiffCostFunction<LeftCorner, 2, 12, 6>(
                    new LeftCorner{bundle.board_mm[i], bundle.left_px[view][i]}),
                nullptr, bundle.left.data(), pose));
            if (stereo) {
                right_blocks.push_back(problem.AddResidualBlock(
                    new ceres::AutoDiffCostFunction<RightCorner, 2, 12, 6, 6>(
                        new RightCorner{bundle.board_mm[i], bundle.right_px[view][i]}),
                    nullptr, bundle.right.data(), bundle.right_from_left.data(), pose));
            }
        }
    }
    std::vector<int> fixed{9, 10, 11};  // the dividing terms
    if (!bundle.free_k3) {
        fixed.insert(fixed.begin(), 8);
    }
    problem.SetManifold(bundle.left.data(), new ceres::SubsetManifold(12, fixed));
    if (stereo) {
        problem.SetManifold(bundle.right.data(), new ceres::SubsetManifold(12, fixed));
    }

    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.max_num_iterations = 100;
    options.function_tolerance = 1e-12;
    options.parameter_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    StopWhenAsked stopper(std::move(stop));
    options.callbacks.push_back(&stopper);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);

    BundleResult result;
    result.converged = summary.IsSolutionUsable();
    result.left_sum_px2 = squared_residuals(problem, left_blocks);
    result.right_sum_px2 = squared_residuals(problem, right_blocks);
    if (!result.converged) {
        return result;
    }
    ceres::Covariance::Options covariance_options;
    ceres::Covariance covariance(covariance_options);
    std::vector<std::pair<const double*, const double*>> wanted{
        {bundle.left.data(), bundle.left.data()}};
    if (stereo) {
        wanted.emplace_back(bundle.right.data(), bundle.right.data());
        wanted.emplace_back(bundle.right_from_left.data(), bundle.right_from_left.data());
    }
    if (!covariance.Compute(wanted, &problem)) {
        result.converged = false;  // the views leave a parameter undetermined
        return result;
    }
    const double freedom = static_cast<double>(summary.num_residuals_reduced) -
                           static_cast<double>(summary.num_effective_parameters_reduced);
    const double variance = (result.left_sum_px2 + result.right_sum_px2) / std::max(1.0, freedom);
    const auto sigmas = [&](const double* block, Bundle::LensParameters& sigma) {
        Eigen::Matrix<double, 12, 12, Eigen::RowMajor> C;
        covariance.GetCovarianceBlock(block, block, C.data());
        for (int i = 0; i < 12; ++i) {
            sigma[static_cast<std::size_t>(i)] = std::sqrt(std::max(0.0, C(i, i)) * variance);
        }
    };
    sigmas(bundle.left.data(), result.left_sigma);
    if (stereo) {
        sigmas(bundle.right.data(), result.right_sigma);
        Eigen::Matrix<double, 6, 6, Eigen::RowMajor> C;
        covariance.GetCovarianceBlock(bundle.right_from_left.data(), bundle.right_from_left.data(),
                                      C.data());
        result.translation_covariance_mm2 = variance * C.bottomRightCorner<3, 3>();
    }
    return result;
}

}  // namespace kambara
