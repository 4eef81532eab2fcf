// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/camera/rig.h"

namespace kambara {

/// The exact rays of a camera's pixels as slopes x/z and y/z, with a border of one pixel more.
/// Where a lens has no ray, slopes are far outside every picture.
class PixelRays {
  public:
    explicit PixelRays(const Camera& camera);

    /// The slopes of the four pixels (x, y), (x + 1, y) and, one stride on, those below them.
    const Eigen::Vector2f* from(int x, int y) const {
        return slopes_.data() + static_cast<std::size_t>(y + 1) * stride_ +
               static_cast<std::size_t>(x + 1);
    }
    std::size_t stride() const { return stride_; }

  private:
    std::size_t stride_;
    std::vector<Eigen::Vector2f> slopes_;
};

}  // namespace kambara
