// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/experiment_ports.h"

#include <algorithm>
#include <utility>

#include "app/cli/calibrate_head_command.h"
#include "app/cli/named_table.h"
#include "app/cli/range_test_page.h"
#include "hardware/media/picture_file.h"
#include "hardware/visca/measured_zoom.h"

namespace kambara {
namespace {

Result<std::vector<Eigen::Vector3d>> places_in(const std::filesystem::path& file) {
    const auto table = cli::read_named_table(file, {"x_mm", "y_mm", "z_mm"});
    if (!table) {
        return table.error();
    }
    std::vector<Eigen::Vector3d> places;
    for (const cli::NamedRow& row : table->rows) {
        const auto place = row.triple("x_mm", "y_mm", "z_mm");
        if (!place) {
            return Error{
                "Line " + std::to_string(row.line) + " of " + file.string() + " holds no place.",
                "Give every place three numbers: x_mm, y_mm, z_mm."};
        }
        places.push_back(*place);
    }
    return places;
}

Result<ui::HeadRecordRead> head_record(const std::filesystem::path& file, const Rig& rig,
                                       const Target& target) {
    const auto record = cli::read_head_record(file, rig, target, [](double) {});
    if (!record) {
        return record.error();
    }
    ui::HeadRecordRead read{record->views, {}};
    for (const cli::RejectedHeadView& one : record->rejected) {
        read.rejected.push_back(one.reason);
    }
    return read;
}

// A table that is there keeps its other kinds, and the curves that were measured of them.
Result<Done> write_heads(const std::filesystem::path& file, const ui::HeadKindLens& of,
                         const std::vector<std::pair<double, double>>& curve) {
    std::vector<visca::HeadKind> heads = visca::built_in_heads();
    if (std::filesystem::exists(file)) {
        auto there = visca::read_heads_file(file);
        if (!there) {
            return Error{there.error().cause, "Save under another name."};
        }
        heads = std::move(*there);
    }
    auto kind = std::find_if(heads.begin(), heads.end(),
                             [&](const visca::HeadKind& one) { return one.name == of.name; });
    if (kind == heads.end()) {
        const auto built_in = visca::find_head(visca::built_in_heads(), of.name);
        if (!built_in) {
            return Error{"There is no head \"" + of.name + "\" in the table.",
                         "Choose another kind of head."};
        }
        kind = heads.insert(heads.end(), *built_in);
    }
    const auto measured = visca::with_measured_zoom(
        *kind, curve, visca::WidestLens{of.widest_f_mm, of.sensor_width_mm});
    if (!measured) {
        return measured.error();
    }
    *kind = *measured;
    return visca::write_heads_file(file, heads);
}

}  // namespace

ui::ExperimentPorts experiment_ports() {
    ui::ExperimentPorts ports;
    ports.read_places = places_in;
    ports.range_table = cli::range_test_table;
    ports.range_page = cli::range_test_page;
    ports.read_head_record = head_record;
    ports.write_picture = write_picture;
    for (const visca::HeadKind& kind : visca::built_in_heads()) {
        ports.head_kinds.push_back({kind.name, kind.zoom.wide_f_mm, kind.zoom.sensor_width_mm});
    }
    ports.write_heads = write_heads;
    return ports;
}

}  // namespace kambara
