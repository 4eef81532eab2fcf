// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>

#include "core/base/result.h"
#include "core/image/frame.h"

namespace kambara {

/// What a source of pictures says of itself once it is open.
struct GrabberInfo {
    std::string name;  ///< as the operator would name it: a device, a file, a pattern
    int width_px = 0;
    int height_px = 0;
    double rate_hz = 0.0;      ///< nominal; 0 where the source has none (single pictures)
    bool live = false;         ///< pictures come by themselves and are lost if nobody takes them
    std::int64_t frames = -1;  ///< how many there are; -1 where that is not known
};

/// A source of pictures: a camera, a recording, a folder of pictures, a simulation.
/// (Acquisition: one grabber interface for all sources.) A grabber is opened by whoever makes it,
/// used by one thread at a time, and closes when it is destroyed.
class GrabberBase {
  public:
    virtual ~GrabberBase() = default;

    /// Waits for the next frame. Empty at the source's end or once a stop is requested; an error
    /// when the source fails (a truncated video, a picture of another size): it then stays failed.
    virtual Result<std::optional<Frame>> grab(std::stop_token stop) = 0;

    virtual GrabberInfo info() const = 0;

    /// Goes on with that frame, forwards or backwards. Sources that can't be wound refuse; a
    /// refusal leaves the source where it was.
    virtual Result<Done> seek(std::int64_t /*index*/) {
        return Error{info().name + " can't be wound to another frame.", "Let it run."};
    }
};

}  // namespace kambara
