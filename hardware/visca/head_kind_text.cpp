// SPDX-License-Identifier: GPL-3.0-or-later
// The table of heads as text.
#include <yaml-cpp/yaml.h>

#include "core/base/text_file.h"
#include "hardware/visca/head_kind.h"

namespace kambara::visca {
namespace {

void write_axis(YAML::Emitter& out, const char* name, const AxisModel& axis) {
    out << YAML::Key << name << YAML::Value << YAML::Flow << YAML::BeginMap;
    out << YAML::Key << "least_deg" << YAML::Value << axis.least_deg;
    out << YAML::Key << "most_deg" << YAML::Value << axis.most_deg;
    out << YAML::Key << "steps_per_deg" << YAML::Value << axis.steps_per_deg;
    out << YAML::Key << "sign" << YAML::Value << axis.sign;
    out << YAML::Key << "nibbles" << YAML::Value << axis.nibbles;
    out << YAML::Key << "fastest_code" << YAML::Value << axis.fastest_code;
    out << YAML::Key << "fastest_deg_s" << YAML::Value << axis.fastest_deg_s;
    out << YAML::EndMap;
}

void write_zoom(YAML::Emitter& out, const ZoomModel& zoom) {
    out << YAML::Key << "zoom" << YAML::Value << YAML::BeginMap;
    out << YAML::Key << "tele" << YAML::Value << zoom.tele;
    if (zoom.wide_f_mm > 0.0 && zoom.tele_f_mm > 0.0) {
        out << YAML::Key << "wide_f_mm" << YAML::Value << zoom.wide_f_mm;
        out << YAML::Key << "tele_f_mm" << YAML::Value << zoom.tele_f_mm;
    }
    if (zoom.sensor_width_mm > 0.0) {
        out << YAML::Key << "sensor_width_mm" << YAML::Value << zoom.sensor_width_mm;
    }
    if (!zoom.curve.empty()) {
        out << YAML::Key << "curve" << YAML::Value << YAML::BeginSeq;
        for (const auto& [position, f_mm] : zoom.curve) {
            out << YAML::Flow << YAML::BeginSeq << position << f_mm << YAML::EndSeq;
        }
        out << YAML::EndSeq;
    }
    out << YAML::EndMap;
}

void write_head(YAML::Emitter& out, const HeadKind& head) {
    out << YAML::BeginMap;
    out << YAML::Key << "name" << YAML::Value << head.name;
    out << YAML::Key << "models" << YAML::Value << YAML::Flow << YAML::BeginSeq;
    for (const int model : head.models) {
        out << YAML::Hex << model << YAML::Dec;
    }
    out << YAML::EndSeq;
    write_axis(out, "pan", head.pan);
    write_axis(out, "tilt", head.tilt);
    write_zoom(out, head.zoom);
    out << YAML::Key << "focus" << YAML::Value << YAML::Flow << YAML::BeginMap << YAML::Key << "far"
        << YAML::Value << head.focus_far << YAML::Key << "near" << YAML::Value << head.focus_near
        << YAML::EndMap;
    out << YAML::Key << "presets" << YAML::Value << head.presets;
    out << YAML::Key << "replaces_moves" << YAML::Value << head.replaces_moves;
    out << YAML::Key << "cancel_wait_s" << YAML::Value << head.cancel_wait_s;
    out << YAML::EndMap;
}

}  // namespace

std::string heads_to_text(const std::vector<HeadKind>& heads) {
    YAML::Emitter out;
    out.SetDoublePrecision(12);
    out << YAML::BeginMap;
    out << YAML::Key << "format" << YAML::Value << "kambara-visca-heads";
    out << YAML::Key << "version" << YAML::Value << 1;
    out << YAML::Key << "heads" << YAML::Value << YAML::BeginSeq;
    for (const HeadKind& head : heads) {
        write_head(out, head);
    }
    out << YAML::EndSeq << YAML::EndMap;
    return std::string(out.c_str()) + "\n";
}

Result<Done> write_heads_file(const std::filesystem::path& path,
                              const std::vector<HeadKind>& heads) {
    const std::string text = heads_to_text(heads);
    if (const auto read = heads_from_text(text); !read) {
        return read.error();
    }
    return write_text_file_atomically(path, text);
}

}  // namespace kambara::visca
