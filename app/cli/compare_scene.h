// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "app/sources/sources.h"
#include "core/base/result.h"
#include "core/base/worker_pool.h"
#include "core/camera/rig.h"
#include "core/image/frame.h"
#include "core/image/rectangle.h"
#include "core/matching/temporal_filter.h"

namespace kambara::cli {

/// Where a target is in a pair of pictures, or is said to be.
struct Sighting {
    Eigen::Vector2d left_px = Eigen::Vector2d::Zero();
    std::optional<Eigen::Vector2d> right_px;  ///< empty with one camera
    std::optional<double> range_mm;           ///< from the left camera; likewise
};

/// What all methods are tried on: pictures in memory, a template in the first of them.
struct CompareScene {
    std::string name;
    std::string what;  ///< a profile, or the pictures
    Rig rig;
    std::vector<StereoFrame> pairs;  ///< grey; only left with one camera
    Rectangle templ;
    bool simulated = false;
    bool disturbed = false;  ///< by particles, steps of light and a background that is swapped
    std::vector<std::optional<Sighting>> truth;  ///< a pair each; empty: not known
    std::vector<double>
        attenuation_lengths;  ///< likewise: one way, target to left camera, in air 0

    bool has_truth() const;
};

/// A simulated scene that has a name.
struct NamedScene {
    const char* name;
    const char* profile;
};
/// From clear air to water at the end of sight, the last two with all that disturbs.
const std::vector<NamedScene>& named_scenes();

/// Reads a list such as `air,harbour`: names of scenes, `water` for all that are in water, `all`.
Result<std::vector<NamedScene>> parse_scenes(const std::string& list);

Result<CompareScene> simulated_scene(const std::string& name, const std::string& profile,
                                     double seconds, int template_px, WorkerPool& pool);

struct RecordedOptions {
    SourceOptions source;           ///< left, right, rig, start, rate
    std::string truth;              ///< a table as `simulate` writes it; empty: none
    std::optional<double> seconds;  ///< at most so many; else up to most_recorded_frames
};
inline constexpr std::size_t most_recorded_frames = 600;

/// A recording of one camera or two, a scene for each template: X,Y,W,H in its first frame. They
/// share the pictures. A truth must be that of the template's centre.
Result<std::vector<CompareScene>> recorded_scenes(const RecordedOptions& options,
                                                  const std::vector<std::string>& templates);

/// Filters the pictures over time, left and right each, as `track --temporal` does; the name says
/// it.
void low_pass(CompareScene& scene, const TemporalOptions& options);

}  // namespace kambara::cli
