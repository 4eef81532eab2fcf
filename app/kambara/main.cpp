// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <cstdio>
#include <cstdlib>
#include <utility>

#include "app/kambara/calibration_ports.h"
#include "app/kambara/command_line.h"
#include "app/kambara/experiment_ports.h"
#include "app/kambara/language.h"
#include "app/kambara/open_system.h"
#include "core/base/clock.h"
#include "hardware/gamepad/sdl_gamepad.h"
#include "ui/base/theme.h"
#include "ui/scene3d/gl_probe.h"
#include "ui/shell/main_window.h"

namespace {

// Qt would end the program without a word on what to do.
bool has_display() {
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        const char* value = std::getenv(name);
        if (value != nullptr && *value != '\0') {
            return true;
        }
    }
    return false;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace kambara;
    if (!has_display()) {
        const QCoreApplication without_window(argc, argv);
        (void)CommandLine::read(QCoreApplication::arguments());  // --help and --version end here
        std::fputs(
            "kambara: there is no display. Start it in a desktop session, or use kambara-cli; "
            "./run --terminal runs the main job in a terminal.\n",
            stderr);
        return 1;
    }
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
    options.experiments = experiment_ports();
    SteadyClock clock;
    // Without a way to gamepads the rest works all the same, and the status says that there is
    // none.
    if (auto gamepad = open_sdl_gamepad(clock)) {
        options.gamepad = std::move(*gamepad);
    }
    const QString pan_tilt = CommandLine::pan_tilt(QApplication::arguments());
    ui::MainWindow window(system_opener(clock, pan_tilt.toStdString()), options);
    window.show();
    return QApplication::exec();
}
