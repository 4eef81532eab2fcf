// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/experiment_ports.h"

#include "app/cli/calibrate_head_command.h"
#include "app/cli/named_table.h"
#include "app/cli/range_test_page.h"
#include "hardware/media/picture_file.h"

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

}  // namespace

ui::ExperimentPorts experiment_ports() {
    ui::ExperimentPorts ports;
    ports.read_places = places_in;
    ports.range_table = cli::range_test_table;
    ports.range_page = cli::range_test_page;
    ports.read_head_record = head_record;
    ports.write_picture = write_picture;
    return ports;
}

}  // namespace kambara
