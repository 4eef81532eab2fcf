// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/snapshot.h"

#include <algorithm>

namespace kambara {

const TrackSnapshot* steered_track(const Snapshot& snapshot) {
    const auto track =
        std::find_if(snapshot.tracks.begin(), snapshot.tracks.end(),
                     [&](const TrackSnapshot& t) { return t.id == snapshot.steered_target; });
    return track == snapshot.tracks.end() ? nullptr : &*track;
}

TrackEstimate steered_estimate(const Snapshot& snapshot) {
    const TrackSnapshot* track = steered_track(snapshot);
    return track != nullptr ? track->estimate : TrackEstimate{};
}

}  // namespace kambara
