// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>

#include "core/vsystem/frame_source.h"

namespace kambara {
namespace {

// A camera whose frames the test hands over one by one.
class FedGrabber final : public GrabberBase {
  public:
    struct Feed {
        std::mutex mutex;
        std::condition_variable_any fed;
        std::deque<Result<std::optional<Frame>>> waiting;

        void put(std::int64_t time_ns, bool valid = true) {
            Frame frame;
            frame.picture = std::make_shared<const Image>(8, 8);
            frame.time_ns = time_ns;
            frame.valid = valid;
            add(std::optional<Frame>(frame));
        }
        void add(Result<std::optional<Frame>> next) {
            {
                std::lock_guard lock(mutex);
                waiting.push_back(std::move(next));
            }
            fed.notify_all();
        }
    };

    explicit FedGrabber(std::shared_ptr<Feed> feed) : feed_(std::move(feed)) {}

    Result<std::optional<Frame>> grab(std::stop_token stop) override {
        std::unique_lock lock(feed_->mutex);
        if (!feed_->fed.wait(lock, stop, [&] { return !feed_->waiting.empty(); })) {
            return std::optional<Frame>();
        }
        auto next = std::move(feed_->waiting.front());
        feed_->waiting.pop_front();
        return next;
    }
    GrabberInfo info() const override { return {"fed", 8, 8, 30.0, true}; }

  private:
    std::shared_ptr<Feed> feed_;
};

class LiveSourceTest : public testing::Test {
  protected:
    LiveSourceTest()
        : left_(std::make_shared<FedGrabber::Feed>()),
          right_(std::make_shared<FedGrabber::Feed>()),
          source_(make_live_source(
              {std::make_unique<FedGrabber>(left_), std::make_unique<FedGrabber>(right_), nullptr},
              clock_)) {}

    // The next set, however many rounds of patience it takes.
    Result<NextImages> wait() {
        for (;;) {
            auto next = source_->next({});
            if (!next || !std::holds_alternative<NothingYet>(*next)) {
                return next;
            }
        }
    }

    SteadyClock clock_;
    std::shared_ptr<FedGrabber::Feed> left_;
    std::shared_ptr<FedGrabber::Feed> right_;
    std::unique_ptr<FrameSource> source_;
};

TEST_F(LiveSourceTest, PairsByTimeWithinHalfAFrame) {
    right_->put(1'005'000'000);
    left_->put(1'000'000'000);
    const auto next = wait();
    ASSERT_TRUE(next);
    const auto& set = std::get<ImageSet>(*next);
    EXPECT_EQ(set.stereo.left.time_ns, 1'000'000'000);
    EXPECT_EQ(set.stereo.right.time_ns, 1'005'000'000);
    EXPECT_EQ(source_->frames_lost(), 0U);
}

TEST_F(LiveSourceTest, DropsAndCountsFramesWithoutAPartner) {
    left_->put(1'000'000'000);
    left_->put(1'100'000'000);
    right_->put(1'101'000'000);
    const auto next = wait();
    ASSERT_TRUE(next);
    EXPECT_EQ(std::get<ImageSet>(*next).stereo.left.time_ns, 1'100'000'000);
    EXPECT_EQ(source_->frames_lost(), 1U);
}

TEST_F(LiveSourceTest, NeverDeliversAnInvalidFrame) {
    left_->put(1'000'000'000, /*valid=*/false);
    left_->put(1'033'000'000);
    right_->put(1'033'000'000);
    const auto next = wait();
    ASSERT_TRUE(next);
    EXPECT_EQ(std::get<ImageSet>(*next).stereo.left.time_ns, 1'033'000'000);
}

// When more pairs wait than were asked for, the newest is the one that matters.
TEST_F(LiveSourceTest, GivesTheNewestPairAndCountsThoseItPassedOver) {
    for (int i = 0; i < 3; ++i) {
        left_->put(1'000'000'000 + 33'000'000 * i);
    }
    for (int i = 0; i < 3; ++i) {
        right_->put(1'001'000'000 + 33'000'000 * i);
    }
    std::int64_t newest_ns = 0;
    int taken = 0;
    while (newest_ns < 1'066'000'000) {
        const auto next = wait();
        ASSERT_TRUE(next);
        const auto& set = std::get<ImageSet>(*next);
        EXPECT_EQ(set.stereo.right.time_ns - set.stereo.left.time_ns, 1'000'000);
        EXPECT_GT(set.stereo.left.time_ns, newest_ns);
        newest_ns = set.stereo.left.time_ns;
        ++taken;
    }
    EXPECT_EQ(source_->frames_lost(), static_cast<std::uint64_t>(3 - taken));
}

TEST_F(LiveSourceTest, SaysThatNothingHasComeInsteadOfWaitingForever) {
    const auto next = source_->next({});
    ASSERT_TRUE(next);
    EXPECT_TRUE(std::holds_alternative<NothingYet>(*next));
}

TEST_F(LiveSourceTest, PassesOnAFailureAndAnEnd) {
    right_->add(Error{"The cable is out.", "Put it back."});
    EXPECT_EQ(wait().error().cause, "The cable is out.");
    auto feed = std::make_shared<FedGrabber::Feed>();
    const auto mono =
        make_live_source({std::make_unique<FedGrabber>(feed), nullptr, nullptr}, clock_);
    feed->add(std::optional<Frame>());
    Result<NextImages> next = NextImages(NothingYet{});
    while (next && std::holds_alternative<NothingYet>(*next)) {
        next = mono->next({});
    }
    ASSERT_TRUE(next);
    EXPECT_TRUE(std::holds_alternative<EndOfSource>(*next));
}

}  // namespace
}  // namespace kambara
