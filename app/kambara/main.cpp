// SPDX-License-Identifier: GPL-3.0-or-later
#include <QApplication>
#include <QCommandLineParser>
#include <QLibraryInfo>
#include <QLocale>
#include <QTextStream>
#include <QTranslator>

#include "app/kambara/open_system.h"
#include "ui/base/theme.h"
#include "ui/scene3d/gl_probe.h"
#include "ui/shell/main_window.h"

namespace {

using namespace kambara;

struct Arguments {
    ui::WindowOptions window;
    QString language;
};

// Reads what was given; says what is wrong with it and ends with 2.
Arguments read(const QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QCoreApplication::translate(
        "main", "Stereo vision for underwater vehicles. Without options: the simulated rig."));
    parser.addHelpOption();
    parser.addVersionOption();
    const auto option = [&](const char* name, const char* value, const QString& text) {
        QCommandLineOption added(QLatin1String(name), text, QLatin1String(value));
        parser.addOption(added);
        return added;
    };
    const auto say = [](const char* text) { return QCoreApplication::translate("main", text); };
    const auto left =
        option("left", "SOURCE", say("Left pictures: a video, a pattern, or sim:PROFILE."));
    const auto right = option("right", "SOURCE", say("Right pictures."));
    const auto rig = option("rig", "FILE", say("The rig file of these pictures."));
    const auto rate = option("rate", "HZ", say("Rate of single pictures (10 Hz unless given)."));
    const auto language =
        option("language", "CODE", say("Language of the window, such as de or en."));
    const auto no_3d = option("no-3d", "", say("Without the 3-D view."));
    parser.process(application);
    Arguments arguments;
    ui::SourceRequest& first = arguments.window.first;
    first.left = parser.isSet(left) ? parser.value(left).toStdString() : "sim:default";
    first.right = parser.value(right).toStdString();
    first.rig = parser.value(rig).toStdString();
    arguments.window.simulation.left = "sim:default";
    arguments.window.with_gl = !parser.isSet(no_3d);
    arguments.language = parser.value(language);
    bool is_number = true;
    if (parser.isSet(rate)) {
        first.pictures_rate_hz = parser.value(rate).toDouble(&is_number);
    }
    if (!is_number || !(first.pictures_rate_hz >= 0.1 && first.pictures_rate_hz <= 1000.0) ||
        !parser.positionalArguments().isEmpty()) {
        QTextStream(stderr) << say("Wrong usage. See kambara --help.") << '\n';
        std::exit(2);
    }
    return arguments;
}

}  // namespace

int main(int argc, char** argv) {
    ui::prepare_for_gl();
    QApplication application(argc, argv);
    QApplication::setApplicationName(QStringLiteral("Kambara Vision"));
    QApplication::setOrganizationName(QStringLiteral("Kambara"));
    QApplication::setApplicationVersion(QStringLiteral(KAMBARA_VERSION));
    Arguments arguments = read(application);
    if (!arguments.language.isEmpty()) {
        QLocale::setDefault(QLocale(arguments.language));
    }
    QTranslator ours;
    QTranslator qts;
    if (ours.load(QLocale(), QStringLiteral("kambara"), QStringLiteral("_"),
                  QStringLiteral(":/translations"))) {
        QApplication::installTranslator(&ours);
    }
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    const QString qt_translations = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
#else
    const QString qt_translations = QLibraryInfo::location(QLibraryInfo::TranslationsPath);
#endif
    if (qts.load(QLocale(), QStringLiteral("qtbase"), QStringLiteral("_"), qt_translations)) {
        QApplication::installTranslator(&qts);
    }
    ui::apply_theme(application);
    arguments.window.with_gl = arguments.window.with_gl && ui::can_draw_with_gl();
    SteadyClock clock;
    ui::MainWindow window(system_opener(clock), arguments.window);
    window.show();
    return QApplication::exec();
}
