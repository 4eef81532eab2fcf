// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/water.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace kambara {
namespace {

using Eigen::Array3d;

// Diffuse attenuation, 1/m, at 460, 540 and 610 nm and at 520, between the lines of Jerlov's table
// (Marine Optics, 1976, table XXVII), for the water types II, C3 and C9. Only their colours are
// used. A beam loses more than daylight does: published at 520 nm are 0.0987 per m for the clear
// ocean, and 0.3 to 0.4 and 2 or more are usual for coasts and harbours. Types of one name differ
// severalfold between publications, so that all of these are settings and not truths.
struct Kind {
    Array3d diffuse_per_m;
    double diffuse_at_520_per_m;
    double beam_at_520_per_m;
    double backscatter_ratio;  // b / c: light scattered more than once is lost more slowly
    // As a picture exposed for the target shows it. Water scatters all colours nearly alike, so
    // that B b / sunlight must be about the same for all three, else lamps make a coloured fog.
    Array3d veil_grey;
    double depth_m;      // of the rig: what the sun's colour is
    WaterPreset others;  // its first two follow from the above

    double scale() const { return beam_at_520_per_m / diffuse_at_520_per_m; }
};

const Kind& table_of(WaterKind kind) {
    static const Kind kinds[] = {
        {{0.25, 0.25, 0.25}, 0.25, 0.25, 1.0, {70, 70, 70}, 0.0, {0, 0, 0.0, 0.0, 0.0}},
        {{0.0656, 0.0852, 0.288}, 0.0776, 0.0987, 1.0, {150, 88, 9}, 5.0, {0, 0, 0.3, 2.0, 0.1}},
        {{0.35, 0.196, 0.356}, 0.208, 0.35, 0.9, {52, 95, 44}, 2.0, {0, 0, 0.4, 2.0, 1.0}},
        {{1.452, 0.702, 0.632}, 0.846, 2.0, 0.8, {30, 88, 84}, 0.5, {0, 0, 0.5, 1.5, 5.0}}};
    return kinds[static_cast<std::size_t>(kind)];
}

}  // namespace

std::optional<WaterKind> water_kind(std::string_view name) {
    for (const auto& [known, kind] :
         {std::pair{"clear", WaterKind::clear}, std::pair{"coastal", WaterKind::coastal},
          std::pair{"harbour", WaterKind::harbour}}) {
        if (name == known) {
            return kind;
        }
    }
    return std::nullopt;
}

WaterPreset preset_of(WaterKind kind) {
    const Kind& table = table_of(kind);
    WaterPreset preset = table.others;
    preset.attenuation_per_m = table.scale() * table.diffuse_per_m[1];
    preset.veil_grey = table.veil_grey[1];
    return preset;
}

Water water_like(WaterKind kind, double attenuation_per_m, double veil_grey, double forward_share) {
    const Kind& table = table_of(kind);
    const Array3d& diffuse = table.diffuse_per_m;
    Water water;
    water.attenuation_per_m = attenuation_per_m * (diffuse / diffuse[1]);
    water.backscatter_per_m = table.backscatter_ratio * water.attenuation_per_m;
    water.veil_grey = veil_grey * (table.veil_grey / table.veil_grey[1]);
    water.sunlight = (-(diffuse - diffuse[1]) * table.depth_m).exp();
    water.forward_share = forward_share;
    return water;
}

}  // namespace kambara
