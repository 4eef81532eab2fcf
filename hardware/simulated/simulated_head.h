// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "core/base/clock.h"
#include "core/devices/pan_tilt_camera.h"

namespace kambara {

/// A head that turns as an EVI-D30 does: within its limits, each axis at its full speed, to whole
/// motor steps (8.8 a degree of pan, 12 a degree of tilt; geometry: pan-tilt mapping). It moves by
/// the clock it is given, which outlives it.
class SimulatedHead final : public PanTiltCamera {
  public:
    struct Options {
        HeadLimits limits;
        double pan_steps_per_deg = 8.8;
        double tilt_steps_per_deg = 12.0;
    };

    explicit SimulatedHead(std::shared_ptr<const Clock> clock)
        : SimulatedHead(std::move(clock), Options{}) {}
    SimulatedHead(std::shared_ptr<const Clock> clock, const Options& options);

    std::string name() const override { return "simulated EVI-D30"; }
    HeadLimits limits() const override { return options_.limits; }
    Result<Done> move_to(const HeadAngles& angles) override;
    Result<Done> halt() override;
    Result<HeadStatus> status() override;

  private:
    HeadAngles angles_at(std::int64_t time_ns) const;

    const std::shared_ptr<const Clock> clock_;
    const Options options_;
    std::mutex mutex_;
    HeadAngles from_;
    HeadAngles to_;
    std::int64_t since_ns_ = 0;
};

}  // namespace kambara
