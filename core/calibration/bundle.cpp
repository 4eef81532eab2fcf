// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/bundle.h"

#include <ceres/ceres.h>
#include <ceres/rotation.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <memory>
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

// A corner's residual over its sigma, for whichever blocks take part.
struct CornerCost {
    LensModel model;
    double dx_prime_mm;
    double dy_mm;
    Eigen::Vector2d seen_px;
    double weight_per_px;
    Eigen::Vector3d on_target_mm;

    template <class T>
    bool pixel(const T* lens, const T* point, T* result) const {
        if (!(value_of(point[2]) > 1e-3)) {
            return false;
        }
        const T x = point[0] / point[2];
        const T y = point[1] / point[2];
        if (model == LensModel::brown) {
            brown_pixel(lens, x, y, result);
        } else {
            tsai_pixel(lens, dx_prime_mm, dy_mm, x, y, result);
        }
        return std::isfinite(value_of(result[0])) && std::isfinite(value_of(result[1]));
    }

    template <class T>
    bool weighed(const T* lens, const T* point, T* residual) const {
        if (!pixel(lens, point, residual)) {
            return false;
        }
        residual[0] = weight_per_px * (residual[0] - seen_px.x());
        residual[1] = weight_per_px * (residual[1] - seen_px.y());
        return true;
    }
};

struct FirstCamera : CornerCost {
    template <class T>
    bool operator()(const T* lens, const T* first_from_target, T* residual) const {
        const T at[3] = {T(on_target_mm.x()), T(on_target_mm.y()), T(on_target_mm.z())};
        return (*this)(lens, first_from_target, at, residual);
    }
    template <class T>
    bool operator()(const T* lens, const T* first_from_target, const T* at, T* residual) const {
        T point[3];
        moved(first_from_target, at, point);
        return weighed(lens, point, residual);
    }
};

struct OtherCamera : CornerCost {
    template <class T>
    bool operator()(const T* lens, const T* camera_from_first, const T* first_from_target,
                    T* residual) const {
        const T at[3] = {T(on_target_mm.x()), T(on_target_mm.y()), T(on_target_mm.z())};
        return (*this)(lens, camera_from_first, first_from_target, at, residual);
    }
    template <class T>
    bool operator()(const T* lens, const T* camera_from_first, const T* first_from_target,
                    const T* at, T* residual) const {
        T in_first[3];
        T point[3];
        moved(first_from_target, at, in_first);
        moved(camera_from_first, in_first, point);
        return weighed(lens, point, residual);
    }
};

struct BaselineCost {
    double baseline_mm;
    double weight_per_mm;

    template <class T>
    bool operator()(const T* pose, T* residual) const {
        const T length = sqrt(pose[3] * pose[3] + pose[4] * pose[4] + pose[5] * pose[5]);
        residual[0] = weight_per_mm * (length - baseline_mm);
        return true;
    }
};

struct TargetCost {
    Eigen::Vector3d drawn_mm;
    double weight_per_mm;

    template <class T>
    bool operator()(const T* at, T* residual) const {
        for (int i = 0; i < 3; ++i) {
            residual[i] = weight_per_mm * (at[i] - drawn_mm[i]);
        }
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

CornerCost cost_of(const Bundle& bundle, const BundleCorner& corner) {
    const BundleCamera& camera = bundle.cameras[static_cast<std::size_t>(corner.camera)];
    return {camera.model,          camera.sensor.dx_prime_mm(),
            camera.sensor.dy_mm,   corner.px,
            1.0 / corner.sigma_px, bundle.target_mm[static_cast<std::size_t>(corner.id)]};
}

// Which of a lens block's parameters stay as they are.
std::vector<int> held(const BundleCamera& camera) {
    if (camera.model == LensModel::tsai) {
        return {5, 6, 7, 8, 9, 10, 11};
    }
    return camera.free_k3 ? std::vector<int>{9, 10, 11} : std::vector<int>{8, 9, 10, 11};
}

// The bundle as Ceres sees it; the parameters live in the bundle, which must not move meanwhile.
class Problem {
  public:
    Problem(Bundle& bundle, double robust_px) : bundle_(bundle), at_(bundle.target_mm) {
        for (const BundleCorner& corner : bundle.corners) {
            if (corner.used) {
                add(corner, robust_px);
            }
        }
        for (BundleCamera& camera : bundle.cameras) {
            if (problem_.HasParameterBlock(camera.lens.data())) {
                problem_.SetManifold(camera.lens.data(),
                                     new ceres::SubsetManifold(12, held(camera)));
            }
        }
        if (bundle.baseline) {
            double* pose = bundle.cameras[static_cast<std::size_t>(bundle.baseline->camera)]
                               .camera_from_first.data();
            if (problem_.HasParameterBlock(pose)) {
                problem_.AddResidualBlock(
                    new ceres::AutoDiffCostFunction<BaselineCost, 1, 6>(new BaselineCost{
                        bundle.baseline->baseline_mm, 1.0 / bundle.baseline->sigma_mm}),
                    nullptr, pose);
            }
        }
        if (bundle.estimate_target) {
            add_target_priors();
        }
    }

    ceres::Problem& problem() { return problem_; }

    // The views' poses are eliminated first: they depend on each other through the rest only.
    std::shared_ptr<ceres::ParameterBlockOrdering> ordering() {
        auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
        std::vector<double*> blocks;
        problem_.GetParameterBlocks(&blocks);
        for (double* block : blocks) {
            ordering->AddElementToGroup(block, is_view(block) ? 0 : 1);
        }
        return ordering;
    }

    // The blocks to be solved for, cameras first, and how many unknowns the cameras have.
    std::vector<double*> blocks() {
        std::vector<double*> all;
        const auto take = [&](double* block) {
            if (problem_.HasParameterBlock(block)) {
                all.push_back(block);
            }
        };
        for (BundleCamera& camera : bundle_.cameras) {
            take(camera.lens.data());
            take(camera.camera_from_first.data());
        }
        if (bundle_.estimate_target) {
            for (Eigen::Vector3d& at : at_) {
                take(at.data());
            }
        }
        for (PoseBlock& pose : bundle_.first_from_target) {
            take(pose.data());
        }
        return all;
    }

    void keep_target() { bundle_.target_mm = at_; }

  private:
    bool is_view(const double* block) const {
        return std::any_of(bundle_.first_from_target.begin(), bundle_.first_from_target.end(),
                           [block](const PoseBlock& pose) { return pose.data() == block; });
    }

    void add(const BundleCorner& corner, double robust_px) {
        BundleCamera& camera = bundle_.cameras[static_cast<std::size_t>(corner.camera)];
        double* view = bundle_.first_from_target[static_cast<std::size_t>(corner.view)].data();
        double* at = at_[static_cast<std::size_t>(corner.id)].data();
        double* pose = camera.camera_from_first.data();
        ceres::LossFunction* loss =
            robust_px > 0.0 ? new ceres::CauchyLoss(robust_px / corner.sigma_px) : nullptr;
        const CornerCost cost = cost_of(bundle_, corner);
        if (corner.camera == 0 && !bundle_.estimate_target) {
            problem_.AddResidualBlock(
                new ceres::AutoDiffCostFunction<FirstCamera, 2, 12, 6>(new FirstCamera{cost}), loss,
                camera.lens.data(), view);
        } else if (corner.camera == 0) {
            problem_.AddResidualBlock(
                new ceres::AutoDiffCostFunction<FirstCamera, 2, 12, 6, 3>(new FirstCamera{cost}),
                loss, camera.lens.data(), view, at);
        } else if (!bundle_.estimate_target) {
            problem_.AddResidualBlock(
                new ceres::AutoDiffCostFunction<OtherCamera, 2, 12, 6, 6>(new OtherCamera{cost}),
                loss, camera.lens.data(), pose, view);
        } else {
            problem_.AddResidualBlock(
                new ceres::AutoDiffCostFunction<OtherCamera, 2, 12, 6, 6, 3>(new OtherCamera{cost}),
                loss, camera.lens.data(), pose, view, at);
        }
    }

    void add_target_priors() {
        for (std::size_t i = 0; i < at_.size(); ++i) {
            if (problem_.HasParameterBlock(at_[i].data())) {
                const double sigma = std::max(1e-6, bundle_.target_sigma_mm[i]);
                problem_.AddResidualBlock(new ceres::AutoDiffCostFunction<TargetCost, 3, 3>(
                                              new TargetCost{bundle_.target_mm[i], 1.0 / sigma}),
                                          nullptr, at_[i].data());
            }
        }
    }

    Bundle& bundle_;
    std::vector<Eigen::Vector3d> at_;
    ceres::Problem problem_;
};

// J^T J of the problem, each unknown scaled to a diagonal of one, which the scale undoes.
struct Normal {
    Eigen::MatrixXd matrix;
    Eigen::VectorXd scale;
};

Normal normal_equations(const ceres::CRSMatrix& J) {
    Normal normal{Eigen::MatrixXd::Zero(J.num_cols, J.num_cols), {}};
    for (int row = 0; row < J.num_rows; ++row) {
        const int begin = J.rows[static_cast<std::size_t>(row)];
        const int end = J.rows[static_cast<std::size_t>(row) + 1];
        for (int a = begin; a < end; ++a) {
            const auto i = static_cast<std::size_t>(a);
            for (int b = begin; b <= a; ++b) {
                const auto j = static_cast<std::size_t>(b);
                normal.matrix(J.cols[i], J.cols[j]) += J.values[i] * J.values[j];
            }
        }
    }
    normal.matrix = Eigen::MatrixXd(normal.matrix.selfadjointView<Eigen::Lower>());
    normal.scale = normal.matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    normal.matrix = normal.scale.asDiagonal() * normal.matrix * normal.scale.asDiagonal();
    return normal;
}

}  // namespace

std::optional<Eigen::Vector2d> residual_px(const Bundle& bundle, const BundleCorner& corner) {
    const BundleCamera& camera = bundle.cameras[static_cast<std::size_t>(corner.camera)];
    const CornerCost cost = cost_of(bundle, corner);
    const PoseBlock& view = bundle.first_from_target[static_cast<std::size_t>(corner.view)];
    double in_first[3];
    double in_camera[3];
    moved(view.data(), cost.on_target_mm.data(), in_first);
    moved(camera.camera_from_first.data(), in_first, in_camera);
    Eigen::Vector2d pixel;
    if (!cost.pixel(camera.lens.data(), corner.camera == 0 ? in_first : in_camera, pixel.data())) {
        return std::nullopt;
    }
    return pixel - corner.px;
}

bool adjust(Bundle& bundle, double robust_px, std::stop_token stop) {
    Problem problem(bundle, robust_px);
    if (problem.problem().NumResidualBlocks() == 0) {
        return false;
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_SCHUR;
    options.linear_solver_ordering = problem.ordering();
    options.num_threads = 1;
    options.max_num_iterations = 100;
    // Corners that are out don't need the last digit to be seen.
    options.function_tolerance = robust_px > 0.0 ? 1e-5 : 1e-10;
    options.parameter_tolerance = robust_px > 0.0 ? 1e-6 : 1e-10;
    options.logging_type = ceres::SILENT;
    StopWhenAsked stopper(stop);
    options.callbacks.push_back(&stopper);
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem.problem(), &summary);
    problem.keep_target();
    return summary.IsSolutionUsable() && !stop.stop_requested();
}

BundleCovariance covariance_of(Bundle& bundle) {
    Problem problem(bundle, 0.0);
    ceres::Problem::EvaluateOptions options;
    options.parameter_blocks = problem.blocks();
    ceres::CRSMatrix J;
    double cost = 0.0;
    BundleCovariance result;
    const int all = static_cast<int>(bundle.cameras.size()) * camera_parameters;
    result.cameras = Eigen::MatrixXd::Zero(all, all);
    if (!problem.problem().Evaluate(options, &cost, nullptr, nullptr, &J) ||
        J.num_rows <= J.num_cols) {
        return result;
    }
    result.variance_factor = 2.0 * cost / (J.num_rows - J.num_cols);
    const Normal normal = normal_equations(J);
    const Eigen::LDLT<Eigen::MatrixXd> factor(normal.matrix);
    if (factor.info() != Eigen::Success || !(factor.vectorD().minCoeff() > 1e-13)) {
        return result;
    }
    std::vector<int> place;  // of each unknown of the cameras among all their parameters
    for (std::size_t c = 0; c < bundle.cameras.size(); ++c) {
        const auto fixed = held(bundle.cameras[c]);
        for (int i = 0; i < camera_parameters; ++i) {
            const bool lens = i < 12;
            const bool open =
                lens ? std::find(fixed.begin(), fixed.end(), i) == fixed.end() : c > 0;
            if (open) {
                place.push_back(static_cast<int>(c) * camera_parameters + i);
            }
        }
    }
    const auto unknowns = static_cast<Eigen::Index>(place.size());
    const Eigen::MatrixXd columns =
        factor.solve(Eigen::MatrixXd::Identity(normal.matrix.rows(), unknowns));
    for (Eigen::Index i = 0; i < unknowns; ++i) {
        for (Eigen::Index j = 0; j < unknowns; ++j) {
            result.cameras(place[static_cast<std::size_t>(i)], place[static_cast<std::size_t>(j)]) =
                result.variance_factor * columns(i, j) * normal.scale[i] * normal.scale[j];
        }
    }
    result.determined = result.cameras.allFinite();
    return result;
}

}  // namespace kambara
