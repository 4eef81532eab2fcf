// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/system_link.h"

#include <gtest/gtest.h>

#include <QtTest>
#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>
#include <utility>

namespace kambara {
namespace {

using ui::OpenedSystem;
using ui::SourceRequest;
using ui::SystemLink;

/// What was told to a system, also once that is gone.
class Told {
  public:
    void add(const Command& command) {
        std::lock_guard lock(mutex_);
        commands_.push_back(command);
    }
    template <class Kind>
    int count() const {
        std::lock_guard lock(mutex_);
        return static_cast<int>(std::count_if(
            commands_.begin(), commands_.end(),
            [](const Command& command) { return std::holds_alternative<Kind>(command); }));
    }

  private:
    mutable std::mutex mutex_;
    std::vector<Command> commands_;
};

class WritingSystem final : public VsystemInterface {
  public:
    explicit WritingSystem(Told& told) : told_(told) {}
    Result<Reply> execute(const Command& command) override {
        told_.add(command);
        return Reply(Done{});
    }
    SnapshotPtr latest() const override { return std::make_shared<const Snapshot>(); }
    Result<ImageSet> images() const override { return ImageSet{}; }
    Rig rig() const override { return {}; }
    std::unique_ptr<Observation> observe(SnapshotObserver) override { return nullptr; }
    std::unique_ptr<Observation> observe_events(EventObserver) override { return nullptr; }

  private:
    Told& told_;
};

class SystemLinkTest : public testing::Test {
  protected:
    static constexpr int patience_ms = 2000;
    SystemLinkTest() {
        QObject::connect(&link_, &SystemLink::opened, [this] { ++opened_; });
        QObject::connect(&link_, &SystemLink::open_failed, [this] { ++failed_; });
    }
    ~SystemLinkTest() override { go_on(); }
    void go_on() {
        if (!std::exchange(went_on_, true)) {
            goes_on_.set_value();
        }
    }
    Result<OpenedSystem> open(const SourceRequest& request) {
        if (request.left == "first") {
            return OpenedSystem{std::make_unique<WritingSystem>(first_), {}};
        }
        begun_ = true;
        goes_on_.get_future().wait();
        if (request.left == "none") {
            return Error{"It is silent.", "Plug it in."};
        }
        return OpenedSystem{std::make_unique<WritingSystem>(second_), {}};
    }
    /// The first system is there, another one takes its time.
    void begin_to_open(const char* other) {
        link_.open({"first", "", ""});
        ASSERT_TRUE(QTest::qWaitFor([&] { return opened_ == 1; }, patience_ms));
        link_.open({other, "", ""});
        ASSERT_TRUE(QTest::qWaitFor([&] { return begun_.load(); }, patience_ms));
    }
    bool until(const std::function<bool()>& so) { return QTest::qWaitFor(so, patience_ms); }

    Told first_;
    Told second_;
    std::atomic<bool> begun_ = false;
    std::promise<void> goes_on_;
    bool went_on_ = false;
    SystemLink link_{[this](const SourceRequest& request) { return open(request); }};
    int opened_ = 0;
    int failed_ = 0;
};

TEST_F(SystemLinkTest, TheHaltKeyWorksWhileAnotherSourceIsOpened) {
    begin_to_open("second");
    link_.send(HaltHead{});
    EXPECT_TRUE(until([&] { return first_.count<HaltHead>() == 1; }));
    EXPECT_TRUE(link_.busy());
    go_on();
    ASSERT_TRUE(until([&] { return opened_ == 2 && !link_.busy(); }));
    EXPECT_EQ(second_.count<HaltHead>(), 0);
    link_.send(HomeHead{});
    EXPECT_TRUE(until([&] { return second_.count<HomeHead>() == 1; }));
    EXPECT_EQ(first_.count<HomeHead>(), 0);
}

TEST_F(SystemLinkTest, WhenAnotherCannotBeOpenedTheOneBeforeGoesOn) {
    begin_to_open("none");
    go_on();
    ASSERT_TRUE(until([&] { return failed_ == 1 && !link_.busy(); }));
    link_.send(HomeHead{});
    EXPECT_TRUE(until([&] { return first_.count<HomeHead>() == 1; }));
}

TEST_F(SystemLinkTest, MayGoWhileASourceIsOpened) {
    auto link = std::make_unique<SystemLink>(
        [this](const SourceRequest& request) { return open(request); });
    link->open({"second", "", ""});
    link->send(HaltHead{});
    ASSERT_TRUE(until([&] { return begun_.load(); }));
    go_on();
    link.reset();
}

}  // namespace
}  // namespace kambara
