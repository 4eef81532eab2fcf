// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "core/base/clock.h"
#include "core/devices/pan_tilt_camera.h"

namespace kambara {

/// A head that turns as an EVI-D30 does: within its limits, each axis at its full speed, to whole
/// motor steps (8.8 a degree of pan, 12 a degree of tilt; geometry: pan-tilt mapping); driven, at
/// one of 24 speeds of pan and 20 of tilt. Its lens has the focal lengths of that camera's (5.4 to
/// 64.8 mm), zoom and focus go end to end in so many seconds, and six presets keep all of it. What
/// it sees is drawn through its zoom, not through its focus. It moves by the clock it is given,
/// which outlives it.
class SimulatedHead final : public PanTiltCamera {
  public:
    static constexpr int presets = 6;

    struct Options {
        HeadLimits limits;
        double pan_steps_per_deg = 8.8;
        double tilt_steps_per_deg = 12.0;
        int pan_speeds = 24;   ///< the slowest is this part of the full speed
        int tilt_speeds = 20;  ///< likewise
        double wide_f_mm = 5.4;
        double tele_f_mm = 64.8;
        double sensor_width_mm = 4.9;
        double lens_range_s = 2.0;  ///< zoom or focus, end to end
        double sharp_focus =
            0.05;  ///< where autofocus goes: things 2 m away, to a near end of 0.1 m
        /// How far an encoder goes before it carries its axis along when it is turned round.
        HeadAngles backlash = {};
    };

    explicit SimulatedHead(std::shared_ptr<const Clock> clock)
        : SimulatedHead(std::move(clock), Options{}) {}
    SimulatedHead(std::shared_ptr<const Clock> clock, const Options& options);

    std::string name() const override { return "simulated EVI-D30"; }
    HeadLimits limits() const override { return options_.limits; }
    HeadAbilities abilities() const override { return {true, true, true, true, true, presets}; }
    Result<Done> move_to(const HeadAngles& angles) override;
    Result<Done> halt() override;
    Result<HeadStatus> status() override;
    /// Where its axes really are, which it can't tell; `status` is of the encoders.
    HeadAngles axes();
    Result<Done> drive(double pan_rad_s, double tilt_rad_s) override;
    /// To its stops and home, as if the motors had lost their steps: here simply home.
    Result<Done> reset() override { return move_to({}); }
    Result<Done> zoom_to(double share) override;
    Result<Done> focus_to(double share) override;
    Result<Done> autofocus() override;
    Result<LensStatus> lens() override;
    Result<Done> keep_preset(int number) override;
    /// Refuses one that nothing was kept in.
    Result<Done> recall_preset(int number) override;

  private:
    /// From one value to another at a speed, since a time.
    struct Course {
        double from = 0.0;
        double to = 0.0;
        double speed = 0.0;
        std::int64_t since_ns = 0;

        double at(std::int64_t time_ns) const;
        void go(double goal, double at_speed, std::int64_t now_ns);
    };
    struct Preset {
        HeadAngles angles;
        double zoom = 0.0;
        double focus = 0.0;
        bool autofocus = true;
    };

    void look(const HeadAngles& angles, std::int64_t now_ns);
    void zoom(double share, std::int64_t now_ns);
    void focus(double share, bool by_itself, std::int64_t now_ns);
    HeadAngles angles_at(std::int64_t time_ns) const;
    HeadAngles axes_at(std::int64_t time_ns) const;
    double view_rad(double zoom_share) const;

    const std::shared_ptr<const Clock> clock_;
    const Options options_;
    std::mutex mutex_;
    Course pan_;
    Course tilt_;
    HeadAngles carried_to_;  // where the axes were when the courses began
    Course zoom_;
    Course focus_;
    bool autofocus_ = true;
    std::array<std::optional<Preset>, presets> kept_;
};

}  // namespace kambara
