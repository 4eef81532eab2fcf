// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/similarity_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/matching/cubic_spline.h"

namespace kambara {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

constexpr int most_steps = 15;
constexpr int robust_rounds = 2;
constexpr double settled_px = 1e-3;
constexpr double farthest_px = 3.0;
constexpr double largest_growth = 1.2;
constexpr double largest_turn_rad = 0.3;
constexpr double least_texture = 1e-3;  // of a flat direction's share in the normal matrix
constexpr double tukey = 4.685;         // deviations: 95 % efficient on normal residuals
constexpr double outlier_deviations = 4.0;
constexpr double least_deviation_grey = 1.0;  // rounding and noise: below, nothing stands out
constexpr std::size_t fewest_pixels = 24;

// A pixel of the template: where it lies from the centre, and the terms of the linear model
//   picture = a T + b + a (Tx, Ty) . (d + [g -t; t g] u / radius)
// in (a dx, a dy, a g, a t, a, b).
struct Pixel {
    Eigen::Vector2d from_centre;
    Vector6 terms;
};

class Fit {
  public:
    Fit(const Image& picture, const Image& picture_of_template, const Rectangle& rectangle,
        const Image* mask)
        : picture_(picture), half_(0.5 * (rectangle.width - 1), 0.5 * (rectangle.height - 1)) {
        const CubicSpline of_template(picture_of_template,
                                      spline_piece(rectangle, picture_of_template));
        radius_ = std::max(1.0, half_.norm());
        double mean = 0.0;
        for (int y = 0; y < rectangle.height; ++y) {
            for (int x = 0; x < rectangle.width; ++x) {
                if (mask != nullptr && mask->at(x, y) == 0) {
                    continue;
                }
                const auto slope = of_template.gradient(rectangle.x + x, rectangle.y + y);
                const Eigen::Vector2d u = Eigen::Vector2d(x, y) - half_;
                const double level = picture_of_template.at(rectangle.x + x, rectangle.y + y);
                Pixel pixel{u, Vector6::Zero()};
                pixel.terms << slope.x, slope.y, (slope.x * u.x() + slope.y * u.y()) / radius_,
                    (slope.y * u.x() - slope.x * u.y()) / radius_, level, 1.0;
                pixels_.push_back(pixel);
                mean += level;
            }
        }
        mean /= std::max(1.0, static_cast<double>(pixels_.size()));
        for (Pixel& pixel : pixels_) {
            pixel.terms[4] -= mean;  // so that gain and offset are told apart well
        }
        weights_.assign(pixels_.size(), 1.0);
        seen_.resize(pixels_.size());
    }

    std::optional<SimilarityMatch> run(const Eigen::Vector2d& start_px) {
        if (pixels_.size() < fewest_pixels || !prepare(start_px) || !solve_for_weights()) {
            return std::nullopt;
        }
        centre_ = start_px;
        for (int round = 0; round <= robust_rounds; ++round) {
            if (!converge(start_px)) {
                return std::nullopt;
            }
            if (round < robust_rounds && !(reweigh() && solve_for_weights())) {
                break;
            }
        }
        return result();
    }

  private:
    // The picture about the place, as far as the steps may lead.
    bool prepare(const Eigen::Vector2d& start_px) {
        const Eigen::Vector2d reach =
            (largest_growth * half_).array() + largest_turn_rad * radius_ + farthest_px + 1.0;
        const Eigen::Vector2i first = (start_px - reach).array().floor().cast<int>();
        const Eigen::Vector2i last = (start_px + reach).array().ceil().cast<int>();
        const Rectangle around{first.x(), first.y(), last.x() - first.x() + 1,
                               last.y() - first.y() + 1};
        const Rectangle piece = spline_piece(around, picture_);
        if (piece.width < 4 || piece.height < 4) {
            return false;
        }
        spline_.emplace(picture_, piece);
        return true;
    }

    bool solve_for_weights() {
        Matrix6 normal = Matrix6::Zero();
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            normal.noalias() += weights_[i] * pixels_[i].terms * pixels_[i].terms.transpose();
        }
        solver_.compute(normal);
        return solver_.info() == Eigen::Success &&
               solver_.vectorD().minCoeff() >= least_texture * static_cast<double>(pixels_.size());
    }

    bool look() {
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            const Eigen::Vector2d at = centre_ + shape_ * pixels_[i].from_centre;
            if (at.x() < 0.0 || at.y() < 0.0 || at.x() > picture_.width() - 1 ||
                at.y() > picture_.height() - 1) {
                return false;
            }
            seen_[i] = spline_->value(at.x(), at.y());
        }
        return true;
    }

    bool converge(const Eigen::Vector2d& start_px) {
        for (int step = 0; step < most_steps; ++step) {
            if (!look()) {
                return false;
            }
            Vector6 right = Vector6::Zero();
            for (std::size_t i = 0; i < pixels_.size(); ++i) {
                right += weights_[i] * seen_[i] * pixels_[i].terms;
            }
            solution_ = solver_.solve(right);
            const double gain = solution_[4];
            if (gain <= 0.0) {
                return false;  // the picture is the template's negative here
            }
            const double growth = solution_[2] / gain / radius_;
            const double turn = solution_[3] / gain / radius_;
            Eigen::Matrix2d step_shape;
            step_shape << 1.0 + growth, -turn, turn, 1.0 + growth;
            shape_ = shape_ * step_shape.inverse();
            const Eigen::Vector2d moved = shape_ * solution_.head<2>() / gain;
            centre_ -= moved;
            const double scale = shape_.col(0).norm();
            const double turned = std::atan2(shape_(1, 0), shape_(0, 0));
            if ((centre_ - start_px).norm() > farthest_px || scale > largest_growth ||
                scale < 1.0 / largest_growth || std::abs(turned) > largest_turn_rad) {
                return false;
            }
            if (moved.norm() + radius_ * std::hypot(growth, turn) < settled_px) {
                return look();
            }
        }
        return look();
    }

    double residual(std::size_t i) const { return seen_[i] - solution_.dot(pixels_[i].terms); }

    // Weights by how far each pixel stands out; false where none does.
    bool reweigh() {
        std::vector<double> sizes(pixels_.size());
        for (std::size_t i = 0; i < sizes.size(); ++i) {
            sizes[i] = std::abs(residual(i));
        }
        const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
        std::nth_element(sizes.begin(), middle, sizes.end());
        const double deviation = std::max(least_deviation_grey, 1.4826 * *middle);
        std::size_t outliers = 0;
        for (std::size_t i = 0; i < weights_.size(); ++i) {
            const double t = residual(i) / (tukey * deviation);
            weights_[i] = std::abs(t) < 1.0 ? (1.0 - t * t) * (1.0 - t * t) : 0.0;
            outliers += std::abs(residual(i)) > outlier_deviations * deviation ? 1U : 0U;
        }
        outlier_share_ = static_cast<double>(outliers) / static_cast<double>(weights_.size());
        if (outliers == 0) {
            weights_.assign(weights_.size(), 1.0);
        }
        return outliers > 0;
    }

    SimilarityMatch result() const {
        double squares = 0.0;
        double counted = 0.0;
        for (std::size_t i = 0; i < pixels_.size(); ++i) {
            squares += weights_[i] * residual(i) * residual(i);
            counted += weights_[i];
        }
        SimilarityMatch match;
        match.centre_px = centre_;
        match.scale = shape_.col(0).norm();
        match.turn_rad = std::atan2(shape_(1, 0), shape_(0, 0));
        match.residual_grey = std::sqrt(squares / std::max(1.0, counted));
        match.outlier_share = outlier_share_;
        const Matrix6 inverse = solver_.solve(Matrix6::Identity());
        const double variance = squares / std::max(1.0, counted - 6.0) + 1.0 / 12.0;
        const double by_gain = std::sqrt(variance) / solution_[4] / radius_;
        match.scale_sigma = match.scale * by_gain * std::sqrt(std::max(0.0, inverse(2, 2)));
        match.turn_sigma_rad = by_gain * std::sqrt(std::max(0.0, inverse(3, 3)));
        return match;
    }

    const Image& picture_;
    const Eigen::Vector2d half_;
    double radius_ = 1.0;
    std::vector<Pixel> pixels_;
    std::vector<double> weights_;
    std::vector<double> seen_;
    std::optional<CubicSpline> spline_;
    Eigen::LDLT<Matrix6> solver_;
    Vector6 solution_ = Vector6::Zero();
    Eigen::Vector2d centre_ = Eigen::Vector2d::Zero();
    Eigen::Matrix2d shape_ = Eigen::Matrix2d::Identity();  // from template to picture
    double outlier_share_ = 0.0;
};

}  // namespace

std::optional<SimilarityMatch> fit_similarity(const Image& picture,
                                              const Image& picture_of_template,
                                              const Rectangle& rectangle,
                                              const Eigen::Vector2d& start_centre_px,
                                              const Image* mask) {
    return Fit(picture, picture_of_template, rectangle, mask).run(start_centre_px);
}

}  // namespace kambara
