// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/worker_pool.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace kambara {
namespace {

TEST(WorkerPool, DoesEveryPieceOnceWhateverTheNumberOfThreads) {
    for (const int threads : {0, 1, 2, 7}) {
        WorkerPool pool(threads);
        for (std::size_t count = 0; count < 40; ++count) {
            std::vector<int> done(count, 0);  // each piece has a place of its own
            pool.for_each(count, [&](std::size_t piece) { ++done[piece]; });
            EXPECT_EQ(done, std::vector<int>(count, 1)) << threads << " threads";
        }
    }
}

TEST(WorkerPool, ASinglePieceIsDoneByTheCaller) {
    WorkerPool pool(4);
    std::thread::id by;
    pool.for_each(1, [&](std::size_t) { by = std::this_thread::get_id(); });
    EXPECT_EQ(by, std::this_thread::get_id());
}

// Two pieces that wait for each other end only when they run at the same time.
TEST(WorkerPool, PiecesRunAtTheSameTime) {
    WorkerPool pool(2);
    std::mutex mutex;
    std::condition_variable met;
    std::set<std::thread::id> here;
    pool.for_each(2, [&](std::size_t) {
        std::unique_lock lock(mutex);
        here.insert(std::this_thread::get_id());
        met.notify_all();
        met.wait(lock, [&] { return here.size() == 2; });
    });
    EXPECT_EQ(here.size(), 2U);
}

}  // namespace
}  // namespace kambara
