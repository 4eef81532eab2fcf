// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <thread>
#include <vector>

#include "core/base/bounded_queue.h"
#include "core/base/clock.h"
#include "core/base/latest_value.h"
#include "core/base/work_thread.h"

namespace kambara {
namespace {

TEST(BoundedQueue, KeepsOrderAndCountsWhatItDrops) {
    BoundedQueue<int> queue(2);
    queue.push_dropping_oldest(1);
    queue.push_dropping_oldest(2);
    queue.push_dropping_oldest(3);
    EXPECT_EQ(queue.dropped(), 1u);
    EXPECT_EQ(queue.pop({}), 2);
    EXPECT_EQ(queue.pop({}), 3);
}

TEST(BoundedQueue, ASlowReaderLosesNothingOfAWriterThatWaits) {
    BoundedQueue<int> queue(3);
    std::jthread writer([&](std::stop_token stop) {
        for (int i = 0; i < 1000; ++i) {
            ASSERT_TRUE(queue.push(i, stop));
        }
    });
    for (int i = 0; i < 1000; ++i) {
        ASSERT_EQ(queue.pop({}), i);
    }
    EXPECT_EQ(queue.dropped(), 0u);
}

TEST(BoundedQueue, AStopEndsTheWaitOnBothSides) {
    BoundedQueue<int> queue(1);
    ASSERT_TRUE(queue.push(1, {}));
    bool pushed = true;
    std::jthread writer([&](std::stop_token stop) { pushed = queue.push(2, stop); });
    writer.request_stop();
    writer.join();
    EXPECT_FALSE(pushed);
    EXPECT_EQ(queue.pop({}), 1);

    std::optional<int> popped(9);
    std::jthread reader([&](std::stop_token stop) { popped = queue.pop(stop); });
    reader.request_stop();
    reader.join();
    EXPECT_EQ(popped, std::nullopt);
}

TEST(LatestValue, TheNewestWinsAndTheRestAreCounted) {
    LatestValue<int> mailbox;
    EXPECT_EQ(mailbox.try_take(), std::nullopt);
    mailbox.put(1);
    mailbox.put(2);
    mailbox.put(3);
    EXPECT_EQ(mailbox.take({}), 3);
    EXPECT_EQ(mailbox.overwritten(), 2u);
    EXPECT_EQ(mailbox.try_take(), std::nullopt);
}

TEST(LatestValue, AReaderWaitsForAValueOrAStop) {
    LatestValue<int> mailbox;
    std::optional<int> first;
    std::optional<int> second(9);
    std::jthread reader([&](std::stop_token stop) {
        first = mailbox.take(stop);
        second = mailbox.take(stop);
    });
    mailbox.put(5);
    while (true) {  // until the reader has it
        if (const auto back = mailbox.try_take()) {
            mailbox.put(*back);
            std::this_thread::yield();
            continue;
        }
        break;
    }
    reader.request_stop();
    reader.join();
    EXPECT_EQ(first, 5);
    EXPECT_EQ(second, std::nullopt);
}

TEST(ManualClock, NeverMovesBack) {
    ManualClock clock(100);
    clock.set_ns(50);
    EXPECT_EQ(clock.now_ns(), 100);
    clock.set_ns(150);
    EXPECT_EQ(clock.now_ns(), 150);
}

TEST(ManualClock, WakesTheSleeperAtItsTimeOrByAStop) {
    ManualClock clock;
    EXPECT_TRUE(clock.sleep_until_ns(0, {}));
    bool woken_in_time = false;
    std::jthread sleeper(
        [&](std::stop_token stop) { woken_in_time = clock.sleep_until_ns(1000, stop); });
    clock.set_ns(1000);
    sleeper.join();
    EXPECT_TRUE(woken_in_time);

    bool slept_on = true;
    std::jthread stopped(
        [&](std::stop_token stop) { slept_on = clock.sleep_until_ns(2000, stop); });
    stopped.request_stop();
    stopped.join();
    EXPECT_FALSE(slept_on);
}

TEST(SteadyClock, SleepsNoLessThanAsked) {
    SteadyClock clock;
    const std::int64_t wake_ns = clock.now_ns() + 2'000'000;
    EXPECT_TRUE(clock.sleep_until_ns(wake_ns, {}));
    EXPECT_GE(clock.now_ns(), wake_ns);
}

TEST(WorkThread, DoesWhatItIsGivenInOrderAndWhatThatGivesIt) {
    std::vector<int> done;
    std::promise<void> last;
    WorkThread thread;
    thread.put([&] { thread.put([&] { done.push_back(3), last.set_value(); }); });
    last.get_future().wait();
    std::promise<void> again;
    thread.put([&] { done.push_back(4); });
    thread.put([&] { done.push_back(5), again.set_value(); });
    again.get_future().wait();
    EXPECT_EQ(done, (std::vector{3, 4, 5}));
}

TEST(WorkThread, EndsAfterWhatIsUnderWayAndBeginsNothingMore) {
    std::promise<void> begun;
    std::atomic<int> done = 0;
    WorkThread thread;
    thread.put([&] {
        begun.set_value();
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        ++done;
    });
    begun.get_future().wait();
    thread.end();
    EXPECT_EQ(done, 1);
    thread.put([&] { ++done; });
    thread.end();
    EXPECT_EQ(done, 1);
}

}  // namespace
}  // namespace kambara
