// SPDX-License-Identifier: GPL-3.0-or-later
#include <yaml-cpp/yaml.h>

#include <cmath>

#include "core/base/digits.h"
#include "core/calibration/session/session_file.h"
#include "core/calibration/yaml_fields.h"

namespace kambara {
namespace {

using calibration_yaml::Fault;
using calibration_yaml::number_of;

DetectedCorner corner_of(const YAML::Node& node, const std::string& what, int corners) {
    if (!node.IsSequence() || node.size() != 5) {
        throw Fault{what + " has a corner without five numbers"};
    }
    DetectedCorner corner;
    const double id = number_of(node[0], what + "'s number");
    if (id != std::floor(id) || id < 0.0 || id >= corners) {
        throw Fault{what + " has a corner that the target lacks"};
    }
    corner.id = static_cast<int>(id);
    corner.px = {number_of(node[1], what + "'s x"), number_of(node[2], what + "'s y")};
    corner.sigma_px = number_of(node[3], what + "'s sigma");
    corner.blur_px = number_of(node[4], what + "'s blur");
    if (!(corner.sigma_px > 0.0) || corner.blur_px < 0.0) {
        throw Fault{what + " has a corner with an impossible deviation"};
    }
    return corner;
}

CameraSight sight_of(const YAML::Node& node, const std::string& what, int corners) {
    const YAML::Node list = node["corners"];
    if (!node.IsMap() || !list || !list.IsSequence() || list.size() > 100000) {
        throw Fault{what + ".corners is not a list"};
    }
    CameraSight sight;
    for (const YAML::Node& item : list) {
        sight.corners.push_back(corner_of(item, what, corners));
        if (sight.corners.size() > 1 &&
            sight.corners[sight.corners.size() - 2].id >= sight.corners.back().id) {
            throw Fault{what + ".corners are not in ascending order"};
        }
    }
    return sight;
}

}  // namespace

std::string shot_to_text(const Shot& shot) {
    YAML::Emitter out;
    out << YAML::BeginMap << YAML::Key << "kambara_calibration_shot" << YAML::Value << 1;
    out << YAML::Key << "shot" << YAML::Value << shot.number;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (shot.seen.sights[c].corners.empty()) {
            continue;
        }
        out << YAML::Key << camera_names[c] << YAML::Value << YAML::BeginMap;
        out << YAML::Key << "corners" << YAML::Value << YAML::BeginSeq;
        for (const DetectedCorner& corner : shot.seen.sights[c].corners) {
            out << YAML::Flow << YAML::BeginSeq << corner.id << digits(corner.px.x())
                << digits(corner.px.y()) << digits(corner.sigma_px) << digits(corner.blur_px)
                << YAML::EndSeq;
        }
        out << YAML::EndSeq << YAML::EndMap;
    }
    out << YAML::EndMap;
    return std::string(out.c_str()) + "\n";
}

Result<Shot> shot_from_text(std::string_view text, int corners) {
    constexpr const char* remedy = "Move the shot out of the session's folder and resume again.";
    try {
        const YAML::Node root = YAML::Load(std::string(text));
        if (!root.IsMap() || !root["kambara_calibration_shot"] ||
            number_of(root["kambara_calibration_shot"], "kambara_calibration_shot") != 1) {
            throw Fault{"kambara_calibration_shot is a version that this program does not know"};
        }
        Shot shot;
        const double number = root["shot"] ? number_of(root["shot"], "shot") : 0.0;
        if (number != std::floor(number) || number < 1.0) {
            throw Fault{"shot is not a number from 1"};
        }
        shot.number = static_cast<int>(number);
        for (std::size_t c = 0; c < most_cameras; ++c) {
            if (const YAML::Node node = root[camera_names[c]]) {
                shot.seen.sights[c] = sight_of(node, camera_names[c], corners);
            }
        }
        return shot;
    } catch (const Fault& fault) {
        return Error{"The shot's " + fault.what + ".", remedy};
    } catch (const YAML::Exception& fault) {
        return Error{std::string("The shot is not valid YAML (") + fault.what() + ").", remedy};
    }
}

}  // namespace kambara
