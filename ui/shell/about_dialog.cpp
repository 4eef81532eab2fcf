// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/about_dialog.h"

#include <qcustomplot.h>

#include <QCoreApplication>
#include <QMessageBox>
#include <QStringList>

namespace kambara::ui {
namespace {

// What the program is linked with; the versions are those it was built with (CMakeLists.txt).
QString libraries() {
    QStringList names{QStringLiteral("Qt %1 (LGPL-3)").arg(QLatin1String(qVersion()))};
    if (sizeof(KAMBARA_VTK_VERSION) > 1) {
        names << QStringLiteral("VTK " KAMBARA_VTK_VERSION " (BSD-3)");
    }
    names << QStringLiteral("QCustomPlot " QCUSTOMPLOT_VERSION_STR " (GPL-3)")
          << QStringLiteral("OpenCV " KAMBARA_OPENCV_VERSION " (Apache-2)")
          << QStringLiteral("Eigen " KAMBARA_EIGEN_VERSION " (MPL-2)")
          << QStringLiteral("Ceres Solver " KAMBARA_CERES_VERSION " (BSD-3)")
          << QStringLiteral("Highway " KAMBARA_HIGHWAY_VERSION " (Apache-2)")
          << QStringLiteral("FFTW " KAMBARA_FFTW_VERSION " (GPL-2)")
          << QStringLiteral("yaml-cpp " KAMBARA_YAML_CPP_VERSION " (MIT)")
          << QStringLiteral("nlohmann-json " KAMBARA_JSON_VERSION " (MIT)")
          << QStringLiteral("SDL " KAMBARA_SDL_VERSION " (zlib)");
    return names.join(QStringLiteral(", "));
}

}  // namespace

QString about_text() {
    const auto say = [](const char* text) {
        return QCoreApplication::translate("kambara::ui::About", text);
    };
    return QStringLiteral("<h3>Kambara Vision %1</h3><p>%2</p><p>%3</p><p>%4</p>")
        .arg(QCoreApplication::applicationVersion(),
             say(QT_TRANSLATE_NOOP("kambara::ui::About",
                                   "Stereo vision for underwater vehicles: calibrate, track, "
                                   "position, point.")),
             say(QT_TRANSLATE_NOOP("kambara::ui::About",
                                   "Free software under the GNU General Public License, version 3 "
                                   "or later. It comes without any warranty.")),
             say(QT_TRANSLATE_NOOP("kambara::ui::About", "It runs on %1.")).arg(libraries()));
}

void show_about(QWidget* parent) {
    QMessageBox box(parent);
    box.setObjectName(QStringLiteral("aboutDialog"));
    box.setWindowTitle(QCoreApplication::translate("kambara::ui::About", "About Kambara"));
    box.setTextFormat(Qt::RichText);
    box.setText(about_text());
    box.exec();
}

}  // namespace kambara::ui
