// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include "core/calibration/tsai_fit.h"

namespace kambara {
namespace {

constexpr int subset_size = 9;
constexpr int subsets = 300;
constexpr int kept_subsets = 6;
constexpr double false_alarms = 1e-3;  // in a whole list
// No picture is measured, and no lens follows Tsai's model, better than so much of its size.
constexpr double least_noise_of_extent = 2e-4;
constexpr double suspicious_noise_px = 1.0;

using Indices = std::vector<int>;

std::vector<SeenPoint> chosen(const std::vector<SeenPoint>& points, const Indices& indices) {
    std::vector<SeenPoint> some;
    some.reserve(indices.size());
    for (const int i : indices) {
        some.push_back(points[static_cast<std::size_t>(i)]);
    }
    return some;
}

Indices all_of(const std::vector<SeenPoint>& points) {
    Indices all(points.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

// Squared residual lengths; infinite where a point projects nowhere.
std::vector<double> squared_lengths(const TsaiView& view, const std::vector<SeenPoint>& points) {
    std::vector<double> squares;
    squares.reserve(points.size());
    for (const Eigen::Vector2d& residual : residuals_px(view, points)) {
        const double square = residual.squaredNorm();
        squares.push_back(std::isfinite(square) ? square : std::numeric_limits<double>::infinity());
    }
    return squares;
}

Indices closest(const std::vector<double>& squares, std::size_t count) {
    Indices order(squares.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return squares[static_cast<std::size_t>(a)] < squares[static_cast<std::size_t>(b)];
    });
    order.resize(count);
    std::sort(order.begin(), order.end());
    return order;
}

double kth_smallest(std::vector<double> values, std::size_t k) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(k), values.end());
    return values[k];
}

int unknowns(const TsaiFitOptions& options) {
    const TsaiMask told = told_parameters(options);
    return static_cast<int>(std::count(told.begin(), told.end(), true));
}

double least_noise_px(const std::vector<SeenPoint>& points) {
    return least_noise_of_extent * extent_px(points);
}

// The noise of a coordinate from the median squared length (two Gaussian coordinates: 2 ln 2
// sigma^2), with what the fit itself takes up of it.
double median_noise_px(const std::vector<double>& squares, int parameters, double least_px) {
    const double median = kth_smallest(squares, squares.size() / 2);
    const double rows = 2.0 * static_cast<double>(squares.size());
    const double taken = rows / std::max(1.0, rows - parameters);
    return std::max(least_px, std::sqrt(taken * median / (2.0 * std::log(2.0))));
}

// What squared length noise alone reaches once in `false_alarms` lists of n.
double largest_by_noise(double noise_px, std::size_t n) {
    return 2.0 * noise_px * noise_px * std::log(static_cast<double>(n) / false_alarms);
}

// Linear fits of small random subsets: those whose middle residual is least.
std::vector<TsaiView> subset_fits(const std::vector<SeenPoint>& points,
                                  const TsaiFitOptions& options, std::size_t kept_points) {
    std::mt19937 random(1999);  // fixed: the same list gives the same camera
    std::vector<std::pair<double, TsaiView>> found;
    Indices order = all_of(points);
    const auto size = std::min<std::size_t>(subset_size, points.size());
    for (int draw = 0; draw < subsets; ++draw) {
        for (std::size_t i = 0; i < size; ++i) {
            std::swap(order[i], order[i + random() % (order.size() - i)]);
        }
        const Indices subset(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(size));
        if (const auto view = linear_fit(chosen(points, subset), options)) {
            found.emplace_back(kth_smallest(squared_lengths(*view, points), kept_points - 1),
                               *view);
        }
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<TsaiView> best;
    for (std::size_t i = 0; i < found.size() && i < kept_subsets; ++i) {
        best.push_back(found[i].second);
    }
    return best;
}

// Least trimmed squares: fit the points that are closest, again and again.
std::optional<TsaiView> trimmed_fit(const std::vector<SeenPoint>& points,
                                    const TsaiFitOptions& options) {
    const auto n = points.size();
    const auto kept = std::min(n, (n + 8) / 2);
    std::optional<TsaiView> best;
    double best_sum = std::numeric_limits<double>::infinity();
    for (TsaiView view : subset_fits(points, options, kept)) {
        Indices used;
        for (int step = 0; step < 10; ++step) {
            const Indices next = closest(squared_lengths(view, points), kept);
            if (next == used) {
                break;
            }
            used = next;
            const auto better = fit(chosen(points, used), options);
            if (!better) {
                break;
            }
            view = *better;
        }
        const auto squares = squared_lengths(view, points);
        double sum = 0.0;
        for (const int i : closest(squares, kept)) {
            sum += squares[static_cast<std::size_t>(i)];
        }
        if (sum < best_sum) {
            best_sum = sum;
            best = view;
        }
    }
    return best;
}

// P(F > x) for 2 and m degrees of freedom.
double f_tail(double x, double m) {
    return std::pow(1.0 + 2.0 * x / m, -0.5 * m);
}

// How unlikely each point is as one of the others' kind.
std::vector<double> tail_probabilities(const TsaiView& view, const std::vector<SeenPoint>& points,
                                       const Indices& inliers, const TsaiFitOptions& options) {
    std::vector<double> tails(points.size(), 0.0);
    const auto in_jacobian = tsai_jacobian(view, chosen(points, inliers));
    const auto covariance =
        in_jacobian ? unit_covariance(*in_jacobian, told_parameters(options)) : std::nullopt;
    const double freedom = 2.0 * static_cast<double>(inliers.size()) - unknowns(options);
    if (!covariance || freedom < 3.0) {
        for (const int i : inliers) {
            tails[static_cast<std::size_t>(i)] = 1.0;  // nothing can be said against them
        }
        return tails;
    }
    const double sum = squared_error_px2(view, chosen(points, inliers));
    const double floor = std::pow(least_noise_px(points), 2);
    const std::set<int> inside(inliers.begin(), inliers.end());
    const auto residuals = residuals_px(view, points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto J = tsai_jacobian(view, {points[i]});
        if (!J) {
            continue;
        }
        const Eigen::Matrix2d hat = *J * *covariance * J->transpose();
        const bool in = inside.contains(static_cast<int>(i));
        const Eigen::Matrix2d spread = Eigen::Matrix2d::Identity() + (in ? -1.0 : 1.0) * hat;
        if (in && spread.determinant() < 1e-6) {
            tails[i] = 1.0;  // the fit follows this point alone: it can't be judged
            continue;
        }
        const double square = residuals[i].dot(spread.inverse() * residuals[i]);
        const double m = in ? freedom - 2.0 : freedom;
        const double noise = std::max(floor, (in ? sum - square : sum) / m);
        tails[i] = f_tail(0.5 * square / noise, m);
    }
    return tails;
}

// Takes back what fits and gives up the worst that does not, until nothing changes.
struct Settled {
    TsaiView view;
    Indices inliers;
};
std::optional<Settled> settled(TsaiView view, Indices inliers, const std::vector<SeenPoint>& points,
                               const TsaiFitOptions& options) {
    const double limit = false_alarms / static_cast<double>(points.size());
    for (int round = 0; round < 40; ++round) {
        const auto tails = tail_probabilities(view, points, inliers, options);
        std::set<int> next(inliers.begin(), inliers.end());
        const auto worst = std::min_element(inliers.begin(), inliers.end(), [&](int a, int b) {
            return tails[static_cast<std::size_t>(a)] < tails[static_cast<std::size_t>(b)];
        });
        if (tails[static_cast<std::size_t>(*worst)] < limit) {
            next.erase(*worst);
        } else {
            for (int i = 0; i < static_cast<int>(points.size()); ++i) {
                if (tails[static_cast<std::size_t>(i)] > limit) {
                    next.insert(i);
                }
            }
        }
        if (next.size() == inliers.size()) {
            return Settled{view, inliers};
        }
        const Indices kept(next.begin(), next.end());
        const auto better = fit(chosen(points, kept), options);
        if (!better) {
            return std::nullopt;
        }
        view = *better;
        inliers = kept;
    }
    return Settled{view, inliers};
}

// True where a fit over all the points leaves nothing but what noise would.
bool only_noise(const std::optional<TsaiView>& view, const std::vector<SeenPoint>& points,
                const TsaiFitOptions& options) {
    if (!view) {
        return false;
    }
    const auto squares = squared_lengths(*view, points);
    const double noise_px = median_noise_px(squares, unknowns(options), least_noise_px(points));
    return noise_px <= suspicious_noise_px && *std::max_element(squares.begin(), squares.end()) <=
                                                  largest_by_noise(noise_px, points.size());
}

// The points that a trimmed fit leaves within the noise of its middle ones.
Indices agreeing_points(const std::vector<SeenPoint>& points, const TsaiFitOptions& options) {
    const auto view = trimmed_fit(points, options);
    Indices agreeing;
    if (!view) {
        return agreeing;
    }
    const auto squares = squared_lengths(*view, points);
    const double limit = largest_by_noise(
        median_noise_px(squares, unknowns(options), least_noise_px(points)), points.size());
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        if (squares[static_cast<std::size_t>(i)] <= limit) {
            agreeing.push_back(i);
        }
    }
    return agreeing;
}

}  // namespace

std::optional<RobustFit> robust_fit(const std::vector<SeenPoint>& points,
                                    const TsaiFitOptions& asked) {
    TsaiFitOptions options = asked;
    options.method = TsaiMethod::full;
    RobustFit result;
    std::optional<TsaiView> view = fit(points, options);
    Indices inliers = all_of(points);
    result.suspicious = !only_noise(view, points, options);
    if (result.suspicious) {
        inliers = agreeing_points(points, options);
        view = inliers.size() < 7 ? std::nullopt : fit(chosen(points, inliers), options);
    }
    const auto end = view ? settled(*view, inliers, points, options) : std::nullopt;
    if (!end) {
        return std::nullopt;
    }
    result.view = end->view;
    result.inliers = end->inliers;
    const std::set<int> inside(end->inliers.begin(), end->inliers.end());
    for (int i = 0; i < static_cast<int>(points.size()); ++i) {
        if (!inside.contains(i)) {
            result.outliers.push_back(i);
        }
    }
    result.median_px =
        std::sqrt(kth_smallest(squared_lengths(result.view, points), points.size() / 2));
    return result;
}

}  // namespace kambara
