// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "core/image/image.h"
#include "core/tracking/tracker_options.h"

namespace kambara::testing_support {

/// A box of pixels, (x, y) its top-left corner, counted from the first pixel's centre.
struct Box {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
};

/// A recording with the true box of one target in every frame.
struct BoxSequence {
    std::vector<ImagePtr> colour;
    std::vector<Box> truth;
};

/// Reads `groundtruth_rect.txt` (x y w h a line, pixels counted from 1) and `img/0001.jpg`, ... of
/// a folder; empty where they are not there.
BoxSequence read_box_sequence(const std::filesystem::path& folder);

/// Intersection over union.
double overlap(const Box& a, const Box& b);

struct BoxScore {
    double overlap = 0.0;  ///< mean over the frames after the first
    double near = 0.0;     ///< share of them whose centre is within 20 px
};

/// What a tracker's boxes are worth, frame by frame from the second on; none where it has lost the
/// target.
BoxScore score_of(const BoxSequence& sequence, const std::vector<std::optional<Box>>& found);

/// Nine first boxes: the true one, and moved by up to 2 px.
std::vector<Box> nine_starts(const BoxSequence& sequence);

/// What our tracker finds in grey pictures, with one camera of which nothing is known.
std::vector<std::optional<Box>> followed(const BoxSequence& sequence, const Box& first,
                                         const TrackerOptions& options = {});

}  // namespace kambara::testing_support
