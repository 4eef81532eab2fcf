// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "core/vsystem/frame_source.h"

namespace kambara {
namespace {

constexpr std::size_t frames_kept = 4;  // of each camera, while waiting for a partner
constexpr std::chrono::milliseconds patience{50};

class LiveSource final : public FrameSource {
  public:
    LiveSource(Grabbers grabbers, const Clock& clock)
        : grabbers_(std::move(grabbers)), clock_(clock) {
        const double rate_hz = grabbers_.left->info().rate_hz;
        tolerance_ns_ = rate_hz > 0.0 ? static_cast<std::int64_t>(0.5e9 / rate_hz) : 20'000'000;
        for (GrabberBase* grabber :
             {grabbers_.left.get(), grabbers_.right.get(), grabbers_.pan_tilt.get()}) {
            if (grabber != nullptr) {
                inputs_.push_back(std::make_unique<Input>());
            } else {
                inputs_.push_back(nullptr);
            }
        }
        start(0, *grabbers_.left);
        if (grabbers_.right) {
            start(1, *grabbers_.right);
        }
        if (grabbers_.pan_tilt) {
            start(2, *grabbers_.pan_tilt);
        }
    }

    ~LiveSource() override {
        for (auto& input : inputs_) {
            if (input) {
                input->thread.request_stop();
            }
        }
    }

    Result<NextImages> next(std::stop_token stop) override {
        std::unique_lock lock(mutex_);
        std::optional<ImageSet> set;
        arrived_.wait_for(lock, stop, patience, [&] {
            while (auto newer = next_pair()) {
                lost_ += set ? 1 : 0;
                set = std::move(newer);
            }
            return set.has_value() || anything_over();
        });
        if (set) {
            return NextImages(std::move(*set));
        }
        for (const std::size_t which : pair_) {
            if (inputs_[which] && inputs_[which]->error) {
                return *inputs_[which]->error;
            }
        }
        return anything_over() ? NextImages(EndOfSource{}) : NextImages(NothingYet{});
    }

    // The third camera is not needed for positions: the pair goes on without it.
    std::optional<Error> take_fault() override {
        std::lock_guard lock(mutex_);
        return inputs_[2] ? std::exchange(inputs_[2]->error, std::nullopt) : std::nullopt;
    }

    std::uint64_t frames_lost() const override {
        std::lock_guard lock(mutex_);
        return lost_;
    }

  private:
    struct Arrived {
        Frame frame;
        std::int64_t at_ns;
    };

    struct Input {
        std::deque<Arrived> frames;
        std::optional<Error> error;
        bool ended = false;
        std::jthread thread;
    };

    void start(std::size_t which, GrabberBase& grabber) {
        Input& input = *inputs_[which];
        input.thread = std::jthread([this, which, &input, &grabber](const std::stop_token& stop) {
            while (!stop.stop_requested()) {
                auto frame = grabber.grab(stop);
                const std::int64_t now_ns = clock_.now_ns();
                std::lock_guard lock(mutex_);
                if (!frame) {
                    input.error = frame.error();
                } else if (!*frame) {
                    input.ended = true;
                } else if ((*frame)->valid) {
                    input.frames.push_back({std::move(**frame), now_ns});
                    const bool pairs = which < 2;  // the third camera gives its newest only
                    if (input.frames.size() > (pairs ? frames_kept : 1)) {
                        input.frames.pop_front();
                        lost_ += which == 0 ? 1 : 0;  // one a pair
                    }
                }
                const bool over = !frame || !*frame;
                if (over && which == 2) {
                    input.frames.clear();  // its last picture would be shown with the pair for ever
                }
                arrived_.notify_all();
                if (over) {
                    return;
                }
            }
        });
    }

    bool anything_over() const {
        for (const std::size_t which : pair_) {
            const auto& input = inputs_[which];
            if (input && (input->error || input->ended)) {
                return true;
            }
        }
        return false;
    }

    // The oldest pair whose two times agree; what lies before it has no partner and is dropped.
    std::optional<ImageSet> next_pair() {
        auto& left = inputs_[0]->frames;
        ImageSet set;
        if (inputs_[1]) {
            auto& right = inputs_[1]->frames;
            while (!left.empty() && !right.empty() &&
                   std::abs(left.front().frame.time_ns - right.front().frame.time_ns) >
                       tolerance_ns_) {
                auto& older =
                    left.front().frame.time_ns < right.front().frame.time_ns ? left : right;
                older.pop_front();
                ++lost_;
            }
            if (left.empty() || right.empty()) {
                return std::nullopt;
            }
            set.stereo.right = std::move(right.front().frame);
            set.arrived_ns = right.front().at_ns;
            right.pop_front();
        } else if (left.empty()) {
            return std::nullopt;
        }
        set.stereo.left = std::move(left.front().frame);
        set.arrived_ns = std::max(set.arrived_ns, left.front().at_ns);
        left.pop_front();
        if (inputs_[2] && !inputs_[2]->frames.empty()) {
            set.pan_tilt = inputs_[2]->frames.back().frame;  // its instant matters less: the newest
        }
        return set;
    }

    static constexpr std::size_t pair_[] = {0, 1};

    Grabbers grabbers_;
    const Clock& clock_;
    std::int64_t tolerance_ns_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable_any arrived_;
    std::uint64_t lost_ = 0;
    std::vector<std::unique_ptr<Input>> inputs_;  // left, right, pan-tilt; threads end first
};

}  // namespace

std::unique_ptr<FrameSource> make_live_source(Grabbers grabbers, const Clock& clock) {
    return std::make_unique<LiveSource>(std::move(grabbers), clock);
}

}  // namespace kambara
