// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>

#include "core/base/angles.h"
#include "hardware/visca/message.h"

namespace kambara::visca {

/// Something that turns the head.
struct Motion {
    enum class Kind {
        look,   ///< to `angles`
        drive,  ///< at `angles` a second
        other,  ///< `message`: home, reset, a preset
    };
    Kind kind = Kind::look;
    HeadAngles angles = {};
    Message message = {};
    bool by_hand = false;
    /// Of a look that steering wants: the angles are its, as of the time it is told.
    std::optional<HeadAim> aim = std::nullopt;
    /// Of a look: how fast it turns there, each axis by itself; empty: as fast as it can.
    std::optional<HeadAngles> speed_rad_s = std::nullopt;
};

/// What is wanted of a head and was not told it yet. A newer motion takes the place of an older
/// one; an operator's comes before steering's and drops the one that waits; a halt drops both.
/// Settings (zoom, focus, presets) keep their order; a newer one of the same kind takes the place
/// of an older one. Members may be called from any thread and never wait.
class HeadQueue {
  public:
    void put(const Motion& motion);
    void halt();
    void put(const Message& setting);

    bool take_halt();
    bool halt_waits() const;
    /// An operator's motion, or else, unless `by_hand_only`, steering's.
    std::optional<Motion> take_motion(bool by_hand_only);
    std::optional<Message> take_setting();
    /// It was not carried out: first again, unless a newer one of its kind waits.
    void put_back(const Message& setting);
    /// How many motions were replaced before the head was told of them.
    std::uint64_t replaced() const;

  private:
    mutable std::mutex mutex_;
    bool halt_ = false;
    std::optional<Motion> by_hand_;
    std::optional<Motion> steering_;
    std::deque<Message> settings_;
    std::uint64_t replaced_ = 0;
};

}  // namespace kambara::visca
