// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target_view.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr double least_k1 = -0.2;
constexpr double most_k1 = 0.7;
constexpr double k1_sigma = 0.3;
constexpr double pixel_sigma_px = 0.1;

std::vector<Eigen::Vector2d> straightened(const std::vector<Eigen::Vector2d>& pixels,
                                          const RadialTerms& radial) {
    const Straightener straightener(radial);
    std::vector<Eigen::Vector2d> straight;
    straight.reserve(pixels.size());
    for (const auto& p : pixels) {
        straight.push_back(*straightener.straight(p));
    }
    return straight;
}

// Little k1 is likelier than much.
double cost(const SeenPoints& seen, RadialTerms radial, double k1) {
    radial.k1 = k1;
    const double rms = rms_px(fit_view(seen, radial), seen);
    return static_cast<double>(seen.pixels.size()) * std::pow(rms / pixel_sigma_px, 2) +
           std::pow(k1 / k1_sigma, 2);
}

}  // namespace

TargetView fit_view(const SeenPoints& seen, const RadialTerms& radial) {
    const auto straight = straightened(seen.pixels, radial);
    const bool flat = std::all_of(seen.points.begin(), seen.points.end(),
                                  [](const auto& p) { return p.z() == 0.0; });
    TargetView view{Projection::Zero(), radial};
    if (!flat) {
        view.projection = fit_projection(seen.points, straight);
        return view;
    }
    std::vector<Eigen::Vector2d> places;
    for (const auto& p : seen.points) {
        places.push_back(p.head<2>());
    }
    Homography H = fit_homography(places, straight);
    if (H.row(2).dot(places.front().homogeneous()) < 0.0) {
        H = -H;
    }
    view.projection << H.col(0), H.col(1), Eigen::Vector3d::Zero(), H.col(2);
    return view;
}

TargetView fit_view_and_radial(const SeenPoints& seen, const RadialTerms& start) {
    constexpr double step = 0.1;
    double best = least_k1;
    double least = 1e300;
    for (double k1 = least_k1; k1 <= most_k1; k1 += step) {
        const double here = cost(seen, start, k1);
        if (here < least) {
            least = here;
            best = k1;
        }
    }
    // The least of the parabola through three places, ever closer together.
    for (double h = step; h > 1e-4; h *= 0.2) {
        const double before = cost(seen, start, best - h);
        const double behind = cost(seen, start, best + h);
        const double bend = before - 2.0 * least + behind;
        if (bend > 0.0) {
            best += std::clamp(0.5 * h * (before - behind) / bend, -h, h);
            least = cost(seen, start, best);
        }
    }
    RadialTerms radial = start;
    radial.k1 = best;
    return fit_view(seen, radial);
}

double rms_px(const TargetView& view, const SeenPoints& seen) {
    const auto straight = straightened(seen.pixels, view.radial);
    double squares = 0.0;
    for (std::size_t i = 0; i < straight.size(); ++i) {
        squares += (apply(view.projection, seen.points[i]) - straight[i]).squaredNorm();
    }
    const double rms =
        std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, straight.size())));
    return std::isfinite(rms) ? rms : 1e9;
}

}  // namespace kambara
