// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/observer_list.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace kambara {
namespace {

TEST(ObserverList, CallsThoseWhoAreThereAndNoOthers) {
    ObserverList<int> list;
    int a = 0;
    int b = 0;
    auto first = list.add([&](int value) { a += value; });
    {
        auto second = list.add([&](int value) { b += value; });
        list.notify(1);
    }
    list.notify(10);
    first.reset();
    list.notify(100);
    EXPECT_EQ(a, 11);
    EXPECT_EQ(b, 1);
}

TEST(ObserverList, AnObserverMayLetGoOfItselfAndAddAnother) {
    ObserverList<int> list;
    int calls = 0;
    int later = 0;
    std::unique_ptr<Observation> self;
    std::unique_ptr<Observation> other;
    self = list.add([&](int) {
        ++calls;
        other = list.add([&](int) { ++later; });
        self.reset();
    });
    list.notify(0);
    list.notify(0);
    EXPECT_EQ(calls, 1);
    EXPECT_EQ(later, 1);
}

TEST(ObserverList, LettingGoWaitsForACallThatIsUnderWay) {
    ObserverList<int> list;
    std::atomic<bool> inside{false};
    std::atomic<bool> may_leave{false};
    std::atomic<bool> left{false};
    auto observation = list.add([&](int) {
        inside = true;
        while (!may_leave) {
            std::this_thread::yield();
        }
        left = true;
    });
    std::jthread caller([&] { list.notify(0); });
    while (!inside) {
        std::this_thread::yield();
    }
    std::jthread releaser([&] { may_leave = true; });
    observation.reset();
    EXPECT_TRUE(left);
}

// An observer that notifies in turn, and lets go of itself in the inner call.
TEST(ObserverList, AnObserverMayEndItselfWithinACallOfItsOwn) {
    ObserverList<int> list;
    int calls = 0;
    std::unique_ptr<Observation> self;
    self = list.add([&](int depth) {
        ++calls;
        if (depth == 0) {
            list.notify(1);
        } else {
            self.reset();
        }
    });
    list.notify(0);
    list.notify(0);
    EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace kambara
