// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <mutex>
#include <string>
#include <vector>

#include "core/devices/pan_tilt_camera.h"

namespace kambara::testing_support {

/// A head that can do everything, and writes down what it was told.
class ToldHead final : public PanTiltCamera {
  public:
    std::string name() const override { return "told"; }
    HeadLimits limits() const override { return reach; }
    HeadAbilities abilities() const override {
        std::lock_guard lock(mutex_);
        return able_;
    }
    Result<Done> move_to(const HeadAngles& angles) override { return write("steer", angles); }
    Result<Done> move_by_hand(const HeadAngles& angles) override { return write("look", angles); }
    Result<Done> halt() override { return write("halt"); }
    Result<HeadStatus> status() override {
        std::lock_guard lock(mutex_);
        return status_;
    }
    Result<Done> drive(double pan_rad_s, double tilt_rad_s) override {
        return write("drive", {pan_rad_s, tilt_rad_s});
    }
    Result<Done> home() override { return write("home"); }
    Result<Done> reset() override { return write("reset"); }
    Result<Done> zoom_to(double share) override { return write("zoom", {share, 0.0}); }
    Result<Done> focus_to(double share) override { return write("focus", {share, 0.0}); }
    Result<Done> autofocus() override { return write("autofocus"); }
    Result<LensStatus> lens() override { return LensStatus{0.5, 0.25, 0.5, 0.75, false}; }
    Result<Done> keep_preset(int number) override { return write("keep", {1.0 * number, 0.0}); }
    Result<Done> recall_preset(int number) override { return write("recall", {1.0 * number, 0.0}); }

    /// What it says from now on.
    void say(const Result<HeadStatus>& status) {
        std::lock_guard lock(mutex_);
        status_ = status;
    }

    void can(const HeadAbilities& able) {
        std::lock_guard lock(mutex_);
        able_ = able;
    }

    struct Line {
        std::string what;
        HeadAngles with;
        bool operator==(const Line&) const = default;
    };
    std::vector<Line> lines() const {
        std::lock_guard lock(mutex_);
        return lines_;
    }
    int count(const std::string& what) const {
        const auto all = lines();
        return static_cast<int>(std::count_if(all.begin(), all.end(),
                                              [&](const Line& line) { return line.what == what; }));
    }

    HeadLimits reach;  // not to be changed any more once it is used

  private:
    Result<Done> write(const std::string& what, const HeadAngles& with = {}) {
        std::lock_guard lock(mutex_);
        lines_.push_back({what, with});
        return Done{};
    }

    mutable std::mutex mutex_;
    std::vector<Line> lines_;
    Result<HeadStatus> status_ = HeadStatus{};
    HeadAbilities able_{true, true, true, true, true, 6};
};

}  // namespace kambara::testing_support
