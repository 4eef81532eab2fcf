// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/stepped_run.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <utility>

namespace kambara::testing_support {

std::unique_ptr<VsystemInterface> opened_in_step(VisionSystemParts parts, Clock& clock) {
    VisionSystemOptions options;
    options.every_frame = true;
    options.start_paused = true;
    auto opened = open_vision_system(std::move(parts), options, clock);
    EXPECT_TRUE(opened.ok()) << opened.error().text();
    return opened ? std::move(*opened) : nullptr;
}

void run_to_end(VsystemInterface& system, const std::vector<Command>& commands,
                const std::function<void(const Snapshot&)>& each) {
    std::mutex mutex;
    std::condition_variable changed;
    std::uint64_t seen = 0;
    bool over = false;
    const auto observation = system.observe([&](const SnapshotPtr& snapshot) {
        const std::lock_guard lock(mutex);
        each(*snapshot);
        over = over || snapshot->run == RunState::ended || snapshot->run == RunState::failed;
        ++seen;
        changed.notify_all();
    });
    std::vector<Command> all = commands;
    all.push_back(Flow{Flow::Kind::run});
    for (const Command& command : all) {
        const auto done = system.execute(command);
        EXPECT_TRUE(done.ok()) << done.error().text();
    }
    std::unique_lock lock(mutex);
    while (!over) {
        const std::uint64_t before = seen;
        if (!changed.wait_for(lock, std::chrono::minutes(2), [&] { return seen != before; })) {
            ADD_FAILURE() << "nothing came for two minutes";
            return;
        }
    }
}

}  // namespace kambara::testing_support
