// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/experiment_ports.h"

#include "app/cli/named_table.h"
#include "app/cli/range_test_page.h"

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

}  // namespace

ui::ExperimentPorts experiment_ports() {
    ui::ExperimentPorts ports;
    ports.read_places = places_in;
    ports.range_table = cli::range_test_table;
    ports.range_page = cli::range_test_page;
    return ports;
}

}  // namespace kambara
