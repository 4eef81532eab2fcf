// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string_view>

namespace kambara {

/// Levels of blue, green and red, in the order of Image's channels.
using Colour = Eigen::Array3f;

/// What seawater does to light, for blue, green and red (about 460, 540 and 610 nm). A surface of
/// level J at the range z is seen, in sunlight, as J sun exp(-c z) + B (1 - exp(-b z)), the
/// simplified model of Jaffe (1990) and McGlamery (1979); part of what is lost arrives all the
/// same, blurred.
struct Water {
    Eigen::Array3d attenuation_per_m{0.25, 0.25, 0.25};  ///< c: of a beam
    Eigen::Array3d backscatter_per_m{0.25, 0.25, 0.25};  ///< b: how fast the veil closes
    Eigen::Array3d veil_grey{70.0, 70.0, 70.0};          ///< B: endless water in sunlight
    Eigen::Array3d sunlight{1.0, 1.0, 1.0};              ///< at the rig's depth; green is 1
    double forward_share = 0.0;  ///< of the light lost, how much is scattered a little forward
};

enum class WaterKind { grey, clear, coastal, harbour };

/// The kind of the name, as in the profile's key `water`.
std::optional<WaterKind> water_kind(std::string_view name);

/// What a kind of water sets of a profile.
struct WaterPreset {
    double attenuation_per_m;  ///< in green, as is the veil
    double veil_grey;
    double forward_share;
    double blur_px;  ///< of the forward share, for each attenuation length
    double snow_per_litre;
};

WaterPreset preset_of(WaterKind kind);

/// Water of a kind's colours with the given attenuation and veil in green.
Water water_like(WaterKind kind, double attenuation_per_m, double veil_grey, double forward_share);

}  // namespace kambara
