// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "core/tracking/patch.h"

namespace kambara {

/// How a target has looked: the operator's template, which is never dropped and decides whenever it
/// fits; a mean of what was seen of late in its place, in which a background that goes by and noise
/// average out; and some cut later, when the view had changed. All turn and grow together. One
/// thread.
class AppearanceBank {
  public:
    explicit AppearanceBank(ReferencePatch first, std::size_t most = 5);

    ReferencePatch& first() { return patches_.front(); }
    const ReferencePatch& first() const { return patches_.front(); }
    std::size_t size() const { return patches_.size(); }
    /// How many of them, from the beginning, are the first template and the mean.
    std::size_t anchors() const { return mean_.empty() ? 1 : 2; }
    const ReferencePatch& at(std::size_t i) const { return patches_[i]; }

    /// The later ones by when they last fitted, the newest before the others.
    std::vector<std::size_t> later_by_use() const;
    /// Notes that this one fitted.
    void used(std::size_t i);
    /// Takes what a left picture shows of the target at a place into the mean, by that share.
    void blend(const Camera& left, const Image& grey, const Eigen::Vector3d& point_in_rig_mm,
               double share);
    /// Takes one more. Where there is no room, the one that has not fitted for longest goes.
    void add(ReferencePatch patch);
    /// How the target's plane leant when the first template was cut.
    void lean(const Eigen::Vector2d& slope);
    /// The target was measured to have turned and grown by so much.
    void change(const PlanarChange& by);

  private:
    void start_mean();

    std::size_t most_;
    std::vector<ReferencePatch> patches_;
    std::vector<std::size_t> last_use_;  // by a count of uses
    std::size_t uses_ = 0;
    Rectangle mean_piece_;     // of the picture that the first one was cut from
    std::vector<float> mean_;  // of that piece; empty while nothing was blended
};

}  // namespace kambara
