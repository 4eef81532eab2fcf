// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/vsystem/frame_source.h"

namespace kambara {
namespace {

class SequentialSource final : public FrameSource {
  public:
    explicit SequentialSource(Grabbers grabbers) : grabbers_(std::move(grabbers)) {}

    Result<NextImages> next(std::stop_token stop) override {
        if (broken_) {
            return *broken_;
        }
        auto left = grabbers_.left->grab(stop);
        if (!left) {
            return left.error();
        }
        ImageSet set;
        if (*left) {
            set.stereo.left = std::move(**left);
        }
        if (grabbers_.right) {
            auto right = grabbers_.right->grab(stop);
            if (!right) {
                return right.error();
            }
            if (left->has_value() != right->has_value() && !stop.stop_requested()) {
                return lengths_differ(left->has_value());
            }
            if (*right) {
                set.stereo.right = std::move(**right);
            }
        }
        if (!*left) {
            return NextImages(EndOfSource{});
        }
        if (grabbers_.pan_tilt) {
            auto third = grabbers_.pan_tilt->grab(stop);
            if (!third) {
                return third.error();
            }
            if (*third) {
                set.pan_tilt = std::move(**third);
            }
        }
        next_ = set.stereo.left.index + 1;
        return NextImages(std::move(set));
    }

    std::uint64_t frames_lost() const override { return 0; }

    std::int64_t frames() const override {
        std::int64_t count = grabbers_.left->info().frames;
        if (grabbers_.right) {
            count = std::min(count, grabbers_.right->info().frames);
        }
        return count;
    }

    Result<Done> seek(std::int64_t frame) override {
        if (frame < 0 || (frames() >= 0 && frame >= frames())) {
            return Error{"There is no frame " + std::to_string(frame) + ": the recording has " +
                             std::to_string(frames()) + ".",
                         "Give a number from 0 to " + std::to_string(frames() - 1) + "."};
        }
        auto done = seek_all(frame);
        if (done) {
            next_ = frame;
        } else if (!seek_all(next_)) {
            broken_ = done.error();  // the cameras no longer agree on where they are
        }
        return done;
    }

  private:
    Result<Done> seek_all(std::int64_t frame) {
        for (GrabberBase* grabber :
             {grabbers_.left.get(), grabbers_.right.get(), grabbers_.pan_tilt.get()}) {
            if (grabber == nullptr) {
                continue;
            }
            if (auto done = grabber->seek(frame); !done) {
                return done;
            }
        }
        return Done{};
    }

    Error lengths_differ(bool left_goes_on) const {
        const GrabberBase& shorter = left_goes_on ? *grabbers_.right : *grabbers_.left;
        const GrabberBase& longer = left_goes_on ? *grabbers_.left : *grabbers_.right;
        return {"The left and right recordings have different lengths: " + shorter.info().name +
                    " ends after " + std::to_string(next_) + " frames, " + longer.info().name +
                    " goes on.",
                "Give two recordings of the same instants, or cut the longer one."};
    }

    Grabbers grabbers_;
    std::int64_t next_ = 0;
    std::optional<Error> broken_;
};

}  // namespace

std::unique_ptr<FrameSource> make_sequential_source(Grabbers grabbers) {
    return std::make_unique<SequentialSource>(std::move(grabbers));
}

}  // namespace kambara
