// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/foreign_yaml.h"

#include <cmath>

namespace kambara::foreign_yaml {

YAML::Node parsed(std::string_view text) {
    std::string body(text);
    if (body.starts_with("%YAML")) {  // "%YAML:1.0" is OpenCV's own spelling
        body.erase(0, std::min(body.size(), body.find('\n')));
    }
    YAML::Node node = YAML::Load(body);
    if (!node.IsMap()) {
        throw Fault{"it holds no keys"};
    }
    return node;
}

YAML::Node child(const YAML::Node& node, const std::string& key) {
    if (!node.IsMap() || !node[key]) {
        throw Fault{"\"" + key + "\" is missing"};
    }
    return node[key];
}

double number(const YAML::Node& node, const std::string& what) {
    double value = 0.0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value) ||
        std::abs(value) > 1e9) {
        throw Fault{"\"" + what + "\" is not a sensible number"};
    }
    return value;
}

std::vector<double> numbers(const YAML::Node& node, const std::string& what) {
    if (node.IsMap()) {
        return numbers(child(node, "data"), what + ".data");
    }
    if (!node.IsSequence() || node.size() > 64) {
        throw Fault{"\"" + what + "\" is not a list of numbers"};
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < node.size(); ++i) {
        if (node[i].IsSequence()) {
            const auto row = numbers(node[i], what);
            values.insert(values.end(), row.begin(), row.end());
        } else {
            values.push_back(number(node[i], what));
        }
    }
    return values;
}

std::vector<double> numbers(const YAML::Node& node, const std::string& what, std::size_t count) {
    auto values = numbers(node, what);
    if (values.size() != count) {
        throw Fault{"\"" + what + "\" does not hold " + std::to_string(count) + " numbers"};
    }
    return values;
}

int picture_side(double value, const std::string& what) {
    if (!(value >= 16.0 && value <= 20000.0) || value != std::floor(value)) {
        throw Fault{"\"" + what + "\" is not a picture's size"};
    }
    return static_cast<int>(value);
}

Lens lens_of(double fx, double fy, double cx, double cy, std::vector<double> distortion, int width,
             int height) {
    // More than eight terms mean thin prisms and tilted sensors; zeros there change nothing.
    while (distortion.size() > 8 && distortion.back() == 0.0) {
        distortion.pop_back();
    }
    if (distortion.size() > 8) {
        throw Fault{"the distortion has more than eight terms, which this program can't hold"};
    }
    if (distortion.size() < 4 && !distortion.empty()) {
        throw Fault{"the distortion has fewer than four terms"};
    }
    const Lens lens = BrownLens(fx, fy, cx, cy, distortion);
    if (const auto why = implausibility(lens, width, height); !why.empty()) {
        throw Fault{why};
    }
    return lens;
}

Eigen::Matrix3d rotation_of(const std::vector<double>& nine, const std::string& what) {
    Eigen::Matrix3d R;
    R << nine[0], nine[1], nine[2], nine[3], nine[4], nine[5], nine[6], nine[7], nine[8];
    if (!is_rotation(R, 1e-4)) {
        throw Fault{"\"" + what + "\" is not a rotation"};
    }
    return nearest_rotation(R);
}

}  // namespace kambara::foreign_yaml
