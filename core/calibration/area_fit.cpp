// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/area_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr int most_rounds = 12;
constexpr double settled_px = 2e-3;
constexpr double farthest_px =
    2.0;  // from the start, and more for a long box, whose corners are sharp
constexpr double farthest_of_length = 0.12;
constexpr double least_sigma_px = 0.003;
constexpr double widest_ring_px = 2.0;  // of light about the box
constexpr double most_misfit = 0.08;    // of the contrast: something else than a box

using Point = Eigen::Vector2d;

// A piece of a box's outline, with where along its side it starts and ends.
struct Piece {
    Point a, b;
    std::size_t side;
    double t_a, t_b;
};

std::vector<Piece> outline_of(const Quadrilateral& box, const Straightener& straightener) {
    constexpr int pieces = 4;  // a side, where a lens bends it
    std::vector<Piece> outline;
    for (std::size_t side = 0; side < 4; ++side) {
        const Point& a = box[side];
        const Point& b = box[(side + 1) % 4];
        const auto from = straightener.straight(a);
        const auto to = straightener.straight(b);
        Point last = a;
        for (int i = 1; i <= pieces; ++i) {
            const double t = static_cast<double>(i) / pieces;
            Point next = a + t * (b - a);
            if (from && to && i < pieces) {
                next = straightener.pixel(*from + t * (*to - *from)).value_or(next);
            }
            outline.push_back({last, next, side, t - 1.0 / pieces, t});
            last = next;
        }
    }
    return outline;
}

// The part of a piece within the pixel at (0, 0) to (1, 1), by shares of the piece.
bool within_pixel(const Point& a, const Point& b, double& low, double& high) {
    low = 0.0;
    high = 1.0;
    for (int k = 0; k < 2; ++k) {
        const double d = b(k) - a(k);
        double first = -a(k);
        double last = 1.0 - a(k);
        if (std::abs(d) < 1e-12) {
            if (first > 0.0 || last < 0.0) {
                return false;
            }
            continue;
        }
        first /= d;
        last /= d;
        low = std::max(low, std::min(first, last));
        high = std::min(high, std::max(first, last));
    }
    return high > low;
}

// The outline's pieces draw themselves: each adds to the pixels it crosses and to all to their
// right what it runs down or up (so the sums along a row are the shares covered).
void draw(const Piece& piece, BoxCoverage::Region& region) {
    const Point origin(region.x0 - 0.5, region.y0 - 0.5);
    const Point a = piece.a - origin;
    const Point b = piece.b - origin;
    const Point normal(b.y() - a.y(), a.x() - b.x());  // outward, as long as the piece
    const int top = std::max(0, static_cast<int>(std::floor(std::min(a.y(), b.y()))));
    const int bottom =
        std::min(region.height - 1, static_cast<int>(std::floor(std::max(a.y(), b.y()))));
    const int left = std::max(0, static_cast<int>(std::floor(std::min(a.x(), b.x()))));
    const int right =
        std::min(region.width - 1, static_cast<int>(std::floor(std::max(a.x(), b.x()))));
    const auto corner_a = static_cast<Eigen::Index>(2 * piece.side);
    const auto corner_b = static_cast<Eigen::Index>(2 * ((piece.side + 1) % 4));
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            const Point pixel(x, y);
            double low = 0.0;
            double high = 0.0;
            if (!within_pixel(a - pixel, b - pixel, low, high)) {
                continue;
            }
            const Eigen::Index i = y * region.width + x;
            const double middle = 0.5 * (low + high);
            const double down = (high - low) * (b.y() - a.y());
            const double covered = x + 1 - (a.x() + middle * (b.x() - a.x()));
            region.share(i) -= down * covered;
            if (x + 1 < region.width) {
                region.share(i + 1) -= down * (1.0 - covered);
            }
            if (region.by_corners.rows() == 0) {
                continue;
            }
            const double t = piece.t_a + middle * (piece.t_b - piece.t_a);
            const Point moves = (high - low) * normal;
            region.by_corners.row(i).segment<2>(corner_a) += (1.0 - t) * moves.transpose();
            region.by_corners.row(i).segment<2>(corner_b) += t * moves.transpose();
        }
    }
}

// How far outside a quadrilateral places lie.
class Outside {
  public:
    explicit Outside(const Quadrilateral& box) {
        for (std::size_t i = 0; i < 4; ++i) {
            const Point along = (box[(i + 1) % 4] - box[i]).normalized();
            lines_[i] = {along.y(), -along.x(), along.x() * box[i].y() - along.y() * box[i].x()};
        }
    }
    double distance_px(const Point& p) const {
        double farthest = -1e9;
        for (const Eigen::Vector3d& line : lines_) {
            farthest = std::max(farthest, line.x() * p.x() + line.y() * p.y() + line.z());
        }
        return farthest;
    }

  private:
    std::array<Eigen::Vector3d, 4> lines_;
};

using Parameters = Eigen::Matrix<double, 10, 1>;  // corners, light outside, light inside
using Normal = Eigen::Matrix<double, 10, 10>;

// One step of Gauss-Newton, what it rests on, and what it left unexplained.
struct Step {
    Parameters change;
    Normal normal;
    double squares = 0.0;
    double pixels = 0.0;
};

Step step_of(const Image& grey, const LightOfLevel& light, const BoxCoverage::Region& region,
             const BoxCoverage& others, const Quadrilateral& box, double ring_px, double outside,
             double inside) {
    Step step;
    step.normal.setZero();
    Parameters right = Parameters::Zero();
    Parameters row;
    const Outside outline(box);
    for (int y = 0; y < region.height; ++y) {
        for (int x = 0; x < region.width; ++x) {
            const Eigen::Index i = y * region.width + x;
            const Point place(region.x0 + x, region.y0 + y);
            if (outline.distance_px(place) > ring_px) {
                continue;
            }
            const double others_here = others.at(region.x0 + x, region.y0 + y);
            const double share = std::min(1.0, region.share(i) + others_here);
            const double seen = static_cast<double>(light[grey.at(region.x0 + x, region.y0 + y)]);
            const double misfit = seen - (outside + share * (inside - outside));
            row.head<8>() = (inside - outside) * region.by_corners.row(i).transpose();
            row(8) = 1.0 - share;
            row(9) = share;
            step.normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
            right += misfit * row;
            step.squares += misfit * misfit;
            step.pixels += 1.0;
        }
    }
    step.normal = step.normal.selfadjointView<Eigen::Lower>();
    step.change = step.normal.ldlt().solve(right);
    return step;
}

}  // namespace

BoxCoverage::BoxCoverage(int width, int height, double blur_px)
    : width_(width), height_(height), sum_(static_cast<std::size_t>(width * height), 0.0) {
    if (blur_px > 0.2) {
        const int reach = static_cast<int>(std::ceil(2.5 * blur_px));
        double total = 0.0;
        for (int i = -reach; i <= reach; ++i) {
            kernel_.push_back(std::exp(-0.5 * i * i / (blur_px * blur_px)));
            total += kernel_.back();
        }
        for (double& weight : kernel_) {
            weight /= total;
        }
    }
}

BoxCoverage::Region BoxCoverage::region_of(const Quadrilateral& box, double around_px,
                                           const Straightener& straightener,
                                           bool shares_only) const {
    Point low = box[0];
    Point high = box[0];
    for (const Point& p : box) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const double around = around_px + 1.0 + 0.5 * static_cast<double>(kernel_.size());
    Region region;
    region.x0 = std::clamp(static_cast<int>(std::floor(low.x() - around)), 0, width_ - 1);
    region.y0 = std::clamp(static_cast<int>(std::floor(low.y() - around)), 0, height_ - 1);
    region.width =
        std::clamp(static_cast<int>(std::ceil(high.x() + around)), 0, width_ - 1) - region.x0 + 1;
    region.height =
        std::clamp(static_cast<int>(std::ceil(high.y() + around)), 0, height_ - 1) - region.y0 + 1;
    const Eigen::Index n = static_cast<Eigen::Index>(std::max(0, region.width)) *
                           static_cast<Eigen::Index>(std::max(0, region.height));
    region.share = Eigen::VectorXd::Zero(n);
    region.by_corners = Eigen::Matrix<double, Eigen::Dynamic, 8>::Zero(shares_only ? 0 : n, 8);
    if (n == 0) {
        return region;
    }
    for (const Piece& piece : outline_of(box, straightener)) {
        draw(piece, region);
    }
    for (int y = 0; y < region.height; ++y) {
        for (int x = 1; x < region.width; ++x) {
            region.share(y * region.width + x) += region.share(y * region.width + x - 1);
        }
    }
    blur(region);
    return region;
}

void BoxCoverage::blur(Region& region) const {
    if (kernel_.empty()) {
        return;
    }
    const int reach = static_cast<int>(kernel_.size() / 2);
    const auto pass = [&](int count, int length, int step, int stride, auto&& column) {
        std::vector<double> line(static_cast<std::size_t>(length));
        for (int k = 0; k < count; ++k) {
            for (int i = 0; i < length; ++i) {
                line[static_cast<std::size_t>(i)] = column(k * stride + i * step);
            }
            for (int i = 0; i < length; ++i) {
                double value = 0.0;
                for (int j = std::max(0, i - reach); j <= std::min(length - 1, i + reach); ++j) {
                    value += kernel_[static_cast<std::size_t>(j - i + reach)] *
                             line[static_cast<std::size_t>(j)];
                }
                column(k * stride + i * step) = value;
            }
        }
    };
    pass(region.height, region.width, 1, region.width, region.share);
    pass(region.width, region.height, region.width, 1, region.share);
    for (Eigen::Index c = 0; c < 8 && region.by_corners.rows() > 0; ++c) {
        pass(region.height, region.width, 1, region.width, region.by_corners.col(c));
        pass(region.width, region.height, region.width, 1, region.by_corners.col(c));
    }
}

void BoxCoverage::add(const Quadrilateral& box, const Straightener& straightener, double sign) {
    const Region region = region_of(box, 0.0, straightener, true);
    for (int y = 0; y < region.height; ++y) {
        for (int x = 0; x < region.width; ++x) {
            sum_[static_cast<std::size_t>((region.y0 + y) * width_ + region.x0 + x)] +=
                sign * region.share(y * region.width + x);
        }
    }
}

std::optional<FittedBox> fit_area(const Image& grey, const LightOfLevel& light,
                                  const Quadrilateral& start, const SideFitOptions& options,
                                  const BoxCoverage& others, const Straightener& straightener) {
    FittedBox box;
    box.corners_px = start;
    box.blur_px = options.blur_px;
    const double ring = widest_ring_px + 2.0 * options.blur_px;
    const double farthest = farthest_px + farthest_of_length * mean_size_px(start).maxCoeff();
    double outside = 0.0;
    double inside = 255.0;
    for (const Point& p : start) {
        if (p.x() < ring + 1 || p.y() < ring + 1 || p.x() > grey.width() - ring - 2 ||
            p.y() > grey.height() - ring - 2) {
            return std::nullopt;
        }
    }
    // A start for the light: the lightest about the corners, the darkest within.
    const Point middle = 0.25 * (start[0] + start[1] + start[2] + start[3]);
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            for (const Point& p : start) {
                const Point out = p + 1.5 * (p - middle).normalized() + Point(dx, dy);
                outside = std::max(
                    outside,
                    static_cast<double>(light[grey.at(static_cast<int>(std::lround(out.x())),
                                                      static_cast<int>(std::lround(out.y())))]));
            }
            const Point in = middle + Point(dx, dy);
            inside = std::min(
                inside, static_cast<double>(light[grey.at(static_cast<int>(std::lround(in.x())),
                                                          static_cast<int>(std::lround(in.y())))]));
        }
    }
    for (int round = 0; round < most_rounds; ++round) {
        if (outside - inside < options.least_contrast) {
            return std::nullopt;
        }
        const auto region = others.region_of(box.corners_px, ring, straightener);
        const Step step =
            step_of(grey, light, region, others, box.corners_px, ring, outside, inside);
        if (!step.change.allFinite() || step.pixels < 20.0) {
            return std::nullopt;
        }
        double largest = 0.0;
        for (std::size_t i = 0; i < 4; ++i) {
            Point move = step.change.segment<2>(static_cast<Eigen::Index>(2 * i));
            largest = std::max(largest, move.norm());
            if (move.norm() > 1.0) {
                move.normalize();
            }
            box.corners_px[i] += move;
            if (!((box.corners_px[i] - start[i]).norm() < farthest)) {
                return std::nullopt;
            }
        }
        outside += step.change(8);
        inside += step.change(9);
        if (largest > settled_px && round + 1 < most_rounds) {
            continue;
        }
        const double variance = step.squares / std::max(1.0, step.pixels - 10.0);
        if (largest > 0.1 || std::sqrt(variance) > most_misfit * (outside - inside)) {
            return std::nullopt;
        }
        const Normal covariance = variance * step.normal.inverse();
        for (std::size_t i = 0; i < 4; ++i) {
            const auto k = static_cast<Eigen::Index>(2 * i);
            box.sigma_px[i] = std::sqrt(0.5 * (covariance(k, k) + covariance(k + 1, k + 1)) +
                                        least_sigma_px * least_sigma_px);
            box.sides[i].dark = inside;
            box.sides[i].light = outside;
            box.sides[i].sigma_px = box.sigma_px[i];
        }
        return box;
    }
    return std::nullopt;
}

}  // namespace kambara
