// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <stop_token>
#include <string>
#include <thread>

#include "core/base/clock.h"
#include "core/devices/pan_tilt_camera.h"
#include "hardware/visca/head_driver.h"
#include "hardware/visca/head_queue.h"
#include "hardware/visca/link.h"

namespace kambara::visca {

/// A VISCA head as a device (PTZ-1 to PTZ-5). A thread of its own speaks to it: no call waits for
/// the line, and what is wanted is kept and told once the head answers (again). `status` is the
/// last position read, moved on towards where the head was told to look; an error while it does not
/// answer.
class EviCamera final : public PanTiltCamera {
  public:
    /// Begins to work at once. `clock` outlives the camera.
    EviCamera(std::unique_ptr<Link> link, const Clock& clock, HeadDriver::Options options);
    /// A halt that the head has not acknowledged is told it first, for 0.3 s at most; other wishes
    /// are dropped, and a drive goes on.
    ~EviCamera() override;

    /// Waits until the head answers and has told where it looks; an error when the time is over.
    Result<Done> wait_until_known(std::int64_t patience_ns);

    std::string name() const override { return name_; }
    /// Of the model; before that is known an EVI-D30's.
    HeadLimits limits() const override;
    HeadAbilities abilities() const override;
    Result<Done> move_to(const HeadAngles& angles) override;
    Result<Done> follow(const HeadAim& aim) override;
    double lag_s() const override { return driver_.lag_s(); }
    Result<Done> move_by_hand(const HeadAngles& angles) override;
    Result<Done> halt() override;
    Result<HeadStatus> status() override;
    Result<Done> drive(double pan_rad_s, double tilt_rad_s) override;
    Result<Done> home() override;
    Result<Done> reset() override;
    Result<Done> zoom_to(double share) override;
    Result<Done> focus_to(double share) override;
    Result<Done> autofocus() override;
    Result<LensStatus> lens() override;
    Result<Done> keep_preset(int number) override;
    Result<Done> recall_preset(int number) override;
    std::vector<HeadNote> take_notes() override;

    const HeadDriver& driver() const { return driver_; }

  private:
    Result<Done> look(const HeadAngles& angles, bool by_hand);
    Result<HeadKind> known_model() const;
    Result<Done> tell(const Message& setting);

    const std::unique_ptr<Link> link_;
    const std::string name_;
    HeadQueue queue_;
    HeadDriver driver_;
    std::jthread thread_;  // last, so that it ends before what it uses
};

/// Opens what a URI names and waits until the head answers: for two seconds at most. `clock`
/// outlives it.
Result<std::unique_ptr<EviCamera>> open_evi_camera(const std::string& uri, const Clock& clock);

}  // namespace kambara::visca
