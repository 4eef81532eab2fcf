// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/head_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "tests/support/told_head.h"

namespace kambara {
namespace {

using testing_support::ToldHead;
using Threading = HeadWorker::Threading;
using Line = ToldHead::Line;

bool until(const std::function<bool()>& is_so) {
    for (int i = 0; i < 1000; ++i) {
        if (is_so()) {
            return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
}

class HeadWorkerTest : public testing::TestWithParam<Threading> {
  protected:
    // Long enough for the worker to look at its clock more than once.
    static void let_it_look() { std::this_thread::sleep_for(std::chrono::milliseconds(80)); }
    void set_ms(int time_ms) { clock_.set_ns(std::int64_t{time_ms} * 1'000'000); }

    ManualClock clock_;
    std::shared_ptr<ToldHead> head_ = std::make_shared<ToldHead>();
    HeadWorker worker_{head_, GetParam(), clock_};
};

TEST_P(HeadWorkerTest, ADriveThatIsNotRenewedEndsByItself) {
    worker_.drive({0.3, -0.1});
    ASSERT_TRUE(until([&] { return head_->lines() == std::vector{Line{"drive", {0.3, -0.1}}}; }));
    set_ms(199);
    let_it_look();
    EXPECT_EQ(head_->count("halt"), 0);
    set_ms(201);
    ASSERT_TRUE(until([&] { return head_->count("halt") == 1; }));
    let_it_look();
    EXPECT_EQ(head_->count("halt"), 1) << "once is enough";
    const auto notes = worker_.take_notes();
    ASSERT_EQ(notes.size(), 1U);
    EXPECT_EQ(notes[0].kind, HeadNote::Kind::warning);
    EXPECT_NE(notes[0].text.find("halted"), std::string::npos);
    // Told anew it turns anew.
    worker_.drive({0.3, -0.1});
    EXPECT_TRUE(until([&] { return head_->count("drive") == 2; }));
}

TEST_P(HeadWorkerTest, ARenewedDriveGoesOnAndIsToldOnce) {
    for (int time_ms = 0; time_ms < 1000; time_ms += 100) {
        set_ms(time_ms);
        worker_.drive({0.2, 0.0});
        let_it_look();
    }
    EXPECT_EQ(head_->lines(), (std::vector{Line{"drive", {0.2, 0.0}}}));
    worker_.drive({0.4, 0.0});
    ASSERT_TRUE(until([&] { return head_->count("drive") == 2; }));
    worker_.halt();
    ASSERT_TRUE(until([&] { return head_->count("halt") == 1; }));
    set_ms(5000);
    let_it_look();
    EXPECT_EQ(head_->count("halt"), 1) << "it was halted already";
    EXPECT_TRUE(worker_.take_notes().empty());
}

TEST_P(HeadWorkerTest, AnotherMotionEndsTheDrivesTime) {
    worker_.drive({0.2, 0.0});
    ASSERT_TRUE(until([&] { return head_->count("drive") == 1; }));
    worker_.command({0.5, 0.1}, true);
    ASSERT_TRUE(until([&] { return head_->count("look") == 1; }));
    set_ms(5000);
    let_it_look();
    EXPECT_EQ(head_->count("halt"), 0);
    worker_.end_drive();
    let_it_look();
    EXPECT_EQ(head_->count("halt"), 0) << "there is no drive to end";
    worker_.drive({0.2, 0.0});
    worker_.end_drive();
    EXPECT_TRUE(until([&] { return head_->count("halt") == 1; }));
}

TEST_P(HeadWorkerTest, TurnsAndSettingsReachTheHead) {
    worker_.set(ZoomHead{0.25});
    worker_.set(AutofocusHead{});
    worker_.set(KeepPreset{1});
    worker_.set(KeepPreset{2});
    ASSERT_TRUE(until([&] { return head_->lines().size() == 4; }));
    EXPECT_EQ(head_->lines(),
              (std::vector<Line>{
                  {"zoom", {0.25, 0.0}}, {"autofocus", {}}, {"keep", {1, 0}}, {"keep", {2, 0}}}));
    worker_.set(FocusHead{0.75});
    ASSERT_TRUE(until([&] { return head_->count("focus") == 1; }));
    worker_.turn(RecallPreset{2});
    ASSERT_TRUE(until([&] { return head_->count("recall") == 1; }));
    worker_.turn(HomeHead{});
    ASSERT_TRUE(until([&] { return head_->count("home") == 1; }));
    worker_.turn(ResetHead{});
    ASSERT_TRUE(until([&] { return head_->count("reset") == 1; }));
    const auto reading = worker_.reading();
    ASSERT_TRUE(reading.lens);
    EXPECT_EQ(*reading.lens, *head_->lens());
    EXPECT_EQ(reading.abilities, head_->abilities());
}

TEST_P(HeadWorkerTest, HaltsWhatItDroveWhenItEnds) {
    const auto ends = [this](const std::function<void(HeadWorker&)>& after) {
        const int before = head_->count("halt");
        after(*std::make_unique<HeadWorker>(head_, GetParam(), clock_));
        return head_->count("halt") - before;
    };
    EXPECT_EQ(ends([](HeadWorker&) {}), 0);
    EXPECT_EQ(ends([](HeadWorker& worker) {
                  worker.command({0.5, 0.1});
              }),
              0)
        << "it comes to its end by itself";
    EXPECT_EQ(ends([](HeadWorker& worker) { worker.drive({0.2, 0.0}); }), 1);
    EXPECT_EQ(ends([](HeadWorker& worker) {
                  worker.drive({0.2, 0.0});
                  worker.halt();
              }),
              1)
        << "also where it could not be told yet";
}

INSTANTIATE_TEST_SUITE_P(, HeadWorkerTest,
                         testing::Values(Threading::own_thread, Threading::inline_calls),
                         [](const auto& one) {
                             return one.param == Threading::own_thread ? "OwnThread" : "Inline";
                         });

}  // namespace
}  // namespace kambara
