// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/stillness.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

bool within(const RigView& a, const RigView& b, double most_px) {
    for (std::size_t c = 0; c < most_cameras; ++c) {
        const DetectedCorners& before = a.sights[c].corners;
        const DetectedCorners& now = b.sights[c].corners;
        if (before.empty() && now.empty()) {
            continue;
        }
        const auto moved = distance_px(before, now);
        if (!moved || *moved > most_px) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::optional<double> distance_px(const DetectedCorners& a, const DetectedCorners& b) {
    double squares = 0.0;
    std::size_t shared = 0;
    auto other = b.begin();
    for (const DetectedCorner& corner : a) {
        while (other != b.end() && other->id < corner.id) {
            ++other;
        }
        if (other != b.end() && other->id == corner.id) {
            squares += (corner.px - other->px).squaredNorm();
            ++shared;
        }
    }
    if (shared == 0 || 2 * shared < std::max(a.size(), b.size())) {
        return std::nullopt;
    }
    return std::sqrt(squares / static_cast<double>(shared));
}

bool Stillness::still_after(const RigView& seen) {
    if (pairs_ >= 0 && within(first_, seen, options_.most_motion_px)) {
        ++pairs_;
    } else {
        first_ = seen;
        pairs_ = 0;
    }
    return pairs_ >= options_.pairs;
}

}  // namespace kambara
