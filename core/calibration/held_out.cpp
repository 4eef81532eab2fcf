// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/held_out.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/geometry/triangulate.h"

namespace kambara {
namespace {

constexpr std::size_t least_views = 6;
constexpr std::size_t least_corners = 6;

using Seen =
    std::map<int, std::pair<std::optional<Eigen::Vector2d>, std::optional<Eigen::Vector2d>>>;

// The corners that the first two cameras saw, view by view.
std::vector<Seen> pairs_of(const Bundle& bundle) {
    std::vector<Seen> views(bundle.first_from_target.size());
    for (const BundleCorner& corner : bundle.corners) {
        if (corner.used && corner.camera < 2) {
            auto& both = views[static_cast<std::size_t>(corner.view)][corner.id];
            (corner.camera == 0 ? both.first : both.second) = corner.px;
        }
    }
    for (Seen& view : views) {
        std::erase_if(view,
                      [](const auto& one) { return !one.second.first || !one.second.second; });
    }
    return views;
}

std::map<int, Eigen::Vector3d> triangulated(const Seen& view, const Lens& left, const Lens& right,
                                            const RigidTransform& T_left_from_right) {
    std::map<int, Eigen::Vector3d> points;
    for (const auto& [id, px] : view) {
        const auto a = unproject(left, *px.first);
        const auto b = unproject(right, *px.second);
        const auto meeting = a && b ? meeting_of(*a, T_left_from_right * *b) : std::nullopt;
        if (meeting) {
            points[id] = meeting->midpoint_mm;
        }
    }
    return points;
}

class Comparison {
  public:
    explicit Comparison(const std::vector<Eigen::Vector3d>& target_mm) : target_mm_(target_mm) {}

    void add(const std::map<int, Eigen::Vector3d>& points) {
        if (points.size() < least_corners) {
            return;
        }
        ++views_;
        for (const auto& [id, at] : points) {
            add_length(points, id, at);
        }
        Eigen::Vector3d seen_mean = Eigen::Vector3d::Zero();
        Eigen::Vector3d drawn_mean = Eigen::Vector3d::Zero();
        const double n = static_cast<double>(points.size());
        for (const auto& [id, at] : points) {
            seen_mean += at / n;
            drawn_mean += drawn(id) / n;
        }
        for (const auto& [id, at] : points) {
            seen_spread_ += (at - seen_mean).squaredNorm();
            drawn_spread_ += (drawn(id) - drawn_mean).squaredNorm();
        }
    }

    std::optional<HeldOutCheck> result() const {
        if (lengths_ == 0) {
            return std::nullopt;
        }
        return HeldOutCheck{views_, lengths_, sum_ / lengths_, largest_,
                            std::sqrt(seen_spread_ / drawn_spread_) - 1.0};
    }

  private:
    const Eigen::Vector3d& drawn(int id) const { return target_mm_[static_cast<std::size_t>(id)]; }

    // The length to the nearest corner that was seen, where that has a higher number or this is not
    // its nearest: every length once would be tidier, twice does no harm to a mean.
    void add_length(const std::map<int, Eigen::Vector3d>& points, int id,
                    const Eigen::Vector3d& at) {
        double shortest = 1e300;
        double error = 0.0;
        for (const auto& [other, there] : points) {
            const double length = (drawn(other) - drawn(id)).norm();
            if (other != id && length < shortest) {
                shortest = length;
                error = std::abs((there - at).norm() - length);
            }
        }
        ++lengths_;
        sum_ += error;
        largest_ = std::max(largest_, error);
    }

    const std::vector<Eigen::Vector3d>& target_mm_;
    int views_ = 0;
    int lengths_ = 0;
    double sum_ = 0.0;
    double largest_ = 0.0;
    double seen_spread_ = 0.0;
    double drawn_spread_ = 0.0;
};

}  // namespace

std::optional<HeldOutCheck> held_out_check(const Bundle& bundle, const std::stop_token& stop) {
    const auto seen = pairs_of(bundle);
    std::vector<std::size_t> both;  // views that show the target to both
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (seen[i].size() >= least_corners) {
            both.push_back(i);
        }
    }
    if (both.size() < least_views) {
        return std::nullopt;
    }
    Comparison comparison(bundle.target_mm);
    for (const std::size_t half : {std::size_t{0}, std::size_t{1}}) {
        Bundle part = bundle;
        part.estimate_target = false;
        for (BundleCorner& corner : part.corners) {
            const auto at =
                std::find(both.begin(), both.end(), static_cast<std::size_t>(corner.view));
            const auto place = static_cast<std::size_t>(at - both.begin());
            corner.used = corner.used && at != both.end() && place % 2 != half;
        }
        if (!adjust(part, 0.0, stop)) {
            return std::nullopt;
        }
        const auto lens = [&part](std::size_t i) {
            return lens_of(part.cameras[i].lens, part.cameras[i].model, part.cameras[i].sensor);
        };
        const Lens left = lens(0);
        const Lens right = lens(1);
        const RigidTransform T = transform_of(part.cameras[1].camera_from_first).inverse();
        for (std::size_t i = half; i < both.size(); i += 2) {
            comparison.add(triangulated(seen[both[i]], left, right, T));
        }
    }
    return comparison.result();
}

}  // namespace kambara
