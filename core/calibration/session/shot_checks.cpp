// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/session/shot_checks.h"

#include <cstdio>
#include <utility>
#include <vector>

#include "core/base/median.h"
#include "core/calibration/session/stillness.h"
#include "core/calibration/target_detector.h"

namespace kambara {
namespace {

std::string tenths(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f", value);
    return text;
}

}  // namespace

RigView find_in_all(const PictureSet& pictures, const Target& target) {
    RigView view;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (pictures[c] == nullptr || pictures[c]->empty()) {
            view.sights[c].fault = "There is no picture.";
            continue;
        }
        auto found = detect_target(*grey_from(pictures[c]), target);
        if (found) {
            view.sights[c].corners = std::move(*found);
        } else {
            view.sights[c].fault = found.error().cause;
        }
    }
    return view;
}

std::string not_found(const RigView& seen, const std::array<bool, most_cameras>& taking_part) {
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (taking_part[c] && seen.sights[c].corners.empty()) {
            const std::string& fault = seen.sights[c].fault;
            return std::string("The ") + camera_names[c] + " camera does not find the target" +
                   (fault.empty() ? "." : ": " + fault);
        }
    }
    return {};
}

std::string not_sharp(const RigView& seen, const SharpnessOptions& options) {
    for (std::size_t c = 0; c < most_cameras; ++c) {
        std::vector<double> widths;
        std::vector<double> sigmas;
        for (const DetectedCorner& corner : seen.sights[c].corners) {
            sigmas.push_back(corner.sigma_px);
            if (corner.blur_px > 0.0) {
                widths.push_back(corner.blur_px);
            }
        }
        const double width = median(std::move(widths));
        const double sigma = median(std::move(sigmas));
        const std::string picture = std::string("The ") + camera_names[c] + " picture";
        if (width > options.most_blur_px) {
            return picture + " is blurred: edges are " + tenths(width) + " px wide.";
        }
        if (sigma > options.most_sigma_px) {
            return picture + " shows the corners to " + tenths(sigma) +
                   " px only: too dark, too small, or blurred.";
        }
    }
    return {};
}

bool repeats(const RigView& seen, const RigView& before, double least_change_px) {
    bool any = false;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (seen.sights[c].corners.empty() || before.sights[c].corners.empty()) {
            continue;
        }
        const auto moved = distance_px(seen.sights[c].corners, before.sights[c].corners);
        if (!moved || *moved >= least_change_px) {
            return false;
        }
        any = true;
    }
    return any;
}

}  // namespace kambara
