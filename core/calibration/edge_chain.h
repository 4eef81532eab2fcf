// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <vector>

#include "core/image/image.h"

namespace kambara {

struct EdgeChainOptions {
    /// How far from an edge its dark and its light side are looked for; what is narrower than this
    /// keeps its own edges as long as a pixel of the other level lies between.
    int reach_px = 5;
    double least_contrast = 24.0;  ///< between both sides, grey levels
    int least_length = 12;         ///< pixels of a chain
};

/// The pixels just outside a dark region, one after the other around it; the edge runs half a pixel
/// inside them.
using EdgeChain = std::vector<Eigen::Vector2i>;

/// The closed edge chains around the dark regions of a grey picture. A pixel is dark where it is
/// nearer to the darkest than to the lightest pixel about it and these differ enough: so every edge
/// has its own threshold, half-way between its two sides, whatever the light. Chains that touch
/// the picture's frame are left out. Any thread.
std::vector<EdgeChain> closed_edge_chains(const Image& grey, const EdgeChainOptions& options);

/// The centre of the area that a chain encloses.
Eigen::Vector2d centroid_of(const EdgeChain& chain);

}  // namespace kambara
