// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/head_kind.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/text_file.h"
#include "hardware/visca/built_in_heads.h"

namespace kambara::visca {
namespace {

constexpr const char* format_name = "kambara-visca-heads";
constexpr int format_version = 1;
constexpr const char* remedy = "Mend the file, or start from resources/heads/visca.yaml.";

struct Bad {
    std::string what;
};

YAML::Node child(const YAML::Node& node, const std::string& where, const char* key) {
    if (!node.IsMap() || !node[key]) {
        throw Bad{where + key + " is missing"};
    }
    return node[key];
}

double number(const YAML::Node& node, const std::string& key, double least, double most) {
    double value = 0.0;
    int whole = 0;
    if (!node.IsScalar()) {
        throw Bad{key + " is no number"};
    }
    // Hexadecimal numbers are read as whole ones only.
    if (YAML::convert<int>::decode(node, whole)) {
        value = whole;
    } else if (!YAML::convert<double>::decode(node, value)) {
        throw Bad{key + " is no number"};
    }
    if (!(value >= least && value <= most)) {
        throw Bad{key + " can't be " + node.Scalar()};
    }
    return value;
}

double number(const YAML::Node& node, const std::string& where, const char* key, double least,
              double most) {
    return number(child(node, where, key), where + key, least, most);
}

double number_or(const YAML::Node& node, const std::string& where, const char* key, double least,
                 double most, double otherwise) {
    return node[key] ? number(node[key], where + key, least, most) : otherwise;
}

int whole(double value) {
    return static_cast<int>(std::lround(value));
}

AxisModel read_axis(const YAML::Node& head, const std::string& where, const char* key) {
    const YAML::Node node = child(head, where, key);
    const std::string inner = where + key + ".";
    AxisModel axis;
    axis.least_deg = number(node, inner, "least_deg", -360.0, 0.0);
    axis.most_deg = number(node, inner, "most_deg", 0.0, 360.0);
    axis.steps_per_deg = number(node, inner, "steps_per_deg", 0.1, 1000.0);
    axis.sign = number_or(node, inner, "sign", -1.0, 1.0, 1.0) < 0.0 ? -1 : 1;
    axis.nibbles = whole(number_or(node, inner, "nibbles", 4.0, 5.0, 4.0));
    axis.fastest_code = whole(number(node, inner, "fastest_code", 0.0, 127.0));
    axis.fastest_deg_s = number(node, inner, "fastest_deg_s", 0.1, 1000.0);
    const double most_steps = std::max(-axis.least_deg, axis.most_deg) * axis.steps_per_deg;
    if (most_steps > (1 << (4 * axis.nibbles - 1)) - 1) {
        throw Bad{where + key + ": its steps do not fit into " + std::to_string(axis.nibbles) +
                  " bytes"};
    }
    return axis;
}

ZoomModel read_zoom(const YAML::Node& head, const std::string& where) {
    const YAML::Node node = child(head, where, "zoom");
    const std::string inner = where + "zoom.";
    ZoomModel zoom;
    zoom.tele = whole(number(node, inner, "tele", 1.0, 65535.0));
    zoom.wide_f_mm = number_or(node, inner, "wide_f_mm", 0.1, 10000.0, 0.0);
    zoom.tele_f_mm = number_or(node, inner, "tele_f_mm", 0.1, 10000.0, 0.0);
    zoom.sensor_width_mm = number_or(node, inner, "sensor_width_mm", 0.1, 100.0, 0.0);
    const YAML::Node curve = node["curve"];
    if (curve && !curve.IsSequence()) {
        throw Bad{inner + "curve is no list"};
    }
    for (std::size_t i = 0; curve && i < curve.size(); ++i) {
        const std::string key = inner + "curve[" + std::to_string(i) + "]";
        if (!curve[i].IsSequence() || curve[i].size() != 2) {
            throw Bad{key + " is no pair"};
        }
        zoom.curve.emplace_back(number(curve[i][0], key, 0.0, 65535.0),
                                number(curve[i][1], key, 0.1, 10000.0));
        if (i > 0 && zoom.curve[i].first <= zoom.curve[i - 1].first) {
            throw Bad{key + ": positions must rise"};
        }
    }
    return zoom;
}

HeadKind read_head(const YAML::Node& node, const std::string& where) {
    HeadKind head;
    const YAML::Node name = child(node, where, "name");
    if (!name.IsScalar() || name.Scalar().empty()) {
        throw Bad{where + "name is no text"};
    }
    head.name = name.Scalar();
    const YAML::Node models = child(node, where, "models");
    if (!models.IsSequence()) {
        throw Bad{where + "models is no list"};
    }
    for (const YAML::Node& model : models) {
        head.models.push_back(whole(number(model, where + "models", 0.0, 65535.0)));
    }
    head.pan = read_axis(node, where, "pan");
    head.tilt = read_axis(node, where, "tilt");
    if (head.tilt.nibbles != 4) {
        throw Bad{where + "tilt.nibbles can only be 4"};
    }
    head.zoom = read_zoom(node, where);
    const YAML::Node focus = child(node, where, "focus");
    head.focus_far = whole(number(focus, where + "focus.", "far", 0.0, 65535.0));
    head.focus_near = whole(number(focus, where + "focus.", "near", 0.0, 65535.0));
    head.presets = whole(number(node, where, "presets", 0.0, 255.0));
    head.cancel_wait_s = number(node, where, "cancel_wait_s", 0.0, 10.0);
    bool replaces = false;
    if (!YAML::convert<bool>::decode(child(node, where, "replaces_moves"), replaces)) {
        throw Bad{where + "replaces_moves is neither true nor false"};
    }
    head.replaces_moves = replaces;
    return head;
}

}  // namespace

int AxisModel::steps_from_deg(double angle_deg) const {
    // Of the whole steps within the ends.
    const int low = static_cast<int>(std::ceil(least_deg * steps_per_deg - 1e-6));
    const int high = static_cast<int>(std::floor(most_deg * steps_per_deg + 1e-6));
    return sign * std::clamp(whole(angle_deg * steps_per_deg), low, high);
}

int AxisModel::code_for(double speed_deg_s) const {
    if (fastest_code == 0) {
        return 0;
    }
    const double share = std::abs(speed_deg_s) / fastest_deg_s;
    return std::clamp(static_cast<int>(std::floor(share * fastest_code + 1e-9)), 1, fastest_code);
}

int AxisModel::nearest_code(double speed_deg_s) const {
    return code_for(std::abs(speed_deg_s) + 0.5 * fastest_deg_s / std::max(1, fastest_code));
}

double AxisModel::speed_deg_s(int code) const {
    return fastest_code == 0 ? fastest_deg_s : fastest_deg_s * code / fastest_code;
}

double ZoomModel::horizontal_view_rad(double position) const {
    if (!(wide_f_mm > 0.0 && tele_f_mm > 0.0 && sensor_width_mm > 0.0) && curve.empty()) {
        return 0.0;
    }
    double f_mm = wide_f_mm * std::pow(tele_f_mm / wide_f_mm, position / tele);
    if (!curve.empty()) {
        const auto above = std::find_if(curve.begin(), curve.end(),
                                        [&](const auto& one) { return one.first >= position; });
        if (above == curve.begin() || above == curve.end()) {
            f_mm = above == curve.end() ? curve.back().second : curve.front().second;
        } else {
            const auto& [z1, f1] = *above;
            const auto& [z0, f0] = *(above - 1);
            f_mm = f0 * std::pow(f1 / f0, (position - z0) / (z1 - z0));
        }
    }
    return 2.0 * std::atan2(sensor_width_mm, 2.0 * f_mm);
}

HeadLimits HeadKind::limits() const {
    return {rad_from_deg(std::min(-pan.least_deg, pan.most_deg)),
            rad_from_deg(std::min(-tilt.least_deg, tilt.most_deg)), rad_from_deg(pan.fastest_deg_s),
            rad_from_deg(tilt.fastest_deg_s)};
}

Result<std::vector<HeadKind>> heads_from_text(std::string_view text) {
    try {
        const YAML::Node root = YAML::Load(std::string(text));
        const YAML::Node format = child(root, "", "format");
        if (!format.IsScalar() || format.Scalar() != format_name) {
            throw Bad{std::string("format is not ") + format_name};
        }
        if (whole(number(root, "", "version", 0.0, 1e6)) != format_version) {
            throw Bad{"version is not " + std::to_string(format_version)};
        }
        const YAML::Node list = child(root, "", "heads");
        if (!list.IsSequence() || list.size() == 0) {
            throw Bad{"heads is no list"};
        }
        std::vector<HeadKind> heads;
        for (std::size_t i = 0; i < list.size(); ++i) {
            heads.push_back(read_head(list[i], "heads[" + std::to_string(i) + "]."));
        }
        return heads;
    } catch (const Bad& bad) {
        return Error{"The table of heads can't be used: " + bad.what + ".", remedy};
    } catch (const YAML::Exception& error) {
        return Error{std::string("The table of heads is no YAML: ") + error.what() + ".", remedy};
    }
}

Result<std::vector<HeadKind>> read_heads_file(const std::filesystem::path& path) {
    const auto text = read_text_file(path, std::size_t{1} << 20);
    if (!text) {
        return text.error();
    }
    auto heads = heads_from_text(*text);
    if (!heads) {
        return Error{path.string() + ": " + heads.error().cause, heads.error().remedy};
    }
    return heads;
}

const std::vector<HeadKind>& built_in_heads() {
    static const std::vector<HeadKind> heads = [] {
        auto read = heads_from_text(built_in_heads_text());
        if (!read) {
            throw std::logic_error(read.error().text());
        }
        return std::move(*read);
    }();
    return heads;
}

std::optional<HeadKind> find_head(const std::vector<HeadKind>& heads, int model) {
    const auto found = std::find_if(heads.begin(), heads.end(), [&](const HeadKind& head) {
        return std::find(head.models.begin(), head.models.end(), model) != head.models.end();
    });
    return found == heads.end() ? std::nullopt : std::optional(*found);
}

std::optional<HeadKind> find_head(const std::vector<HeadKind>& heads, std::string_view name) {
    const auto found = std::find_if(heads.begin(), heads.end(),
                                    [&](const HeadKind& head) { return head.name == name; });
    return found == heads.end() ? std::nullopt : std::optional(*found);
}

}  // namespace kambara::visca
