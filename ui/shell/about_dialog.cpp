// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/about_dialog.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace kambara::ui {

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
             say(QT_TRANSLATE_NOOP(
                     "kambara::ui::About",
                     "It runs on Qt %1 (LGPL-3), VTK (BSD-3), QCustomPlot (GPL-3), OpenCV "
                     "(Apache-2), Eigen (MPL-2), Ceres Solver (BSD-3), yaml-cpp (MIT) and "
                     "nlohmann-json (MIT)."))
                 .arg(QLatin1String(qVersion())));
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
