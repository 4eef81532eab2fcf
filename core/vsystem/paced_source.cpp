// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <utility>

#include "core/vsystem/frame_source.h"

namespace kambara {
namespace {

constexpr std::int64_t longest_wait_ns = 20'000'000;  // then the caller may see to other things
constexpr std::int64_t break_ns = 250'000'000;        // later than that is not made up for

class PacedSource final : public FrameSource {
  public:
    PacedSource(std::unique_ptr<FrameSource> source, Clock& clock)
        : source_(std::move(source)), clock_(clock) {}

    Result<NextImages> next(std::stop_token stop) override {
        if (!waiting_) {
            auto taken = source_->next(stop);
            if (!taken || !std::holds_alternative<ImageSet>(*taken)) {
                return taken;
            }
            waiting_ = std::move(std::get<ImageSet>(*taken));
        }
        const std::int64_t now_ns = clock_.now_ns();
        std::int64_t due_ns = offset_ns_.value_or(now_ns) + waiting_->stereo.left.time_ns;
        if (!offset_ns_ || now_ns - due_ns > break_ns || due_ns - now_ns > farthest_ahead_ns()) {
            due_ns = now_ns;
            offset_ns_ = now_ns - waiting_->stereo.left.time_ns;
        }
        if (due_ns > now_ns) {
            const std::int64_t until_ns = std::min(due_ns, now_ns + longest_wait_ns);
            if (!clock_.sleep_until_ns(until_ns, stop) || until_ns < due_ns) {
                return NextImages(NothingYet{});
            }
        }
        last_time_ns_ = waiting_->stereo.left.time_ns;
        waiting_->arrived_ns = std::max(due_ns, now_ns);
        return NextImages(*std::exchange(waiting_, std::nullopt));
    }

    std::uint64_t frames_lost() const override { return source_->frames_lost(); }
    std::int64_t frames() const override { return source_->frames(); }

    Result<Done> seek(std::int64_t frame) override {
        auto done = source_->seek(frame);
        if (done) {
            waiting_.reset();
            offset_ns_.reset();
            last_time_ns_.reset();
        }
        return done;
    }

  private:
    // The gap to the frame before, and some more for a clock that is read twice.
    std::int64_t farthest_ahead_ns() const {
        const std::int64_t time_ns = waiting_->stereo.left.time_ns;
        return break_ns + (last_time_ns_ ? std::max<std::int64_t>(0, time_ns - *last_time_ns_) : 0);
    }

    std::unique_ptr<FrameSource> source_;
    Clock& clock_;
    std::optional<ImageSet> waiting_;
    std::optional<std::int64_t> offset_ns_;  // from the recording's time to the clock's
    std::optional<std::int64_t> last_time_ns_;
};

}  // namespace

std::unique_ptr<FrameSource> make_paced_source(std::unique_ptr<FrameSource> source, Clock& clock) {
    return std::make_unique<PacedSource>(std::move(source), clock);
}

}  // namespace kambara
