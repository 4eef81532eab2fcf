// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>

#include "app/kambara/calibration_ports.h"
#include "app/kambara/command_line.h"
#include "app/kambara/language.h"
#include "app/kambara/open_system.h"
#include "core/base/clock.h"
#include "ui/base/theme.h"
#include "ui/scene3d/gl_probe.h"
#include "ui/shell/main_window.h"

int main(int argc, char** argv) {
    using namespace kambara;
    ui::prepare_for_gl();
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Kambara Vision"));
    QApplication::setOrganizationName(QStringLiteral("Kambara"));
    QApplication::setApplicationVersion(QStringLiteral(KAMBARA_VERSION));
    const Language language(CommandLine::language(QApplication::arguments()));
    ui::WindowOptions options = CommandLine::read(QApplication::arguments());
    ui::apply_theme(application);
    options.with_gl = options.with_gl && ui::can_draw_with_gl();
    options.calibration = calibration_ports();
    SteadyClock clock;
    const QString pan_tilt = CommandLine::pan_tilt(QApplication::arguments());
    ui::MainWindow window(system_opener(clock, pan_tilt.toStdString()), options);
    window.show();
    return QApplication::exec();
}
