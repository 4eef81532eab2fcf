// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>

#include "core/vsystem/vsystem_interface.h"

namespace kambara::testing_support {

/// Waits for a snapshot that is as asked.
inline SnapshotPtr wait_for(VsystemInterface& system,
                            const std::function<bool(const Snapshot&)>& as_asked) {
    std::mutex mutex;
    std::condition_variable_any arrived;
    SnapshotPtr found;
    const auto look = [&](const SnapshotPtr& snapshot) {
        std::lock_guard lock(mutex);
        if (!found && as_asked(*snapshot)) {
            found = snapshot;
            arrived.notify_all();
        }
    };
    const auto observation = system.observe(look);
    look(system.latest());
    std::unique_lock lock(mutex);
    arrived.wait(lock, [&] { return found != nullptr; });
    return found;
}

/// Lets it run and waits until the source is over.
inline SnapshotPtr run_out(VsystemInterface& system) {
    (void)system.execute(Flow{Flow::Kind::run}).ok();
    return wait_for(system, [](const Snapshot& snapshot) {
        return snapshot.run == RunState::ended || snapshot.run == RunState::failed;
    });
}

}  // namespace kambara::testing_support
