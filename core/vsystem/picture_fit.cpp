// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/picture_fit.h"

#include <cmath>
#include <string>

namespace kambara {
namespace {

std::string size_text(int width, int height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

}  // namespace

Result<Rig> fitted_to_pictures(const Rig& rig, const Grabbers& grabbers) {
    const GrabberInfo left = grabbers.left->info();
    if (grabbers.right) {
        const GrabberInfo right = grabbers.right->info();
        if (left.width_px != right.width_px || left.height_px != right.height_px) {
            return Error{"The left pictures are " + size_text(left.width_px, left.height_px) +
                             " pixels, the right ones " +
                             size_text(right.width_px, right.height_px) + ".",
                         "Give two sources of the same size."};
        }
        if (!rig.right) {
            return Error{"The rig file holds no right camera.",
                         "Calibrate both cameras, or leave the right source out."};
        }
    }
    bool all_fit = true;
    for (const Camera* camera : {&rig.left, rig.right ? &*rig.right : &rig.left}) {
        all_fit =
            all_fit && left.width_px == camera->width_px && left.height_px == camera->height_px;
        const double factor_x = static_cast<double>(left.width_px) / camera->width_px;
        const double factor_y = static_cast<double>(left.height_px) / camera->height_px;
        // A rounded size of the same shape may be off by half a pixel on the shorter side.
        if (std::abs(factor_x / factor_y - 1.0) > 1.0 / left.height_px) {
            return Error{"The pictures are " + size_text(left.width_px, left.height_px) +
                             " pixels, but the rig file is for " +
                             size_text(camera->width_px, camera->height_px) +
                             ", which is another shape.",
                         "Use the rig file that belongs to these pictures, or calibrate anew."};
        }
    }
    return all_fit ? rig : scaled_to(rig, left.width_px, left.height_px);
}

bool fits(const Image& picture, const Camera& camera) {
    return picture.width() == camera.width_px && picture.height() == camera.height_px;
}

}  // namespace kambara
