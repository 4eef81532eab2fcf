// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kambara::visca {

/// One motor: turns to a position or at a speed, with bounded speed and acceleration, between two
/// stops. Positions in steps. Moves on in equal small pieces of time, so that what comes out does
/// not depend on how often it is asked.
class AxisMotion {
  public:
    struct Bounds {
        double low = 0.0;
        double high = 0.0;
        double acceleration = 0.0;  ///< steps/s²
    };

    AxisMotion(const Bounds& bounds, double position)
        : bounds_(bounds), position_(position), target_(position) {}

    double low() const { return bounds_.low; }
    double high() const { return bounds_.high; }
    double position() const { return position_; }
    bool moving() const { return velocity_ != 0.0 || goes_; }
    bool at_low() const { return position_ <= bounds_.low; }
    bool at_high() const { return position_ >= bounds_.high; }

    /// Narrower or wider stops; outside of them it goes back inside only when moved.
    void set_stops(double low, double high);
    /// Beyond a stop: to the stop. Speed in steps/s, above 0.
    void move_to(double target, double speed);
    /// At a speed with its sign until told otherwise or at the stop; 0 brakes.
    void drive(double velocity);
    void advance(double seconds);

  private:
    Bounds bounds_;
    double position_;
    double velocity_ = 0.0;
    double target_;
    double speed_ = 0.0;
    double driven_ = 0.0;
    bool to_target_ = true;
    bool goes_ = false;
};

}  // namespace kambara::visca
