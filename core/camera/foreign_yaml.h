// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/camera/rig.h"

namespace kambara::foreign_yaml {

/// Shared by the readers of other programs' YAML; include from .cpp files only. A fault is thrown
/// with the key at fault and becomes an Error in `reading`.
struct Fault {
    std::string what;
};

/// The text as a node; OpenCV's first line and its tags are put up with.
YAML::Node parsed(std::string_view text);
YAML::Node child(const YAML::Node& node, const std::string& key);
double number(const YAML::Node& node, const std::string& what);
/// All numbers of a sequence, rows of rows flattened, or of a map's `data`.
std::vector<double> numbers(const YAML::Node& node, const std::string& what);
std::vector<double> numbers(const YAML::Node& node, const std::string& what, std::size_t count);
/// A whole, sensible picture size.
int picture_side(double value, const std::string& what);
/// Four to eight distortion terms in OpenCV's order, as a lens; faults where it can't be one.
Lens lens_of(double fx, double fy, double cx, double cy, std::vector<double> distortion, int width,
             int height);
/// A rotation, straightened where printing has cost it digits.
Eigen::Matrix3d rotation_of(const std::vector<double>& nine, const std::string& what);

/// Runs `read` and turns what it throws into an Error about `kind`.
template <class Read>
Result<Rig> reading(const std::string& kind, Read read) {
    const char* remedy = "Check that these are the right files, in the right order.";
    try {
        return read();
    } catch (const Fault& fault) {
        return Error{"The " + kind + " can't be read: " + fault.what + ".", remedy};
    } catch (const YAML::Exception& fault) {
        return Error{"The " + kind + " can't be read: " + fault.what() + ".", remedy};
    }
}

}  // namespace kambara::foreign_yaml
