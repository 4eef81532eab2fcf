// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/command_line.h"

#include <QCommandLineParser>
#include <QTextStream>
#include <cstdlib>

namespace kambara {
namespace {

constexpr double lowest_rate_hz = 0.1;
constexpr double highest_rate_hz = 1000.0;

QString value_of(const QString& name, const QStringList& arguments) {
    for (int i = 1; i < arguments.size(); ++i) {
        if (arguments[i] == name && i + 1 < arguments.size()) {
            return arguments[i + 1];
        }
        if (arguments[i].startsWith(name + QLatin1Char('='))) {
            return arguments[i].mid(name.size() + 1);
        }
    }
    return {};
}

[[noreturn]] void refuse(const QString& text) {
    QTextStream(stderr) << text << '\n';
    std::exit(2);
}

}  // namespace

ui::WindowOptions CommandLine::read(const QStringList& arguments) {
    QCommandLineParser parser;
    parser.setApplicationDescription(
        tr("Stereo vision for underwater vehicles. Without options: the simulated rig."));
    parser.addHelpOption();
    parser.addVersionOption();
    const auto option = [&](const char* name, const QString& value, const QString& text) {
        const QCommandLineOption added(QLatin1String(name), text, value);
        parser.addOption(added);
        return added;
    };
    const auto left =
        option("left", tr("SOURCE"), tr("Left pictures: a video, a pattern, or sim:PROFILE."));
    const auto right = option("right", tr("SOURCE"), tr("Right pictures."));
    const auto rig = option("rig", tr("FILE"), tr("The rig file of these pictures."));
    const auto rate = option("rate", tr("HZ"), tr("Rate of single pictures (10 Hz unless given)."));
    option("pan-tilt", tr("HEAD"),
           tr("A real pan-tilt head: visca:/dev/ttyS0, visca-udp:HOST or visca-tcp:HOST."));
    option("language", tr("CODE"), tr("Language of the window, such as de or en."));
    const auto no_3d = option("no-3d", QString(), tr("Without the 3-D view."));
    parser.process(arguments);

    ui::WindowOptions options;
    ui::SourceRequest& first = options.first;
    first.left = parser.isSet(left) ? parser.value(left).toStdString() : "sim:default";
    first.right = parser.value(right).toStdString();
    first.rig = parser.value(rig).toStdString();
    options.simulation.left = "sim:default";
    options.with_gl = !parser.isSet(no_3d);
    if (!parser.positionalArguments().isEmpty()) {
        refuse(tr("%1 is not understood: sources are named with --left and --right. See --help.")
                   .arg(parser.positionalArguments().constFirst()));
    }
    if (!parser.isSet(left) && (parser.isSet(right) || parser.isSet(rig))) {
        refuse(tr("The left camera's pictures are missing: name them with --left."));
    }
    if (parser.isSet(rate)) {
        bool is_number = false;
        first.pictures_rate_hz = parser.value(rate).toDouble(&is_number);
        if (!is_number || !(first.pictures_rate_hz >= lowest_rate_hz &&
                            first.pictures_rate_hz <= highest_rate_hz)) {
            refuse(tr("--rate %1 is no rate: give a number of pictures a second, 0.1 to 1000.")
                       .arg(parser.value(rate)));
        }
    }
    return options;
}

QString CommandLine::language(const QStringList& arguments) {
    return value_of(QStringLiteral("--language"), arguments);
}

QString CommandLine::pan_tilt(const QStringList& arguments) {
    return value_of(QStringLiteral("--pan-tilt"), arguments);
}

}  // namespace kambara
