// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/window_actions.h"

#include <QAction>
#include <QWidget>
#include <algorithm>

namespace kambara::ui {

WindowActions::WindowActions(QWidget* window) : QObject(window) {
    open_recording = make(tr("&Open recording\u2026"), QStringLiteral("Ctrl+O"),
                          tr("Opens pictures or videos of both cameras"), "openRecording");
    simulated_rig = make(tr("&Simulated rig"), QStringLiteral("Ctrl+R"),
                         tr("Runs on the simulated rig, live"), "simulatedRig");
    close_form =
        make(tr("Close &form"), QStringLiteral("Ctrl+W"),
             tr("Closes the form or the calibration that is in front"), "closeFormInFront");
    close_form->setShortcutContext(Qt::ApplicationShortcut);
    quit = make(tr("&Quit"), QStringLiteral("Ctrl+Q"), tr("Closes the program"), "quit");
    play = make(tr("&Play"), QStringLiteral("Space"), tr("Lets the recording run, or holds it"),
                "play");
    play->setCheckable(true);
    step = make(tr("S&tep"), QStringLiteral("."), tr("Takes one pair of pictures"), "step");
    freeze = make(tr("&Freeze picture"), QStringLiteral("Ctrl+F"),
                  tr("Holds the left picture still, to choose a target in it; the pipeline goes "
                     "on"),
                  "freeze");
    freeze->setCheckable(true);
    select = make(tr("&Select target"), QStringLiteral("T"),
                  tr("Offers a rectangle in the left picture: arrow keys move it, with Shift they "
                     "change its size, Enter takes it. With the mouse: drag a rectangle. With "
                     "Ctrl: one more target"),
                  "selectTarget");
    start = make(tr("St&art tracking"), QStringLiteral("F5"), tr("Follows the template again"),
                 "startTracking");
    stop = make(tr("S&top"), QStringLiteral("Esc"),
                tr("Stops tracking and halts the head; the template is kept"), "stop");
    update_template = make(tr("&Update template"), QStringLiteral("U"),
                           tr("Takes what is seen now as the new template"), "updateTemplate");
    clear = make(tr("&Clear template"), QStringLiteral("Del"), tr("Forgets all targets"),
                 "clearTemplate");
    steer = make(tr("&Steer"), QStringLiteral("A"),
                 tr("Steers the head to the target; off: it is moved by hand"), "steer");
    steer->setCheckable(true);
    servo =
        make(tr("Follow in its &picture"), QStringLiteral("Shift+A"),
             tr("Follows the target in the pan-tilt picture, too: that makes the aim right, and "
                "stands in where the stereo pair does not see it"),
             "servo");
    servo->setCheckable(true);
    home = make(tr("&Home"), QStringLiteral("H"), tr("Turns the head straight ahead"), "home");
    halt = make(tr("Hal&t head"), QStringLiteral("F12"),
                tr("Stops the head at once, from anywhere in the program"), "halt");
    reset_head = make(tr("&Reset head"), QString(),
                      tr("Lets the head find its home position anew, as after it was turned by "
                         "force"),
                      "resetHead");
    halt->setShortcutContext(Qt::ApplicationShortcut);
    // The forms say that tracking is started so; Esc is theirs, to leave a field.
    start->setShortcutContext(Qt::ApplicationShortcut);
    calibrate = make(tr("&Calibrate\u2026"), QStringLiteral("Ctrl+K"),
                     tr("Calibrates the cameras, step by step"), "calibrate");
    level = make(tr("&Levelling\u2026"), QStringLiteral("Ctrl+L"),
                 tr("Finds the angle in which the rig is mounted"), "level");
    range_experiment = make(tr("&Range experiment\u2026"), QStringLiteral("Ctrl+E"),
                            tr("Holds measured positions against known places"), "rangeExperiment");
    calibrate_head =
        make(tr("&Head calibration\u2026"), QStringLiteral("Ctrl+J"),
             tr("Finds the pan-tilt head's axes, lever arms and backlash"), "calibrateHead");
    calibrate_zoom = make(tr("&Zoom calibration\u2026"), QStringLiteral("Ctrl+Shift+J"),
                          tr("Measures how much the head's lens enlarges"), "calibrateZoom");
    stretch_map = make(tr("&Stretch map contrast"), QStringLiteral("M"),
                       tr("Spreads the map's colours over the values it holds"), "stretchMap");
    stretch_map->setCheckable(true);
    default_layout = make(tr("&Restore default layout"), QString(),
                          tr("Puts all parts of the window back in their places"), "defaultLayout");
    keys = make(tr("&Keys"), QStringLiteral("F1"), tr("Shows every key and what it does"), "keys");
    about = make(tr("&About Kambara"), QString(), tr("Versions and licences"), "about");
    update(nullptr, false);
}

QAction* WindowActions::make(const QString& text, const QString& key, const QString& help,
                             const char* object_name) {
    auto* action = new QAction(text, parent());
    action->setObjectName(QLatin1String(object_name));
    if (!key.isEmpty()) {
        action->setShortcut(QKeySequence(key));
    }
    action->setProperty("help", help);
    allow(action, QString());
    static_cast<QWidget*>(parent())->addAction(action);
    return action;
}

void WindowActions::allow(QAction* action, const QString& reason_not) {
    action->setEnabled(reason_not.isEmpty());
    const QString key = action->shortcut().toString(QKeySequence::NativeText);
    const QString help = reason_not.isEmpty() ? action->property("help").toString() : reason_not;
    action->setToolTip(key.isEmpty() ? help : QStringLiteral("%1  [%2]").arg(help, key));
    action->setStatusTip(help);
}

void WindowActions::update(const Snapshot* snapshot, bool recording) {
    const QString nothing = snapshot == nullptr ? tr("Open a source first.") : QString();
    const auto unless = [&](bool possible, const QString& reason) {
        return !nothing.isEmpty() ? nothing : possible ? QString() : reason;
    };
    const bool over = snapshot != nullptr &&
                      (snapshot->run == RunState::ended || snapshot->run == RunState::failed);
    const bool running = snapshot != nullptr && snapshot->run == RunState::running;
    const auto state = snapshot != nullptr ? steered_estimate(*snapshot).state : TrackState::idle;
    const bool has_template = state != TrackState::idle;
    const bool all_followed =
        snapshot == nullptr ||
        std::none_of(snapshot->tracks.begin(), snapshot->tracks.end(), [](const auto& track) {
            return track.estimate.state == TrackState::template_set;
        });
    const bool in_sight = state == TrackState::tracking || state == TrackState::doubtful;
    const bool has_head = snapshot != nullptr && snapshot->head.has_value();
    const QString no_head = tr("There is no pan-tilt head.");
    allow(play, unless(recording && !over, recording ? tr("The recording is over: go back first.")
                                                     : tr("Only a recording can be held.")));
    play->setChecked(running);
    play->setText(running && recording ? tr("&Pause") : tr("&Play"));
    allow(step, unless(recording && !over && !running,
                       !recording ? tr("Only a recording can be stepped.")
                       : over     ? tr("The recording is over: go back first.")
                                  : tr("Pause the recording first.")));
    allow(freeze, nothing);
    allow(select, nothing);
    allow(start, unless(!all_followed, has_template ? tr("The target is followed already.")
                                                    : tr("Choose a target first.")));
    // Stopping is never refused: it does no harm when there is nothing to stop.
    allow(update_template, unless(in_sight, tr("The target must be in sight.")));
    allow(clear, unless(has_template, tr("There is no template.")));
    allow(steer, unless(has_head, no_head));
    steer->setChecked(has_head && snapshot->head->automatic);
    const bool has_view = has_head && snapshot->pictures.pan_tilt.picture;
    allow(servo, unless(has_view, has_head ? tr("There is no pan-tilt picture.") : no_head));
    servo->setChecked(snapshot != nullptr && snapshot->servo && snapshot->servo->on);
    allow(calibrate,
          unless(!over, tr("The source is over: there are no pictures to calibrate from.")));
    for (QAction* assistant : {level, range_experiment, calibrate_head, calibrate_zoom}) {
        allow(assistant, nothing);
    }
    allow(home, unless(has_head, no_head));
    allow(halt, unless(has_head, no_head));
    allow(reset_head, unless(has_head && snapshot->head->abilities.reset,
                             has_head ? tr("This head can't be reset.") : no_head));
}

}  // namespace kambara::ui
