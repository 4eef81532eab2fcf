// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/tsai_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/calibration/tsai_linear.h"

namespace kambara {
namespace {

// The linear stage's candidates that project every point, the best first.
std::vector<TsaiView> starts(const std::vector<SeenPoint>& points, const TsaiFitOptions& options) {
    std::vector<std::pair<double, TsaiView>> rated;
    for (const TsaiView& view : options.coplanar ? tsai_linear_coplanar(points, options.given)
                                                 : tsai_linear(points, options.given)) {
        const double error = squared_error_px2(view, points);
        if (std::isfinite(error)) {
            rated.emplace_back(error, view);
        }
    }
    std::stable_sort(rated.begin(), rated.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<TsaiView> sorted;
    sorted.reserve(rated.size());
    for (const auto& one : rated) {
        sorted.push_back(one.second);
    }
    return sorted;
}

// The better of two, of which one may not be there.
void keep_better(std::optional<TsaiView>& best, const std::optional<TsaiView>& other,
                 const std::vector<SeenPoint>& points) {
    if (other && (!best || squared_error_px2(*other, points) < squared_error_px2(*best, points))) {
        best = other;
    }
}

}  // namespace

TsaiMask told_parameters(const TsaiFitOptions& options) {
    return options.coplanar ? without_s_x(tsai_all) : tsai_all;
}

std::optional<TsaiView> linear_fit(const std::vector<SeenPoint>& points,
                                   const TsaiFitOptions& options) {
    const auto candidates = starts(points, options);
    return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

std::optional<TsaiView> fit(const std::vector<SeenPoint>& points, const TsaiFitOptions& options) {
    std::optional<TsaiView> best;
    for (const TsaiView& candidate : starts(points, options)) {
        keep_better(best, refined(candidate, points, tsai_focal), points);
        if (best && options.method == TsaiMethod::full) {
            break;  // what follows forgets which start it had
        }
    }
    if (!best || options.method == TsaiMethod::basic) {
        return best;
    }
    const TsaiMask all = told_parameters(options);
    TsaiMask but_centre = all;
    but_centre[tsai::c_x] = but_centre[tsai::c_y] = false;
    for (const TsaiMask& free : {but_centre, all}) {
        keep_better(best, refined(*best, points, free), points);
    }
    return best;
}

}  // namespace kambara
