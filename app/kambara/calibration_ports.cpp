// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/calibration_ports.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/cli/calibration_json.h"
#include "app/cli/calibration_page.h"
#include "app/cli/calibration_pictures.h"
#include "hardware/media/picture_file.h"

namespace kambara {
namespace {

Result<std::string> mark_of(const std::filesystem::path& file) {
    const auto picture = read_picture(file);
    if (!picture) {
        return picture.error();
    }
    return cli::picture_mark(file, *picture);
}

std::string page_of(const ui::SessionOutcome& outcome) {
    cli::CalibrationFiles files;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (outcome.setup.cameras[c]) {
            for (const int number : outcome.numbers) {
                files.of_camera[c].push_back(shot_picture_file({}, c, number));
            }
        }
    }
    const cli::SessionPart session{outcome.shots, outcome.numbers, outcome.coverage, outcome.setup};
    return cli::calibration_page(cli::calibration_json(outcome.report, files), outcome.report,
                                 outcome.settings, &session);
}

}  // namespace

ui::CalibrationPorts calibration_ports() {
    ui::CalibrationPorts ports;
    ports.write_picture = write_picture;
    ports.picture_mark = mark_of;
    ports.report_page = page_of;
    return ports;
}

}  // namespace kambara
