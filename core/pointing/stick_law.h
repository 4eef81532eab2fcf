// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "core/base/pad_reading.h"

namespace kambara {

enum class PadState {
    absent,
    centre_first,  ///< sticks and triggers must be let go before they count
    armed,
    frozen,  ///< it is not read any more, or the stick has not moved by a hair for too long
};

/// What the operator wants by it. Shares of the full speed, right, up and tele positive.
struct StickWish {
    PadState state = PadState::absent;
    double pan = 0.0;
    double tilt = 0.0;
    double zoom = 0.0;
    bool halt = false;

    bool turns() const { return pan != 0.0 || tilt != 0.0; }
};

/// From a gamepad's sticks to what the operator wants: a round dead zone, the square of what is
/// beyond it (slow near the middle), and the rules that keep a pad that was plugged in, dropped or
/// hangs from turning the head:
///
///   absent --plugged in--> centre first --all let go--> armed
///                             ^   ^                       |
///          read again         |   '--- halt button -------+
///   frozen -------------------'                           |
///      ^------- not read, or held still for too long -----'
///
/// Another pad, or one that was away, begins anew. Knows no device and is told the time.
class StickLaw {
  public:
    struct Options {
        double dead_zone = 0.15;  ///< of the stick's way
        double silent_s = 0.12;   ///< so old a reading counts as frozen
        /// Likewise, deflected and not changed in the last digit: how long a head turns on after a
        /// radio link broke. A hand trembles 8 to 12 times a second (Deuschl, Bain, Brin 1998):
        /// some thirty times in this, of which one moves a stick of 8 bits by a digit. Chosen, not
        /// measured with pads. A stick that knows only its ends never moves: it must be let go so
        /// often.
        double held_still_s = 3.0;
    };

    StickLaw() : StickLaw(Options{}) {}
    explicit StickLaw(const Options& options) : options_(options) {}

    /// `now_ns` on the readings' clock. As often as the head is to be told, every 50 ms at least.
    StickWish update(const PadReading& reading, std::int64_t now_ns);
    /// All must be let go before anything counts again.
    void disarm() { armed_ = false; }

  private:
    bool let_go(const PadReading& reading) const;
    bool held_too_still(const PadReading& reading, std::int64_t now_ns);

    Options options_;
    bool armed_ = false;
    bool frozen_ = false;  // held still: until it is let go
    PadReading last_;
    std::int64_t changed_ns_ = 0;
};

}  // namespace kambara
