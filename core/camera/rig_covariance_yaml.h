// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "core/camera/rig.h"

namespace kambara {

/// The rig file's sections calibration_covariance and pan_tilt_lens_covariance
/// (resources/README.md): the parameters' names, their deviations and the lower triangle of their
/// correlations.

/// Reads it into a rig whose cameras are read already. Gives what is wrong with the section, empty
/// when all is well; the rig's covariance is left as it was where something is.
std::string read_covariance(const YAML::Node& section, Rig& rig);

/// Likewise that of the pan-tilt camera's lens.
std::string read_lens_covariance(const YAML::Node& section, Rig& rig);

/// Writes keys and values; nothing where the rig has none.
void write_covariances(YAML::Emitter& out, const Rig& rig);

}  // namespace kambara
