// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/angles.h"
#include "core/base/result.h"
#include "hardware/visca/message.h"

namespace kambara::visca {

/// One motor's numbers.
struct AxisModel {
    double least_deg = 0.0;
    double most_deg = 0.0;
    double steps_per_deg = 1.0;
    int sign = 1;  ///< of the steps to the right or upwards
    int nibbles = 4;
    int fastest_code = 1;  ///< 0: the axis has no speed of its own, and 0 is what is said
    double fastest_deg_s = 1.0;
    bool operator==(const AxisModel&) const = default;

    /// The nearest whole step, within the axis' ends.
    int steps_from_deg(double angle_deg) const;
    double deg_from_steps(double steps) const { return sign * steps / steps_per_deg; }
    /// The code for at most this speed, and at least the slowest there is.
    int code_for(double speed_deg_s) const;
    /// The code nearest to this speed, likewise.
    int nearest_code(double speed_deg_s) const;
    /// What a code means; speeds are linear in their codes.
    double speed_deg_s(int code) const;
};

struct ZoomModel {
    int tele = 1;
    /// 0 where the lens is not known.
    double wide_f_mm = 0.0;
    double tele_f_mm = 0.0;
    double sensor_width_mm = 0.0;
    /// Positions and focal lengths, measured, between which the focal length's logarithm is
    /// straight; empty: f = wide (tele/wide)^(position/end), a placeholder that only the ends are
    /// known of.
    std::vector<std::pair<double, double>> curve = {};
    bool operator==(const ZoomModel&) const = default;

    /// 0 where the lens is not known.
    double horizontal_view_rad(double position) const;
};

/// What a kind of head means by its numbers, from resources/heads/visca.yaml.
struct HeadKind {
    std::string name;
    std::vector<int> models;  ///< of the version inquiry
    AxisModel pan;
    AxisModel tilt;
    ZoomModel zoom;
    int focus_far = 0;
    int focus_near = 0;
    int presets = 6;
    bool replaces_moves = true;
    double cancel_wait_s = 0.0;
    bool operator==(const HeadKind&) const = default;

    Dialect dialect() const { return {pan.nibbles}; }
    /// The largest range about home that is the same on both sides.
    HeadLimits limits() const;
};

/// The table that is built in: resources/heads/visca.yaml.
const std::vector<HeadKind>& built_in_heads();

/// Such a table from text or a file. Refuses, naming the key at fault. Any bytes are safe to pass.
Result<std::vector<HeadKind>> heads_from_text(std::string_view text);
Result<std::vector<HeadKind>> read_heads_file(const std::filesystem::path& path);

/// A table as heads_from_text reads it back.
std::string heads_to_text(const std::vector<HeadKind>& heads);
/// Writes one, unless it could not be read back. A file that is there keeps nothing, comments
/// neither.
Result<Done> write_heads_file(const std::filesystem::path& path,
                              const std::vector<HeadKind>& heads);

std::optional<HeadKind> find_head(const std::vector<HeadKind>& heads, int model);
std::optional<HeadKind> find_head(const std::vector<HeadKind>& heads, std::string_view name);

}  // namespace kambara::visca
