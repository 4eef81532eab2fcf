// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <string>

namespace kambara::calibration_yaml {

/// Shared by the readers of calibration's own files; include from .cpp files only. Thrown inside
/// such a file and turned into an Error at its door, where the file is known.
struct Fault {
    std::string what;
};

/// A number of a sensible size; `what` names it in the fault.
inline double number_of(const YAML::Node& node, const std::string& what) {
    double value = 0.0;
    if (!node || !node.IsScalar() || !YAML::convert<double>::decode(node, value) ||
        !(std::abs(value) <= 1e6)) {
        throw Fault{what + " is not a sensible number"};
    }
    return value;
}

}  // namespace kambara::calibration_yaml
