// SPDX-License-Identifier: GPL-3.0-or-later
// What is written of a session beside its folder: where the rig comes from.
#include <QCoreApplication>
#include <QDateTime>

#include "core/base/digits.h"
#include "ui/calibration/session_worker.h"

namespace kambara::ui {

std::string settings_text(const SessionSetup& setup) {
    std::string text = "target " + to_string(setup.target) + ", model " +
                       (setup.model == LensModel::brown ? "brown" : "tsai") + ", medium " +
                       (setup.medium == Medium::air ? "air" : "water");
    if (setup.baseline) {
        text += ", baseline " + digits(setup.baseline->baseline_mm) + "," +
                digits(setup.baseline->sigma_mm);
    }
    return text + ", guided session";
}

Result<Rig> rig_with_provenance(const SessionOutcome& outcome, const std::filesystem::path& folder,
                                const CalibrationPorts& ports) {
    Rig rig = outcome.report.rig;
    Provenance& from = rig.provenance;
    from.method = to_string(outcome.setup.target) + ", " +
                  (outcome.setup.model == LensModel::brown ? "brown" : "tsai") + ", " +
                  std::to_string(outcome.report.views_used) + " views";
    from.created = QDateTime::currentDateTimeUtc().toString(Qt::ISODate).toStdString();
    from.program = (QCoreApplication::applicationName() + QLatin1Char(' ') +
                    QCoreApplication::applicationVersion())
                       .trimmed()
                       .toStdString();
    from.settings = outcome.settings;
    from.pictures.clear();
    for (const int number : outcome.numbers) {
        for (std::size_t c = 0; c < most_cameras; ++c) {
            if (!outcome.setup.cameras[c]) {
                continue;
            }
            const auto mark = ports.picture_mark(shot_picture_file(folder, c, number));
            if (!mark) {
                return mark.error();
            }
            from.pictures.push_back(std::string(camera_names[c]) + "/" + *mark);
        }
    }
    return rig;
}

}  // namespace kambara::ui
