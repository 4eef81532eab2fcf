// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "core/base/result.h"
#include "core/camera/rig.h"
#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

namespace kambara {

using SnapshotObserver = std::function<void(const SnapshotPtr&)>;
using EventObserver = std::function<void(const Event&)>;

/// Ends an observation when it is destroyed. After that the observer is not called again, and a
/// call that was under way has returned (unless it is the observer itself that lets go).
class Observation {
  public:
    virtual ~Observation() = default;
};

/// The door between the vision system and whatever commands it: a window, the command line, a
/// vehicle (SYS-1). All members may be called from any thread.
class VsystemInterface {
  public:
    virtual ~VsystemInterface() = default;

    /// Carries out a command, between two pairs of pictures, and says how it went. A refused
    /// command changes nothing.
    virtual Result<Reply> execute(const Command& command) = 0;

    /// The newest snapshot; never null.
    virtual SnapshotPtr latest() const = 0;

    /// The newest set of pictures. An error before the first.
    virtual Result<ImageSet> images() const = 0;

    /// The calibration in use.
    virtual Rig rig() const = 0;

    /// The observers are called on the pipeline's thread, with no lock held: they return soon and
    /// leave slow work to a thread of their own (LatestValue, BoundedQueue). They may execute
    /// commands.
    [[nodiscard]] virtual std::unique_ptr<Observation> observe(SnapshotObserver observer) = 0;
    [[nodiscard]] virtual std::unique_ptr<Observation> observe_events(EventObserver observer) = 0;
};

}  // namespace kambara
