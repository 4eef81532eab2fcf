// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/camera/rig.h"
#include "core/image/image.h"
#include "core/image/rectangle.h"

namespace kambara {

/// A piece of a left picture, remembered with what is needed to draw it as it would look elsewhere.
struct ReferencePatch {
    ImagePtr left_grey;               ///< the whole picture it was cut from
    Eigen::Vector2d centre_px;        ///< the reference point: the template's centre, sub-pixel
    Eigen::Vector2i size_px;          ///< width and height in that picture
    Eigen::Vector3d point_in_rig_mm;  ///< where the reference point was in space
};

/// A reference patch as another camera, or the same one elsewhere, would see it.
struct RenderedPatch {
    Image picture;   ///< the patch, and about it a margin
    int margin = 0;  ///< pixels on each side that transforms need and the comparison leaves out
    /// Where the reference point lies in the patch; its top-left pixel + this = the point's pixel.
    Eigen::Vector2d centre;
    /// The whole pixel of the camera's picture on which the patch's top-left pixel belongs.
    Eigen::Vector2i top_left;

    /// The patch within `picture`.
    Rectangle inner() const {
        return {margin, margin, picture.width() - 2 * margin, picture.height() - 2 * margin};
    }
};

/// Draws the patch for `camera` with its reference point at `point_in_rig_mm`: the patch is taken
/// as a flat piece square to the rig's z axis that was carried from where it was, unturned, to the
/// new place. Each pixel's ray goes through the camera's lens to that plane, back along the shift,
/// and through the left lens into the reference picture (cubic interpolation), so that neither
/// distortion nor distance bends the comparison. The result covers no more than the reference patch
/// did, the margin aside. Empty where the place is not in the camera's field or the patch would be
/// smaller than 5 x 5.
std::optional<RenderedPatch> render_patch(const ReferencePatch& patch, const Camera& left,
                                          const Camera& camera,
                                          const Eigen::Vector3d& point_in_rig_mm, int margin = 0);

}  // namespace kambara
