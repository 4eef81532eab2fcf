// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <stop_token>
#include <variant>

#include "core/base/result.h"
#include "core/devices/grabber_base.h"
#include "core/vsystem/snapshot.h"

namespace kambara {

struct EndOfSource {};
struct NothingYet {};
using NextImages = std::variant<ImageSet, EndOfSource, NothingYet>;

/// Brings the pictures of all cameras together, pair by pair. Used by the pipeline's thread.
class FrameSource {
  public:
    virtual ~FrameSource() = default;
    /// Waits for the next set, but not for long: NothingYet lets the caller see to other things.
    virtual Result<NextImages> next(std::stop_token stop) = 0;
    /// Frames dropped because a newer one was there, and frames without a partner.
    virtual std::uint64_t frames_lost() const = 0;
};

/// The grabbers of a system. `right` and `pan_tilt` may be null.
struct Grabbers {
    std::unique_ptr<GrabberBase> left;
    std::unique_ptr<GrabberBase> right;
    std::unique_ptr<GrabberBase> pan_tilt;
};

/// For recordings: takes every frame of each, in step, on the caller's thread. A left and a right
/// recording of different length is an error that says which ended first and where.
std::unique_ptr<FrameSource> make_sequential_source(Grabbers grabbers);

/// For live cameras: a thread each; pairs left and right by time (within half a frame's time),
/// gives the newest pair and counts what it passed over.
std::unique_ptr<FrameSource> make_live_source(Grabbers grabbers);

}  // namespace kambara
