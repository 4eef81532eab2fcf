// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/rig_file.h"

#include <yaml-cpp/yaml.h>

#include <cmath>
#include <utility>
#include <vector>

#include "core/base/angles.h"
#include "core/base/digits.h"
#include "core/base/text_file.h"
#include "core/camera/rig_covariance_yaml.h"

namespace kambara {
namespace {

// Inside this file a fault is thrown and turned into an Error at the door: the path of the key is
// then named once, where it is known.
struct Fault {
    std::string key;
    std::string why;
};

YAML::Node child(const YAML::Node& node, const std::string& where, const char* key) {
    if (!node.IsMap() || !node[key]) {
        throw Fault{where + key, "is missing"};
    }
    return node[key];
}

double number(const YAML::Node& node, const std::string& key) {
    double value = 0.0;
    if (!node.IsScalar() || !YAML::convert<double>::decode(node, value)) {
        throw Fault{key, "is not a number"};
    }
    if (!std::isfinite(value) || std::abs(value) > 1e9) {
        throw Fault{key, "is not a sensible number"};
    }
    return value;
}

double number(const YAML::Node& node, const std::string& where, const char* key) {
    return number(child(node, where, key), where + key);
}

std::vector<double> numbers(const YAML::Node& node, const std::string& key) {
    if (!node.IsSequence() || node.size() > 16) {
        throw Fault{key, "is not a short list of numbers"};
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < node.size(); ++i) {
        values.push_back(number(node[i], key + "[" + std::to_string(i) + "]"));
    }
    return values;
}

std::string text_or_empty(const YAML::Node& node, const char* key) {
    if (!node.IsMap()) {
        return {};
    }
    const YAML::Node found = node[key];
    return found && found.IsScalar() ? found.Scalar() : std::string();
}

Lens read_lens(const YAML::Node& node, const std::string& where) {
    const auto model = child(node, where, "model");
    const std::string name = model.IsScalar() ? model.Scalar() : "";
    if (name == "tsai") {
        TsaiLens lens;
        lens.f_mm = number(node, where, "f_mm");
        lens.kappa1_per_mm2 = number(node, where, "kappa1_per_mm2");
        lens.cx_px = number(node, where, "cx_px");
        lens.cy_px = number(node, where, "cy_px");
        lens.sx = number(node, where, "sx");
        const auto sensor = child(node, where, "sensor");
        const std::string inner = where + "sensor.";
        lens.sensor = {number(sensor, inner, "dx_mm"), number(sensor, inner, "dy_mm"),
                       number(sensor, inner, "ncx"), number(sensor, inner, "nfx")};
        const Sensor& s = lens.sensor;
        if (s.dx_mm <= 0.0 || s.dy_mm <= 0.0 || s.ncx <= 0.0 || s.nfx <= 0.0) {
            throw Fault{where + "sensor", "has a pitch or a count that is not positive"};
        }
        if (lens.f_mm <= 0.0) {
            throw Fault{where + "f_mm", "is not positive"};
        }
        if (lens.sx < 0.5 || lens.sx > 2.0) {
            throw Fault{where + "sx", "is " + std::to_string(lens.sx) + ", far from 1"};
        }
        return lens;
    }
    if (name == "brown") {
        const auto terms = numbers(child(node, where, "distortion"), where + "distortion");
        if (terms.size() != 5 && terms.size() != 8) {
            throw Fault{where + "distortion", "does not have 5 or 8 terms"};
        }
        const double fx = number(node, where, "fx_px");
        const double fy = number(node, where, "fy_px");
        if (fx <= 0.0 || fy <= 0.0) {
            throw Fault{where + "fx_px, fy_px", "are not positive"};
        }
        return BrownLens(fx, fy, number(node, where, "cx_px"), number(node, where, "cy_px"), terms);
    }
    throw Fault{where + "model", "is \"" + name + "\", neither tsai nor brown"};
}

RigidTransform read_pose(const YAML::Node& node, const std::string& where) {
    const auto rows = child(node, where, "R");
    if (!rows.IsSequence() || rows.size() != 3) {
        throw Fault{where + "R", "does not have three rows"};
    }
    RigidTransform pose;
    for (int i = 0; i < 3; ++i) {
        const auto row = numbers(rows[static_cast<std::size_t>(i)], where + "R");
        if (row.size() != 3) {
            throw Fault{where + "R", "has a row without three numbers"};
        }
        pose.R.row(i) = Eigen::Map<const Eigen::RowVector3d>(row.data());
    }
    if (!is_rotation(pose.R, 1e-6)) {
        throw Fault{where + "R", "is not a rotation"};
    }
    const auto t = numbers(child(node, where, "t_mm"), where + "t_mm");
    if (t.size() != 3) {
        throw Fault{where + "t_mm", "does not have three numbers"};
    }
    pose.t_mm = Eigen::Map<const Eigen::Vector3d>(t.data());
    return pose;
}

Camera read_camera(const YAML::Node& node, const std::string& where) {
    Camera camera;
    const auto size = numbers(child(node, where, "size_px"), where + "size_px");
    const auto sensible = [](double n) { return n >= 16 && n <= 20000 && n == std::floor(n); };
    if (size.size() != 2 || !sensible(size[0]) || !sensible(size[1])) {
        throw Fault{where + "size_px", "is not a width and a height between 16 and 20000"};
    }
    camera.width_px = static_cast<int>(size[0]);
    camera.height_px = static_cast<int>(size[1]);
    camera.lens = read_lens(child(node, where, "lens"), where + "lens.");
    if (const auto why = implausibility(camera.lens, camera.width_px, camera.height_px);
        !why.empty()) {
        throw Fault{where + "lens", "cannot be: " + why};
    }
    camera.T_camera_from_rig =
        read_pose(child(node, where, "T_camera_from_rig"), where + "T_camera_from_rig.");
    return camera;
}

std::optional<double> optional_number(const YAML::Node& node, const std::string& where,
                                      const char* key) {
    return node[key] ? std::optional(number(node, where, key)) : std::nullopt;
}

double angle(const YAML::Node& node, const std::string& where, const char* key) {
    const double value_deg = number(node, where, key);
    if (std::abs(value_deg) > 360.0) {
        throw Fault{where + key, "is not an angle in degrees"};
    }
    return rad_from_deg(value_deg);
}

HeadModel read_head(const YAML::Node& node) {
    const std::string where = "head.";
    HeadModel head;
    head.T_base_from_rig =
        read_pose(child(node, where, "T_base_from_rig"), where + "T_base_from_rig.");
    head.tilt_axis_ahead_mm = number(node, where, "tilt_axis_ahead_mm");
    head.tilt_axis_skew_rad = angle(node, where, "tilt_axis_skew_deg");
    head.T_camera_from_tilt =
        read_pose(child(node, where, "T_camera_from_tilt"), where + "T_camera_from_tilt.");
    head.pan_backlash_rad = angle(node, where, "pan_backlash_deg");
    head.tilt_backlash_rad = angle(node, where, "tilt_backlash_deg");
    return head;
}

std::optional<double> optional_angle(const YAML::Node& node, const std::string& where,
                                     const char* key) {
    return node[key] ? std::optional(angle(node, where, key)) : std::nullopt;
}

Mount read_mount(const YAML::Node& node) {
    const std::string where = "mount.";
    Mount mount;
    mount.pitch_rad = angle(node, where, "pitch_deg");
    mount.roll_rad = angle(node, where, "roll_deg");
    mount.heading_rad = angle(node, where, "heading_deg");
    mount.pitch_sigma_rad = optional_angle(node, where, "pitch_sigma_deg");
    mount.roll_sigma_rad = optional_angle(node, where, "roll_sigma_deg");
    const auto at = numbers(child(node, where, "rig_in_vehicle_mm"), where + "rig_in_vehicle_mm");
    if (at.size() != 3) {
        throw Fault{where + "rig_in_vehicle_mm", "does not have three numbers"};
    }
    mount.rig_in_vehicle_mm = Eigen::Map<const Eigen::Vector3d>(at.data());
    return mount;
}

Rig read_rig(const YAML::Node& root) {
    if (!root.IsMap()) {
        throw Fault{"kambara_rig", "is missing"};
    }
    const double version = number(root, "", "kambara_rig");
    if (version != rig_file_version) {
        throw Fault{"kambara_rig", "is a version that this program does not know"};
    }
    const auto units = child(root, "", "units");
    if (text_or_empty(units, "length") != "mm") {
        throw Fault{"units.length", "is not mm"};
    }
    Rig rig;
    const auto medium = child(root, "", "medium");
    const std::string medium_name = medium.IsScalar() ? medium.Scalar() : "";
    if (medium_name != "air" && medium_name != "water") {
        throw Fault{"medium", "is neither air nor water"};
    }
    rig.medium = medium_name == "air" ? Medium::air : Medium::water;
    const auto cameras = child(root, "", "cameras");
    rig.left = read_camera(child(cameras, "cameras.", "left"), "cameras.left.");
    if (cameras["right"]) {
        rig.right = read_camera(cameras["right"], "cameras.right.");
        if (!(baseline_mm(rig) > 1e-3)) {
            throw Fault{"cameras", "left and right are in the same place"};
        }
    }
    if (cameras["pan_tilt"]) {
        rig.pan_tilt = read_camera(cameras["pan_tilt"], "cameras.pan_tilt.");
    }
    if (root["head"]) {
        rig.head = read_head(root["head"]);
    }
    if (root["mount"]) {
        rig.mount = read_mount(root["mount"]);
    }
    if (const auto section = root["calibration_covariance"]) {
        if (auto fault = read_covariance(section, rig); !fault.empty()) {
            throw Fault{"calibration_covariance", std::move(fault)};
        }
    }
    if (const auto section = root["pan_tilt_lens_covariance"]) {
        if (auto fault = read_lens_covariance(section, rig); !fault.empty()) {
            throw Fault{"pan_tilt_lens_covariance", std::move(fault)};
        }
    }
    if (const auto from = root["provenance"]; from && from.IsMap()) {
        rig.provenance.method = text_or_empty(from, "method");
        rig.provenance.created = text_or_empty(from, "created");
        rig.provenance.program = text_or_empty(from, "program");
        rig.provenance.stereo_rms_px = optional_number(from, "provenance.", "stereo_rms_px");
        rig.provenance.baseline_sigma_mm =
            optional_number(from, "provenance.", "baseline_sigma_mm");
        rig.provenance.settings = text_or_empty(from, "settings");
        if (const auto pictures = from["pictures"]; pictures && pictures.IsSequence()) {
            for (const auto& picture : pictures) {
                rig.provenance.pictures.push_back(picture.IsScalar() ? picture.Scalar() : "");
            }
        }
    }
    return rig;
}

using kambara::digits;

std::vector<std::string> digits(const std::vector<double>& values) {
    std::vector<std::string> texts;
    texts.reserve(values.size());
    for (const double value : values) {
        texts.push_back(digits(value));
    }
    return texts;
}

void write_lens(YAML::Emitter& out, const TsaiLens& lens) {
    out << YAML::BeginMap << YAML::Key << "model" << YAML::Value << "tsai";
    out << YAML::Key << "f_mm" << YAML::Value << digits(lens.f_mm);
    out << YAML::Key << "kappa1_per_mm2" << YAML::Value << digits(lens.kappa1_per_mm2);
    out << YAML::Key << "cx_px" << YAML::Value << digits(lens.cx_px);
    out << YAML::Key << "cy_px" << YAML::Value << digits(lens.cy_px);
    out << YAML::Key << "sx" << YAML::Value << digits(lens.sx);
    out << YAML::Key << "sensor" << YAML::Value << YAML::Flow << YAML::BeginMap;
    out << YAML::Key << "dx_mm" << YAML::Value << digits(lens.sensor.dx_mm);
    out << YAML::Key << "dy_mm" << YAML::Value << digits(lens.sensor.dy_mm);
    out << YAML::Key << "ncx" << YAML::Value << digits(lens.sensor.ncx);
    out << YAML::Key << "nfx" << YAML::Value << digits(lens.sensor.nfx);
    out << YAML::EndMap << YAML::EndMap;
}

void write_lens(YAML::Emitter& out, const BrownLens& lens) {
    out << YAML::BeginMap << YAML::Key << "model" << YAML::Value << "brown";
    out << YAML::Key << "fx_px" << YAML::Value << digits(lens.fx_px());
    out << YAML::Key << "fy_px" << YAML::Value << digits(lens.fy_px());
    out << YAML::Key << "cx_px" << YAML::Value << digits(lens.cx_px());
    out << YAML::Key << "cy_px" << YAML::Value << digits(lens.cy_px());
    out << YAML::Key << "distortion" << YAML::Value << YAML::Flow << digits(lens.distortion());
    out << YAML::EndMap;
}

void write_pose(YAML::Emitter& out, const char* name, const RigidTransform& pose) {
    out << YAML::Key << name << YAML::Value << YAML::BeginMap;
    out << YAML::Key << "R" << YAML::Value << YAML::BeginSeq;
    for (int i = 0; i < 3; ++i) {
        const Eigen::RowVector3d row = pose.R.row(i);
        out << YAML::Flow << digits(std::vector<double>{row[0], row[1], row[2]});
    }
    const Eigen::Vector3d& t = pose.t_mm;
    out << YAML::EndSeq << YAML::Key << "t_mm" << YAML::Value << YAML::Flow
        << digits(std::vector<double>{t[0], t[1], t[2]}) << YAML::EndMap;
}

void write_camera(YAML::Emitter& out, const char* name, const Camera& camera) {
    out << YAML::Key << name << YAML::Value << YAML::BeginMap;
    out << YAML::Key << "size_px" << YAML::Value << YAML::Flow
        << std::vector<int>{camera.width_px, camera.height_px};
    out << YAML::Key << "lens" << YAML::Value;
    std::visit([&](const auto& lens) { write_lens(out, lens); }, camera.lens);
    write_pose(out, "T_camera_from_rig", camera.T_camera_from_rig);
    out << YAML::EndMap;
}

void write_head(YAML::Emitter& out, const HeadModel& head) {
    out << YAML::Key << "head" << YAML::Value << YAML::BeginMap;
    write_pose(out, "T_base_from_rig", head.T_base_from_rig);
    out << YAML::Key << "tilt_axis_ahead_mm" << YAML::Value << digits(head.tilt_axis_ahead_mm);
    const auto angle = [&out](const char* key, double value_rad) {
        out << YAML::Key << key << YAML::Value << digits(deg_from_rad(value_rad));
    };
    angle("tilt_axis_skew_deg", head.tilt_axis_skew_rad);
    write_pose(out, "T_camera_from_tilt", head.T_camera_from_tilt);
    angle("pan_backlash_deg", head.pan_backlash_rad);
    angle("tilt_backlash_deg", head.tilt_backlash_rad);
    out << YAML::EndMap;
}

void write_mount(YAML::Emitter& out, const Mount& mount) {
    out << YAML::Key << "mount" << YAML::Value << YAML::BeginMap;
    const auto angle = [&out](const char* key, double value_rad) {
        out << YAML::Key << key << YAML::Value << digits(deg_from_rad(value_rad));
    };
    angle("pitch_deg", mount.pitch_rad);
    angle("roll_deg", mount.roll_rad);
    angle("heading_deg", mount.heading_rad);
    if (mount.pitch_sigma_rad) {
        angle("pitch_sigma_deg", *mount.pitch_sigma_rad);
    }
    if (mount.roll_sigma_rad) {
        angle("roll_sigma_deg", *mount.roll_sigma_rad);
    }
    const Eigen::Vector3d& at = mount.rig_in_vehicle_mm;
    out << YAML::Key << "rig_in_vehicle_mm" << YAML::Value << YAML::Flow
        << digits(std::vector<double>{at.x(), at.y(), at.z()}) << YAML::EndMap;
}

}  // namespace

Result<Rig> rig_from_text(std::string_view text) {
    const char* remedy = "Mend the file, or make it anew with calibrate or convert.";
    try {
        return read_rig(YAML::Load(std::string(text)));
    } catch (const Fault& fault) {
        return Error{"The rig file's " + fault.key + " " + fault.why + ".", remedy};
    } catch (const YAML::Exception& fault) {
        return Error{std::string("The rig file is not valid YAML (") + fault.what() + ").", remedy};
    }
}

std::string rig_to_text(const Rig& rig) {
    YAML::Emitter out;
    out << YAML::BeginMap;
    out << YAML::Key << "kambara_rig" << YAML::Value << rig_file_version;
    out << YAML::Key << "units" << YAML::Value << YAML::Flow << YAML::BeginMap << YAML::Key
        << "length" << YAML::Value << "mm" << YAML::EndMap;
    out << YAML::Key << "medium" << YAML::Value << (rig.medium == Medium::air ? "air" : "water");
    out << YAML::Key << "provenance" << YAML::Value << YAML::BeginMap;
    const Provenance& from = rig.provenance;
    out << YAML::Key << "method" << YAML::Value << YAML::DoubleQuoted << from.method;
    out << YAML::Key << "created" << YAML::Value << YAML::DoubleQuoted << from.created;
    out << YAML::Key << "program" << YAML::Value << YAML::DoubleQuoted << from.program;
    if (from.stereo_rms_px) {
        out << YAML::Key << "stereo_rms_px" << YAML::Value << digits(*from.stereo_rms_px);
    }
    if (from.baseline_sigma_mm) {
        out << YAML::Key << "baseline_sigma_mm" << YAML::Value << digits(*from.baseline_sigma_mm);
    }
    if (!from.settings.empty()) {
        out << YAML::Key << "settings" << YAML::Value << YAML::DoubleQuoted << from.settings;
    }
    if (!from.pictures.empty()) {
        out << YAML::Key << "pictures" << YAML::Value << YAML::BeginSeq;
        for (const std::string& picture : from.pictures) {
            out << YAML::DoubleQuoted << picture;
        }
        out << YAML::EndSeq;
    }
    out << YAML::EndMap << YAML::Key << "cameras" << YAML::Value << YAML::BeginMap;
    write_camera(out, "left", rig.left);
    if (rig.right) {
        write_camera(out, "right", *rig.right);
    }
    if (rig.pan_tilt) {
        write_camera(out, "pan_tilt", *rig.pan_tilt);
    }
    out << YAML::EndMap;
    if (rig.head) {
        write_head(out, *rig.head);
    }
    if (rig.mount) {
        write_mount(out, *rig.mount);
    }
    write_covariances(out, rig);
    out << YAML::EndMap;
    return std::string(out.c_str()) + "\n";
}

Result<Rig> read_rig_file(const std::filesystem::path& path) {
    const auto text = read_text_file(path, std::size_t{1} << 20);
    if (!text) {
        return text.error();
    }
    auto rig = rig_from_text(*text);
    if (!rig) {
        return Error{path.string() + ": " + rig.error().cause, rig.error().remedy};
    }
    return rig;
}

Result<Done> write_rig_file(const std::filesystem::path& path, const Rig& rig) {
    return write_text_file_atomically(path, rig_to_text(rig));
}

}  // namespace kambara
