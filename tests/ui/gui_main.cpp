// SPDX-License-Identifier: GPL-3.0-or-later
// The tests' own main: an application with the program's look and settings of its own.
#include <gtest/gtest.h>
#include <unistd.h>

#include <QApplication>
#include <QDir>
#include <QLocale>
#include <QSettings>

#include "ui/base/theme.h"
#include "ui/scene3d/gl_probe.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    if (testing::GTEST_FLAG(list_tests)) {
        return RUN_ALL_TESTS();  // needs no display
    }
    kambara::ui::prepare_for_gl();
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("Kambara"));
    QApplication::setApplicationName(QStringLiteral("Kambara Vision test"));
    const QString settings =
        QDir::temp().filePath(QStringLiteral("kambara_settings_%1").arg(getpid()));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings);
    kambara::ui::apply_theme(application);
    const int result = RUN_ALL_TESTS();
    QDir(settings).removeRecursively();
    return result;
}
