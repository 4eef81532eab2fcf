// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/calibration/target.h"
#include "core/camera/rig.h"
#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/pointing/head_calibration.h"
#include "core/stereo/range_experiment.h"

namespace kambara::ui {

/// A record of head views, read: those of use, and why others are not.
struct HeadRecordRead {
    std::vector<HeadView> views;
    std::vector<std::string> rejected;  ///< sentences
};

/// A kind of head, and its lens at the widest; 0 where that is not known.
struct HeadKindLens {
    std::string name;
    double widest_f_mm = 0.0;
    double sensor_width_mm = 0.0;
};

/// What the experiments' forms need of the program around them: files and pages that the command
/// line has as well. Called on the forms' threads.
struct ExperimentPorts {
    /// Known places, mm, from a table with the columns x_mm, y_mm, z_mm.
    std::function<Result<std::vector<Eigen::Vector3d>>(const std::filesystem::path&)> read_places;
    std::function<std::string(const RangeExperiment&)> range_table;                     ///< CSV
    std::function<std::string(const RangeExperiment&, double baseline_mm)> range_page;  ///< HTML
    /// A table of head views with its pictures (resources/README.md: head views).
    std::function<Result<HeadRecordRead>(const std::filesystem::path&, const Rig&, const Target&)>
        read_head_record;
    std::function<Result<Done>(const std::filesystem::path&, const Image&)> write_picture;
    /// The kinds of heads that have a table, and that table with the zoom curve of one of them:
    /// zoom shares, and how much the lens enlarges over its widest.
    std::vector<HeadKindLens> head_kinds;
    std::function<Result<Done>(const std::filesystem::path&, const HeadKindLens& kind,
                               const std::vector<std::pair<double, double>>& curve)>
        write_heads;
};

/// The range experiment's places where the target of the open source is simulated, and the truth
/// of them; empty where it is not. The members may be called from any thread.
struct SimulatedStations {
    int count = 0;
    /// A rectangle about the target in the left picture of a frame.
    std::function<Rectangle(std::int64_t frame)> target;
    /// The station, from 0, at which the target is still in a frame; -1 while it moves.
    std::function<int(std::int64_t frame)> station_in;
    /// Where that point of the target, which lay under `left_px` in the frame `seen_in`, really is
    /// in a frame, in the left camera's frame; empty where the pixel is beside the target.
    std::function<std::optional<Eigen::Vector3d>(const Eigen::Vector2d& left_px,
                                                 std::int64_t seen_in, std::int64_t frame)>
        known_in_left_mm;

    explicit operator bool() const { return count > 0; }
};

}  // namespace kambara::ui
