// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

#include "core/camera/rig.h"
#include "core/image/image.h"
#include "core/image/rectangle.h"

namespace kambara {

/// How a target has changed in its own plane since its patch was cut: turned and grown, over and
/// above what its change of place explains.
struct PlanarChange {
    double scale = 1.0;
    double turn_rad = 0.0;  ///< from the picture's x towards its y

    PlanarChange then(const PlanarChange& next) const {
        return {scale * next.scale, turn_rad + next.turn_rad};
    }
    bool operator==(const PlanarChange&) const = default;
};

/// A piece of a left picture, remembered with what is needed to draw it as it would look elsewhere.
struct ReferencePatch {
    ImagePtr left_grey;                 ///< the picture it was cut from, or the piece that matters
    Eigen::Vector2d centre_px;          ///< the reference point: the template's centre, sub-pixel
    Eigen::Vector2i size_px;            ///< width and height in that picture
    Eigen::Vector3d point_in_rig_mm;    ///< where the reference point was in space
    PlanarChange change{};              ///< since it was cut: it is drawn so changed
    Eigen::Vector2i piece_at_px{0, 0};  ///< where left_grey's first pixel lies in the left picture
    /// How its plane leans when it was cut: change of the rig's z by x and by y. 0: square to z.
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();

    /// The slope now that it has turned in its plane.
    Eigen::Vector2d slope_now() const;
};

/// A reference patch as another camera, or the same one elsewhere, would see it.
struct RenderedPatch {
    Image picture;   ///< the patch, and about it a margin
    int margin = 0;  ///< pixels on each side that transforms need and the comparison leaves out
    /// Of the size of inner(): 0 where a turned patch does not reach. Empty where all counts.
    Image mask;
    /// Where the reference point lies in the patch; its top-left pixel + this = the point's pixel.
    Eigen::Vector2d centre;
    /// The whole pixel of the camera's picture on which the patch's top-left pixel belongs.
    Eigen::Vector2i top_left;

    const Image* mask_or_null() const { return mask.empty() ? nullptr : &mask; }

    /// The patch within `picture`.
    Rectangle inner() const {
        return {margin, margin, picture.width() - 2 * margin, picture.height() - 2 * margin};
    }
};

/// The place that a camera sees at `pixel` where its ray meets the plane at `depth_mm` along the
/// rig's z axis; empty where the ray does not lead forward.
std::optional<Eigen::Vector3d> place_at_depth(const Camera& camera, const Eigen::Vector2d& pixel,
                                              double depth_mm);

/// How a patch is drawn between its pixels. Cubic convolution shifts fine texture by up to 0.02 px,
/// towards whole pixels; the spline through the pixels by next to nothing, in three times the time.
enum class Drawing { fast, exact };

/// Draws the patch for `camera` with its reference point at `point_in_rig_mm`: the patch is taken
/// as a flat piece that leans as `slope` says (by itself square to the rig's z axis), was carried
/// from where it was to the new place, and there changed in its plane as it says. The cameras may
/// be turned against each other: what a turned patch does not reach is masked. Each pixel's ray
/// goes through the camera's lens to that plane, back along the shift, and through the left lens
/// into the reference picture (interpolated), so that neither distortion nor distance bends
/// the comparison. The result covers no more than the reference patch did, the margin aside. Empty
/// where the place is not in the camera's field or the patch would be smaller than 5 x 5.
std::optional<RenderedPatch> render_patch(const ReferencePatch& patch, const Camera& left,
                                          const Camera& camera,
                                          const Eigen::Vector3d& point_in_rig_mm, int margin = 0,
                                          Drawing drawing = Drawing::fast);

/// The other way round: what `grey`, a left picture of now, shows of the target at
/// `point_in_rig_mm`, drawn onto a piece of the picture that the patch was cut from. Empty where
/// that leaves the field.
std::optional<Image> drawn_back(const ReferencePatch& patch, const Camera& left, const Image& grey,
                                const Eigen::Vector3d& point_in_rig_mm, const Rectangle& piece);

}  // namespace kambara
