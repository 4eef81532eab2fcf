// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/joint_adjustment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/median.h"
#include "core/calibration/mono_start.h"

namespace kambara {
namespace {

constexpr double rejected_above_median = 3.0;  // a picture's residual, in units of the median one's
constexpr double never_rejected_px = 0.5;
constexpr double outlier_sigmas = 6.0;
constexpr double never_outlier_px = 0.6;
constexpr double k3_shows = 4.0;  // fall of the squares a camera, in units of the variance

double weighted_squares(const Bundle& bundle) {
    double sum = 0.0;
    for (const BundleCorner& corner : bundle.corners) {
        const auto r = corner.used ? residual_px(bundle, corner) : std::nullopt;
        sum += r ? r->squaredNorm() / std::pow(corner.sigma_px, 2) : 0.0;
    }
    return sum;
}

// A picture each, view by view and in a view camera by camera.
struct Picture {
    double sum_px2 = 0.0;
    int used = 0;
    int all = 0;
    double rms_px() const { return used > 0 ? std::sqrt(sum_px2 / used) : 0.0; }
};

std::vector<Picture> pictures_of(const Bundle& bundle) {
    const std::size_t cameras = bundle.cameras.size();
    std::vector<Picture> pictures(bundle.first_from_target.size() * cameras);
    for (const BundleCorner& corner : bundle.corners) {
        Picture& picture = pictures[static_cast<std::size_t>(corner.view) * cameras +
                                    static_cast<std::size_t>(corner.camera)];
        ++picture.all;
        if (corner.used) {
            ++picture.used;
            picture.sum_px2 +=
                residual_px(bundle, corner).value_or(Eigen::Vector2d(9, 9)).squaredNorm();
        }
    }
    return pictures;
}

}  // namespace

double robust_px(const Bundle& bundle) {
    std::vector<Eigen::Vector2d> residuals;
    for (const BundleCorner& corner : bundle.corners) {
        if (const auto r = residual_px(bundle, corner)) {
            residuals.push_back(*r);
        }
    }
    return 3.0 * std::max(0.02, robust_sigma_px(residuals));
}

void drop_outliers(Bundle& bundle) {
    const double far_px = std::max(never_outlier_px, outlier_sigmas / 3.0 * robust_px(bundle));
    for (BundleCorner& corner : bundle.corners) {
        const auto r = residual_px(bundle, corner);
        corner.used = r && r->norm() <= far_px;
    }
}

std::vector<Misfit> drop_misfits(Bundle& bundle) {
    const auto pictures = pictures_of(bundle);
    std::vector<double> known;
    for (const Picture& picture : pictures) {
        if (picture.used > 0) {
            known.push_back(picture.rms_px());
        }
    }
    std::vector<Misfit> misfits;
    if (known.empty()) {
        return misfits;
    }
    const double far_px = std::max(never_rejected_px, rejected_above_median * median(known));
    const std::size_t cameras = bundle.cameras.size();
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        const Picture& picture = pictures[i];
        const bool far = picture.rms_px() > far_px;
        const bool out = 10 * picture.used < 6 * picture.all;
        const auto view = static_cast<int>(i / cameras);
        if ((!far && !out) || (!misfits.empty() && misfits.back().view == view)) {
            continue;
        }
        misfits.push_back({view, static_cast<int>(i % cameras), picture.rms_px(), !far});
        for (BundleCorner& corner : bundle.corners) {
            corner.used = corner.used && corner.view != view;
        }
    }
    return misfits;
}

void free_k3_where_it_shows(Bundle& bundle, std::stop_token stop) {
    Bundle freed = bundle;
    for (BundleCamera& camera : freed.cameras) {
        camera.free_k3 = true;
    }
    if (!adjust(freed, 0.0, std::move(stop))) {
        return;
    }
    const double before = weighted_squares(bundle);
    const double after = weighted_squares(freed);
    const auto used = std::count_if(bundle.corners.begin(), bundle.corners.end(),
                                    [](const BundleCorner& corner) { return corner.used; });
    const auto cameras = static_cast<double>(bundle.cameras.size());
    const double unknowns =
        6.0 * static_cast<double>(bundle.first_from_target.size()) + 15.0 * cameras;
    const double variance = after / std::max(1.0, 2.0 * static_cast<double>(used) - unknowns);
    if (before - after > k3_shows * cameras * variance) {
        bundle = std::move(freed);
    }
}

}  // namespace kambara
