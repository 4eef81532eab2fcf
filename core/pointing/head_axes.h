// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/angles.h"

namespace kambara {

/// Where a head's axes are, from what its encoders tell one after the other. Each axis stands still
/// until its encoder is half the backlash ahead of it and is then carried along (the play operator:
/// Krasnosel'skii and Pokrovskii, Systems with Hysteresis, 1989, section 2): after a way longer
/// than the backlash that is axes_at() (core/camera/head_model.h) with the side it came from,
/// before that it is between the two. Before an axis has moved so far it is taken to be in the
/// middle of its play. Used by one thread at a time.
class HeadAxes {
  public:
    HeadAxes() = default;
    /// Of pan and tilt, none of them negative.
    explicit HeadAxes(const HeadAngles& backlash) : backlash_(backlash) {}

    void see(const HeadAngles& encoders);

    /// Where the axes are when the encoders, which have not turned round since, tell these.
    HeadAngles at(const HeadAngles& encoders) const;
    /// Where the encoders must go so that the axes end at `wanted`, from where they are: the
    /// inverse. An axis that is there already, to half a motor step, stays; else it would be drawn
    /// to and fro through its play for less than it can tell.
    HeadAngles encoders_for(const HeadAngles& wanted) const;
    /// An axis is off by so much that it came from the other side than was thought: the head
    /// overshot, or was on its way still when it was told.
    bool astray(const HeadAngles& wanted) const;

  private:
    HeadAngles backlash_;
    HeadAngles encoders_;
    HeadAngles behind_;  // the axes behind the encoders, within half the backlash
    bool seen_ = false;
};

}  // namespace kambara
