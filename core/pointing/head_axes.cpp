// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/pointing/head_axes.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

constexpr double half_step_rad = rad_from_deg(0.06);  // of an EVI-D30's pan, 8.8 steps a degree

double behind(double before, double encoder_by, double backlash) {
    return std::clamp(before + encoder_by, -0.5 * backlash, 0.5 * backlash);
}

double encoder_for(double wanted, double axis, double encoder, double backlash) {
    const double way = wanted - axis;
    return backlash > 0.0 && std::abs(way) <= half_step_rad
               ? encoder
               : wanted + std::copysign(0.5 * backlash, way);
}

bool off(double wanted, double axis, double backlash) {
    return std::abs(wanted - axis) > std::max(half_step_rad, 0.5 * backlash);
}

}  // namespace

void HeadAxes::see(const HeadAngles& encoders) {
    if (seen_) {
        behind_ = {
            behind(behind_.pan_rad, encoders.pan_rad - encoders_.pan_rad, backlash_.pan_rad),
            behind(behind_.tilt_rad, encoders.tilt_rad - encoders_.tilt_rad, backlash_.tilt_rad)};
    }
    encoders_ = encoders;
    seen_ = true;
}

HeadAngles HeadAxes::at(const HeadAngles& encoders) const {
    return {encoders.pan_rad - behind_.pan_rad, encoders.tilt_rad - behind_.tilt_rad};
}

HeadAngles HeadAxes::encoders_for(const HeadAngles& wanted) const {
    const HeadAngles axes = at(encoders_);
    return {encoder_for(wanted.pan_rad, axes.pan_rad, encoders_.pan_rad, backlash_.pan_rad),
            encoder_for(wanted.tilt_rad, axes.tilt_rad, encoders_.tilt_rad, backlash_.tilt_rad)};
}

bool HeadAxes::astray(const HeadAngles& wanted) const {
    const HeadAngles axes = at(encoders_);
    return off(wanted.pan_rad, axes.pan_rad, backlash_.pan_rad) ||
           off(wanted.tilt_rad, axes.tilt_rad, backlash_.tilt_rad);
}

}  // namespace kambara
