// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "core/vsystem/frame_source.h"
#include "tests/support/list_grabber.h"

namespace kambara {
namespace {

constexpr std::int64_t ms = 1'000'000;

// A clock that runs only while it is slept on, and can be made to run on its own.
class SleptClock final : public Clock {
  public:
    std::int64_t now_ns() const override { return now_ns_; }
    bool sleep_until_ns(std::int64_t time_ns, std::stop_token stop) override {
        now_ns_ = std::max(now_ns_, time_ns);
        return !stop.stop_requested();
    }
    void pass(std::int64_t ns) { now_ns_ += ns; }

  private:
    std::int64_t now_ns_ = 1000 * ms;
};

class PacedSourceTest : public testing::Test {
  protected:
    PacedSourceTest() {
        std::vector<Frame> frames;
        for (int i = 0; i < 10; ++i) {
            Frame frame;
            frame.picture = std::make_shared<const Image>(8, 8);
            frame.index = i;
            frame.time_ns = 100 * ms * i;
            frames.push_back(frame);
        }
        Grabbers grabbers;
        grabbers.left = std::make_unique<testing_support::ListGrabber>(frames, 8, 8);
        source_ = make_paced_source(make_sequential_source(std::move(grabbers)), clock_);
    }

    // The next set, and how often it was not yet time.
    ImageSet take(int* rounds = nullptr) {
        for (int i = 0;; ++i) {
            auto next = source_->next({});
            EXPECT_TRUE(next);
            if (auto* set = std::get_if<ImageSet>(&*next)) {
                if (rounds != nullptr) {
                    *rounds = i;
                }
                return *set;
            }
            EXPECT_TRUE(std::holds_alternative<NothingYet>(*next));
        }
    }

    SleptClock clock_;
    std::unique_ptr<FrameSource> source_;
};

TEST_F(PacedSourceTest, FramesComeWhenTheirTimeHasCome) {
    const std::int64_t begin_ns = clock_.now_ns();
    for (int i = 0; i < 10; ++i) {
        int rounds = 0;
        const ImageSet set = take(&rounds);
        EXPECT_EQ(set.stereo.left.index, i);
        EXPECT_EQ(clock_.now_ns() - begin_ns, 100 * ms * i);
        EXPECT_EQ(set.arrived_ns, clock_.now_ns());
        EXPECT_EQ(rounds, i == 0 ? 0 : 4);  // it never waits for more than 20 ms
    }
    EXPECT_TRUE(std::holds_alternative<EndOfSource>(*source_->next({})));
}

TEST_F(PacedSourceTest, ALittleLatenessIsMadeUpForALongBreakIsNot) {
    take();
    clock_.pass(150 * ms);
    EXPECT_EQ(take().stereo.left.index, 1);  // due 50 ms ago
    const std::int64_t late_ns = clock_.now_ns();
    take();
    EXPECT_EQ(clock_.now_ns() - late_ns, 50 * ms);
    clock_.pass(5000 * ms);
    const std::int64_t after_ns = clock_.now_ns();
    take();
    EXPECT_EQ(clock_.now_ns(), after_ns);
    take();
    EXPECT_EQ(clock_.now_ns(), after_ns + 100 * ms);
}

TEST_F(PacedSourceTest, AfterASeekItGoesOnAtOnce) {
    take();
    ASSERT_TRUE(source_->seek(7));
    const std::int64_t then_ns = clock_.now_ns();
    EXPECT_EQ(take().stereo.left.index, 7);
    EXPECT_EQ(clock_.now_ns(), then_ns);
    ASSERT_TRUE(source_->seek(2));
    EXPECT_EQ(take().stereo.left.index, 2);
    EXPECT_EQ(clock_.now_ns(), then_ns);
    EXPECT_FALSE(source_->seek(10));
    EXPECT_EQ(take().stereo.left.index, 3);
    EXPECT_EQ(source_->frames(), 10);
}

}  // namespace
}  // namespace kambara
