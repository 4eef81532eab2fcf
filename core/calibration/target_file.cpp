// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/target_file.h"

#include <yaml-cpp/yaml.h>

#include <array>
#include <cmath>
#include <vector>

#include "core/base/digits.h"
#include "core/base/text_file.h"
#include "core/calibration/yaml_fields.h"

namespace kambara {
namespace {

constexpr int file_version = 1;
constexpr const char* remedy = "Mend the file, or start from one of those in resources/targets.";

using calibration_yaml::Fault;
using calibration_yaml::number_of;

YAML::Node child(const YAML::Node& node, const std::string& key) {
    if (!node.IsMap() || !node[key]) {
        throw Fault{key + " is missing"};
    }
    return node[key];
}

double number(const YAML::Node& node, const std::string& key, double otherwise) {
    return node[key] ? number_of(node[key], key) : otherwise;
}

int whole_of(const YAML::Node& node, const std::string& key) {
    const double value = number_of(node, key);
    if (value != std::floor(value)) {
        throw Fault{key + " is not a whole number"};
    }
    return static_cast<int>(value);
}

template <std::size_t n>
std::array<double, n> numbers_of(const YAML::Node& node, const std::string& key) {
    if (!node.IsSequence() || node.size() != n) {
        throw Fault{key + " does not have " + std::to_string(n) + " numbers"};
    }
    std::array<double, n> values{};
    for (std::size_t i = 0; i < n; ++i) {
        values[i] = number_of(node[i], key);
    }
    return values;
}

Eigen::Vector3d point_of(const YAML::Node& node, const std::string& key) {
    const auto v = numbers_of<3>(node, key);
    return {v[0], v[1], v[2]};
}

std::array<int, 2> counts_of(const YAML::Node& node, const std::string& key) {
    if (!node.IsSequence() || node.size() != 2) {
        throw Fault{key + " does not have two numbers"};
    }
    return {whole_of(node[0], key), whole_of(node[1], key)};
}

bool truth_of(const YAML::Node& node, const std::string& key) {
    bool value = false;
    if (!node.IsScalar() || !YAML::convert<bool>::decode(node, value)) {
        throw Fault{key + " is neither true nor false"};
    }
    return value;
}

YAML::Node list(const YAML::Node& node, const std::string& key) {
    const YAML::Node found = node[key];
    if (found && (!found.IsSequence() || found.size() > 10000)) {
        throw Fault{key + " is not a list"};
    }
    return found;
}

TargetAccuracy read_accuracy(const YAML::Node& root) {
    TargetAccuracy accuracy;
    accuracy.sigma_mm = number(root, "sigma_mm", accuracy.sigma_mm);
    for (const YAML::Node& node : list(root, "measured")) {
        accuracy.measured.push_back({whole_of(child(node, "id"), "measured.id"),
                                     point_of(child(node, "at_mm"), "measured.at_mm"),
                                     number(node, "sigma_mm", accuracy.sigma_mm)});
    }
    return accuracy;
}

Target read_boxes(const YAML::Node& root) {
    BoxTarget target;
    target.rows = whole_of(child(root, "rows"), "rows");
    const auto box = numbers_of<2>(child(root, "box_mm"), "box_mm");
    const auto pitch = numbers_of<2>(child(root, "pitch_mm"), "pitch_mm");
    target.box_width_mm = box[0];
    target.box_height_mm = box[1];
    target.pitch_across_mm = pitch[0];
    target.pitch_down_mm = pitch[1];
    target.margin_mm = number(root, "margin_mm", target.margin_mm);
    if (root["dark_on_light"]) {
        target.dark_on_light = truth_of(root["dark_on_light"], "dark_on_light");
    }
    child(root, "planes");
    for (const YAML::Node& node : list(root, "planes")) {
        BoxPlane plane;
        plane.columns = whole_of(child(node, "columns"), "columns");
        plane.angle_deg = number(node, "angle_deg", plane.angle_deg);
        plane.gap_before_mm = number(node, "gap_before_mm", plane.gap_before_mm);
        plane.gap_after_mm = number(node, "gap_after_mm", plane.gap_after_mm);
        target.planes.push_back(plane);
    }
    for (const YAML::Node& node : list(root, "marks")) {
        const auto at = numbers_of<2>(child(node, "at_mm"), "marks.at_mm");
        target.marks.push_back({whole_of(child(node, "plane"), "marks.plane"), at[0], at[1],
                                number_of(child(node, "diameter_mm"), "marks.diameter_mm")});
    }
    return target;
}

Target read_points(const YAML::Node& root) {
    PointTarget target;
    child(root, "points_mm");
    for (const YAML::Node& node : list(root, "points_mm")) {
        target.points_mm.push_back(point_of(node, "points_mm"));
    }
    return target;
}

Target read_kind(const YAML::Node& root) {
    const YAML::Node kind = child(root, "kind");
    const std::string name = kind.IsScalar() ? kind.Scalar() : "";
    if (name == "boxes") {
        return read_boxes(root);
    }
    if (name == "points") {
        return read_points(root);
    }
    if (name == "chessboard") {
        const auto n = counts_of(child(root, "corners"), "corners");
        return ChessboardTarget{n[0], n[1], number_of(child(root, "square_mm"), "square_mm")};
    }
    if (name == "charuco") {
        const auto n = counts_of(child(root, "squares"), "squares");
        const YAML::Node dictionary = child(root, "dictionary");
        return CharucoTarget{n[0], n[1], number_of(child(root, "square_mm"), "square_mm"),
                             number_of(child(root, "marker_mm"), "marker_mm"),
                             dictionary.IsScalar() ? dictionary.Scalar() : ""};
    }
    throw Fault{"kind is \"" + name + "\", neither boxes, chessboard, charuco nor points"};
}

Target read_target(const YAML::Node& root) {
    if (!root.IsMap() || number_of(child(root, "kambara_target"), "kambara_target") != 1) {
        throw Fault{"kambara_target is a version that this program does not know"};
    }
    const YAML::Node units = child(root, "units");
    const YAML::Node length = units.IsMap() ? units["length"] : YAML::Node();
    if (!length || !length.IsScalar() || length.Scalar() != "mm") {
        throw Fault{"units.length is not mm"};
    }
    Target target = read_kind(root);
    // What the corners are told by, then the corners themselves: the count is only known then.
    if (const auto why = target_fault(target); !why.empty()) {
        throw Fault{"content can't be: " + why};
    }
    accuracy_of(target) = read_accuracy(root);
    if (const auto why = target_fault(target); !why.empty()) {
        throw Fault{"content can't be: " + why};
    }
    return target;
}

class Writer {
  public:
    explicit Writer(const char* kind) {
        out_ << YAML::BeginMap;
        key("kambara_target") << file_version;
        key("units") << YAML::Flow << YAML::BeginMap << YAML::Key << "length" << YAML::Value << "mm"
                     << YAML::EndMap;
        key("kind") << kind;
    }

    YAML::Emitter& key(const char* name) { return out_ << YAML::Key << name << YAML::Value; }
    void number(const char* name, double value) { key(name) << digits(value); }
    void numbers(const char* name, const std::vector<double>& values) {
        YAML::Emitter& out = key(name) << YAML::Flow << YAML::BeginSeq;
        for (const double value : values) {
            out << digits(value);
        }
        out << YAML::EndSeq;
    }
    YAML::Emitter& raw() { return out_; }

    std::string finished(const TargetAccuracy& accuracy) {
        number("sigma_mm", accuracy.sigma_mm);
        if (!accuracy.measured.empty()) {
            key("measured") << YAML::BeginSeq;
            for (const MeasuredCorner& corner : accuracy.measured) {
                out_ << YAML::Flow << YAML::BeginMap;
                key("id") << corner.id;
                numbers("at_mm", {corner.at_mm.x(), corner.at_mm.y(), corner.at_mm.z()});
                number("sigma_mm", corner.sigma_mm);
                out_ << YAML::EndMap;
            }
            out_ << YAML::EndSeq;
        }
        out_ << YAML::EndMap;
        return std::string(out_.c_str()) + "\n";
    }

  private:
    YAML::Emitter out_;
};

std::string text_of(const ChessboardTarget& target) {
    Writer writer("chessboard");
    writer.key("corners") << YAML::Flow
                          << std::vector<int>{target.corners_across, target.corners_down};
    writer.number("square_mm", target.square_mm);
    return writer.finished(target.accuracy);
}

std::string text_of(const CharucoTarget& target) {
    Writer writer("charuco");
    writer.key("squares") << YAML::Flow
                          << std::vector<int>{target.squares_across, target.squares_down};
    writer.number("square_mm", target.square_mm);
    writer.number("marker_mm", target.marker_mm);
    writer.key("dictionary") << target.dictionary;
    return writer.finished(target.accuracy);
}

std::string text_of(const BoxTarget& target) {
    Writer writer("boxes");
    writer.key("dark_on_light") << target.dark_on_light;
    writer.numbers("box_mm", {target.box_width_mm, target.box_height_mm});
    writer.numbers("pitch_mm", {target.pitch_across_mm, target.pitch_down_mm});
    writer.number("margin_mm", target.margin_mm);
    writer.key("rows") << target.rows;
    writer.key("planes") << YAML::BeginSeq;
    for (const BoxPlane& plane : target.planes) {
        writer.raw() << YAML::Flow << YAML::BeginMap;
        writer.key("columns") << plane.columns;
        writer.number("angle_deg", plane.angle_deg);
        writer.number("gap_before_mm", plane.gap_before_mm);
        writer.number("gap_after_mm", plane.gap_after_mm);
        writer.raw() << YAML::EndMap;
    }
    writer.raw() << YAML::EndSeq;
    if (!target.marks.empty()) {
        writer.key("marks") << YAML::BeginSeq;
        for (const RoundMark& mark : target.marks) {
            writer.raw() << YAML::Flow << YAML::BeginMap;
            writer.key("plane") << mark.plane;
            writer.numbers("at_mm", {mark.across_mm, mark.down_mm});
            writer.number("diameter_mm", mark.diameter_mm);
            writer.raw() << YAML::EndMap;
        }
        writer.raw() << YAML::EndSeq;
    }
    return writer.finished(target.accuracy);
}

std::string text_of(const PointTarget& target) {
    Writer writer("points");
    writer.key("points_mm") << YAML::BeginSeq;
    for (const Eigen::Vector3d& p : target.points_mm) {
        writer.raw() << YAML::Flow << YAML::BeginSeq << digits(p.x()) << digits(p.y())
                     << digits(p.z()) << YAML::EndSeq;
    }
    writer.raw() << YAML::EndSeq;
    return writer.finished(target.accuracy);
}

}  // namespace

Result<Target> target_from_text(std::string_view text) {
    try {
        return read_target(YAML::Load(std::string(text)));
    } catch (const Fault& fault) {
        return Error{"The target file's " + fault.what + ".", remedy};
    } catch (const YAML::Exception& fault) {
        return Error{std::string("The target file is not valid YAML (") + fault.what() + ").",
                     remedy};
    }
}

std::string target_to_text(const Target& target) {
    return std::visit([](const auto& kind) { return text_of(kind); }, target);
}

Result<Target> read_target_file(const std::filesystem::path& path) {
    const auto text = read_text_file(path, std::size_t{4} << 20);
    if (!text) {
        return text.error();
    }
    auto target = target_from_text(*text);
    if (!target) {
        return Error{path.string() + ": " + target.error().cause, target.error().remedy};
    }
    return target;
}

Result<Done> write_target_file(const std::filesystem::path& path, const Target& target) {
    return write_text_file_atomically(path, target_to_text(target));
}

}  // namespace kambara
