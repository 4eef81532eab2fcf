// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/image/image.h"

namespace kambara {

/// A grey picture of a scene at rest by a camera at rest, at one place of its zoom.
struct ZoomView {
    double zoom_share = 0.0;  ///< 0 wide, 1 tele
    ImagePtr grey;
};

struct ZoomPlace {
    double zoom_share = 0.0;
    double magnification = 1.0;  ///< over the widest view
    /// By the scatter of the points, of all steps from the widest view to here.
    double magnification_sigma = 0.0;
    int points = 0;  ///< found again in this picture, of the one before; none at the first place
    double rms_px = 0.0;  ///< of these
};

struct ZoomCalibrationOptions {
    double widest_share =
        0.01;               ///< at most: where the camera's own calibration stands for the view
    int least_points = 20;  ///< of a step
    double largest_rms_px = 2.0;
    double largest_sigma = 0.003;  ///< of a step's magnification, as a share of it
    /// By so much may a picture be larger or smaller than the one before.
    double largest_step = 1.6;
};

/// How much larger a lens shows things at each place of its zoom, place by place: points of each
/// picture, drawn as the next one should show it, are followed into the next one (Lucas-Kanade with
/// pyramids, by OpenCV), and magnification and a small turn of the optical axis are fitted to them
/// by least squares with Tukey's weights; a magnification is the product of the steps up to it.
/// What a zoom does to the distortion is not known: it is taken as core/camera/zoom.h says.
/// Parallax is not modelled: the scene should be far against how far the lens' pupil moves.
/// `camera` is the one of the widest view. Sorts the views. Refuses: fewer than two places, a
/// widest view that is missing, pictures of another size than the camera's, a step that too few
/// points lead over. Any thread.
Result<std::vector<ZoomPlace>> calibrate_zoom(const Camera& camera, std::vector<ZoomView> views,
                                              const ZoomCalibrationOptions& options = {});

}  // namespace kambara
