// SPDX-License-Identifier: GPL-3.0-or-later
// kambara-screenshots FOLDER STATE...: the window in each state, as FOLDER/STATE.png. States:
// simulated, recording, lost, no-gl, and the forms by names that end in levelling, range or head;
// any other name gives the simulated one under that name. screenshots.sh makes all of them, each on
// a screen of its own.
#include <QApplication>
#include <QLocale>
#include <QPixmap>
#include <QScreen>
#include <cstdio>
#include <stdexcept>

#include "app/kambara/language.h"
#include "tests/ui/form_page.h"
#include "tests/ui/recorded_rig.h"
#include "tests/ui/window_page.h"
#include "ui/base/theme.h"
#include "ui/scene3d/gl_probe.h"

namespace {

using namespace kambara;
using testing_support::RecordedRig;
using testing_support::WindowPage;

void require(bool so, const char* what) {
    if (!so) {
        throw std::runtime_error(what);
    }
}

void settle(int seconds) {
    WindowPage::until([] { return false; }, seconds);
}

void take(WindowPage& page, const QString& file) {
    settle(1);
    const QPixmap screen = page.window().screen()->grabWindow(0);
    require(screen.save(file), "the screenshot can't be written");
    std::printf("%s\n", qPrintable(file));
}

void track(WindowPage& page, int seconds) {
    require(page.until_picture(), "no picture comes");
    page.drag(page.target());
    require(page.until_state(TrackState::tracking), "the target is not tracked");
    settle(seconds);
}

void simulated(const QString& file, bool with_gl) {
    WindowPage page(WindowPage::simulated(with_gl));
    track(page, 12);
    take(page, file);
}

void recording(const QString& file, bool until_lost) {
    const std::string profile = "default?rate=15";
    const RecordedRig recorded =
        RecordedRig::as_pictures(*simulated_profile(profile), 120, until_lost ? 60 : 120);
    ui::WindowOptions options = WindowPage::simulated();
    options.first = recorded.request();
    WindowPage page(options, profile);
    track(page, 0);
    page.key(Qt::Key_Space);
    if (until_lost) {
        require(page.until_state(TrackState::lost), "the target is not lost");
    } else {
        require(page.until([&] { return page.shown().frame > 90; }), "the recording stands");
        page.key(Qt::Key_Space);
    }
    take(page, file);
}

void form(const QString& file, const char* action, const char* window_name) {
    WindowPage page(WindowPage::simulated(false));
    require(page.until_picture(), "no picture comes");
    testing_support::FormPage opened(page, action, window_name);
    settle(2);
    require(opened.window().grab().save(file), "the screenshot can't be written");
    std::printf("%s\n", qPrintable(file));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        std::fputs("usage: kambara-screenshots FOLDER STATE...\n", stderr);
        return 2;
    }
    ui::prepare_for_gl();
    QApplication application(argc, argv);
    const Language language(qEnvironmentVariable("KAMBARA_LANGUAGE", "C"));
    ui::apply_theme(application);
    try {
        for (int i = 2; i < argc; ++i) {
            const QString state = QString::fromLocal8Bit(argv[i]);
            const QString file =
                QString::fromLocal8Bit(argv[1]) + QLatin1Char('/') + state + QStringLiteral(".png");
            if (state == QLatin1String("recording") || state == QLatin1String("lost")) {
                recording(file, state == QLatin1String("lost"));
            } else if (state.endsWith(QLatin1String("levelling"))) {
                form(file, "level", "levellingWindow");
            } else if (state.endsWith(QLatin1String("range"))) {
                form(file, "rangeExperiment", "rangeWindow");
            } else if (state.endsWith(QLatin1String("head"))) {
                form(file, "calibrateHead", "headWindow");
            } else if (state.endsWith(QLatin1String("zoom"))) {
                form(file, "calibrateZoom", "zoomWindow");
            } else {
                simulated(file, state != QLatin1String("no-gl"));
            }
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "kambara-screenshots: %s\n", error.what());
        return 1;
    }
    return 0;
}
