// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/plane_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/matching/cubic_spline.h"

namespace kambara {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int most_steps = 40;
constexpr double settled_px = 0.005;
constexpr double longest_step_px = 2.0;
constexpr double longest_step_slope = 0.3;
constexpr double farthest_px = 10.0;  // from where it started
constexpr double farthest_off_curve_px = 4.0;
constexpr double steepest = 2.0;
constexpr double smallest_cosine = 0.05;
constexpr double least_seen = 0.6;  // of the patch, within the right picture
constexpr double least_pivot = 1e-6;

struct Pixel {
    Ray ray;
    double level = 0.0;
};

// Where a pixel of the left picture is seen in the right one, and how that changes with the
// logarithm of the reference point's distance and with both slopes.
struct Seen {
    Eigen::Vector2d pixel;
    Eigen::Matrix<double, 2, 3> by_plane;
};

class Fit {
  public:
    Fit(const ReferencePatch& patch, const Rig& rig, const Image& right_grey, double range_mm)
        : right_(*rig.right), grey_(right_grey), range_mm_(range_mm), slope_(patch.slope) {
        const auto centre = rig.left.unproject(patch.centre_px);
        if (!centre) {
            return;
        }
        centre_ = *centre;
        const Eigen::Vector2d half = 0.5 * (patch.size_px.cast<double>() - Eigen::Vector2d::Ones());
        const Eigen::Vector2i first = (patch.centre_px - half).array().ceil().cast<int>();
        const Eigen::Vector2i last = (patch.centre_px + half).array().floor().cast<int>();
        const Image& left_grey = *patch.left_grey;
        pixels_.reserve(static_cast<std::size_t>(patch.size_px.prod()));
        for (int y = std::max(first.y(), 0); y <= std::min(last.y(), left_grey.height() - 1); ++y) {
            for (int x = std::max(first.x(), 0); x <= std::min(last.x(), left_grey.width() - 1);
                 ++x) {
                if (const auto ray = rig.left.unproject(Eigen::Vector2d(x, y))) {
                    pixels_.push_back({*ray, static_cast<double>(left_grey.at(x, y))});
                }
            }
        }
    }

    std::optional<PlaneFit> run() {
        const auto start = pixels_.empty() ? std::nullopt : seen(centre_);
        if (!start || !prepare()) {
            return std::nullopt;
        }
        for (int i = 0; i < most_steps; ++i) {
            const auto moved_px = step();
            const auto now = seen(centre_);
            if (!moved_px || !now || (now->pixel - start->pixel).norm() > farthest_px ||
                slope_.norm() > steepest || std::abs(off_curve_px_) > farthest_off_curve_px) {
                return std::nullopt;
            }
            if (*moved_px < settled_px) {
                return result(*now);
            }
        }
        return std::nullopt;
    }

  private:
    std::optional<Seen> seen(const Ray& ray) const {
        const Eigen::Vector3d normal(-slope_.x(), -slope_.y(), 1.0);
        const double cosine = ray.direction.dot(normal);
        if (cosine < smallest_cosine) {
            return std::nullopt;
        }
        const Eigen::Vector3d point = centre_.at(range_mm_);
        const double along = (point - ray.origin_mm).dot(normal) / cosine;
        const Eigen::Vector3d at = ray.at(along);
        Eigen::Matrix<double, 2, 3> by_point;
        const auto pixel = right_.project(at, by_point);
        if (!pixel) {
            return std::nullopt;
        }
        const double by_range = range_mm_ * centre_.direction.dot(normal) / cosine;
        const Eigen::Vector2d by_slope = (at - point).head<2>() / cosine;
        Eigen::Matrix<double, 2, 3> by_plane;
        by_plane << by_point * ray.direction * by_range,
            by_point * ray.direction * by_slope.transpose();
        return Seen{*pixel, by_plane};
    }

    // The epipolar curve's direction and what is across it, at the reference point.
    Eigen::Vector2d across() const {
        const auto here = seen(centre_);
        const Eigen::Vector2d along =
            here ? here->by_plane.col(0).normalized() : Eigen::Vector2d::UnitX();
        return {-along.y(), along.x()};
    }

    bool prepare() {
        Eigen::Vector2d least(1e9, 1e9);
        Eigen::Vector2d most = -least;
        for (const Pixel& pixel : pixels_) {
            if (const auto there = seen(pixel.ray)) {
                least = least.cwiseMin(there->pixel);
                most = most.cwiseMax(there->pixel);
            }
        }
        const Eigen::Vector2i first = (least.array() - farthest_px).floor().cast<int>();
        const Eigen::Vector2i size =
            (most - least).array().ceil().cast<int>() + static_cast<int>(2.0 * farthest_px) + 1;
        const Rectangle piece = spline_piece({first.x(), first.y(), size.x(), size.y()}, grey_);
        if (piece.width < 8 || piece.height < 8) {
            return false;
        }
        spline_.emplace(grey_, piece);
        return true;
    }

    // One step; the length by which it moves the reference point, or the patch's rim by its slope.
    std::optional<double> step() {
        const Eigen::Vector2d off = across();
        Matrix6 normal = Matrix6::Zero();
        Vector6 right = Vector6::Zero();
        squares_ = 0.0;
        count_ = 0;
        Eigen::Vector3d rim = Eigen::Vector3d::Zero();
        double sums[5] = {};
        for (const Pixel& pixel : pixels_) {
            const auto there = seen(pixel.ray);
            if (!there) {
                continue;
            }
            const Eigen::Vector2d at = there->pixel + off_curve_px_ * off;
            if (at.x() < 0.0 || at.y() < 0.0 || at.x() > grey_.width() - 1 ||
                at.y() > grey_.height() - 1) {
                continue;
            }
            const double level = spline_->value(at.x(), at.y());
            const auto change = spline_->gradient(at.x(), at.y());
            const Eigen::RowVector2d gradient(change.x, change.y);
            Vector6 terms;
            terms << gain_ * (gradient * there->by_plane).transpose(), gain_ * gradient.dot(off),
                level, 1.0;
            const double residual = pixel.level - gain_ * level - offset_;
            normal.noalias() += terms * terms.transpose();
            right += residual * terms;
            squares_ += residual * residual;
            rim = rim.cwiseMax(there->by_plane.colwise().norm().transpose());
            ++count_;
            sums[0] += level, sums[1] += pixel.level, sums[2] += level * level;
            sums[3] += pixel.level * pixel.level, sums[4] += level * pixel.level;
        }
        const auto all = static_cast<double>(pixels_.size());
        if (count_ < least_seen * all) {
            return std::nullopt;
        }
        const double n = count_;
        const double variances =
            (n * sums[2] - sums[0] * sums[0]) * (n * sums[3] - sums[1] * sums[1]);
        likeness_ =
            variances > 0.0 ? (n * sums[4] - sums[0] * sums[1]) / std::sqrt(variances) : 0.0;
        // Each unknown in units in which its own column has length 1.
        unit_ = normal.diagonal().cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
        solver_.compute(unit_.asDiagonal() * normal * unit_.asDiagonal());
        if (solver_.info() != Eigen::Success || solver_.vectorD().minCoeff() < least_pivot) {
            return std::nullopt;
        }
        Vector6 change = unit_.asDiagonal() * solver_.solve(unit_.asDiagonal() * right);
        const double moved_px = std::max(std::abs(change[0]) * rim[0], std::abs(change[3]));
        const double bent = change.segment<2>(1).cwiseAbs().maxCoeff();
        const double shorter = std::min({1.0, longest_step_px / std::max(moved_px, 1e-9),
                                         longest_step_slope / std::max(bent, 1e-9)});
        change.head<4>() *= shorter;
        range_mm_ *= std::exp(change[0]);
        slope_ += change.segment<2>(1);
        off_curve_px_ += change[3];
        gain_ += change[4];
        offset_ += change[5];
        return std::max(moved_px,
                        change.segment<2>(1).cwiseAbs().cwiseProduct(rim.tail<2>()).maxCoeff());
    }

    PlaneFit result(const Seen& now) const {
        PlaneFit fit;
        fit.range_mm = range_mm_;
        fit.slope = slope_;
        const Eigen::Vector2d off = across();
        fit.right_px = now.pixel + off_curve_px_ * off;
        fit.off_curve_px = off_curve_px_;
        fit.likeness = std::clamp(likeness_, 0.0, 1.0);
        const Matrix6 inverse =
            unit_.asDiagonal() * solver_.solve(Matrix6::Identity()) * unit_.asDiagonal();
        Eigen::Matrix2d of_both;
        of_both << inverse(0, 0), inverse(0, 3), inverse(3, 0), inverse(3, 3);
        Eigen::Matrix2d by_both;
        by_both << now.by_plane.col(0), off;
        const double variance = squares_ / std::max(1.0, count_ - 6.0) + 1.0 / 12.0;
        fit.covariance_px2 = variance * by_both * of_both * by_both.transpose();
        fit.slope_covariance = variance * inverse.block<2, 2>(1, 1);
        return fit;
    }

    const Camera& right_;
    const Image& grey_;
    double range_mm_;
    Eigen::Vector2d slope_;
    double off_curve_px_ = 0.0;
    double gain_ = 1.0;
    double offset_ = 0.0;
    Ray centre_;
    std::vector<Pixel> pixels_;
    std::optional<CubicSpline> spline_;
    Eigen::LDLT<Matrix6> solver_;
    Vector6 unit_ = Vector6::Ones();
    double squares_ = 0.0;
    double likeness_ = 0.0;
    int count_ = 0;
};

}  // namespace

std::optional<PlaneFit> fit_plane(const ReferencePatch& patch, const Rig& rig,
                                  const Image& right_grey, double range_mm) {
    return Fit(patch, rig, right_grey, range_mm).run();
}

}  // namespace kambara
