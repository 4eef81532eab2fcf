// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/core_text.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <iterator>
#include <utility>
#include <vector>

#include "ui/base/core_phrases.h"

namespace kambara::ui {
namespace {

// Longer ones first where one is part of another.
const char* const phrases[] = {
    QT_TRANSLATE_NOOP("core", "doubtful for too long: %1"),
    QT_TRANSLATE_NOOP("core", "given up: %1"),
    QT_TRANSLATE_NOOP("core", "no position: %1"),
    QT_TRANSLATE_NOOP("core", "the match is right with a probability of only %1 %"),
    QT_TRANSLATE_NOOP("core",
                      "the likest place in the left picture is right with a probability of only %1 "
                      "%"),
    QT_TRANSLATE_NOOP("core", "another place where it may be looks the same"),
    QT_TRANSLATE_NOOP("core", "what looks most like it is not where it may be"),
    QT_TRANSLATE_NOOP("core", "looking for it: nothing in the left picture is clearly it"),
    QT_TRANSLATE_NOOP("core", "the predicted place is outside the left picture"),
    QT_TRANSLATE_NOOP("core", "not found in the right picture"),
    QT_TRANSLATE_NOOP("core", "the right picture holds another place that looks the same"),
    QT_TRANSLATE_NOOP("core", "what was found in the right picture leads back to another place"),
    QT_TRANSLATE_NOOP("core", "what looks like it is farther away than it can have gone"),
    QT_TRANSLATE_NOOP("core", "its distance would have leapt from %1 to %2 m"),
    QT_TRANSLATE_NOOP("core", "Target %1: %2"),
    QT_TRANSLATE_NOOP("core", "%1 -> %2: %3"),
    QT_TRANSLATE_NOOP("core", "%1 -> %2"),
    QT_TRANSLATE_NOOP("core", "Idle"),
    QT_TRANSLATE_NOOP("core", "TemplateSet"),
    QT_TRANSLATE_NOOP("core", "Tracking"),
    QT_TRANSLATE_NOOP("core", "Doubtful"),
    QT_TRANSLATE_NOOP("core", "Lost"),
    QT_TRANSLATE_NOOP("core", "The source has come to its end."),
    QT_TRANSLATE_NOOP("core",
                      "A camera may have moved: the right picture shows things %1 px below where "
                      "the calibration expects them (median of %2 matches; %3 px would be usual), "
                      "as if the right camera had tilted up by %4 degrees against the left one. "
                      "Check the cameras' mounts, then calibrate again."),
    QT_TRANSLATE_NOOP("core",
                      "A camera may have moved: the right picture shows things %1 px above where "
                      "the calibration expects them (median of %2 matches; %3 px would be usual), "
                      "as if the right camera had tilted down by %4 degrees against the left one. "
                      "Check the cameras' mounts, then calibrate again."),
    QT_TRANSLATE_NOOP("core",
                      "The cameras see each other's points where the calibration expects them "
                      "again (%1 px beside, median of %2 matches)."),
    QT_TRANSLATE_NOOP("core", "The target is not held still yet."),
    QT_TRANSLATE_NOOP("core", "The target is where shot %1 shows it already: move it."),
    QT_TRANSLATE_NOOP("core", "The %1 camera does not find the target: %2"),
    QT_TRANSLATE_NOOP("core", "The %1 camera does not find the target."),
    QT_TRANSLATE_NOOP("core", "The %1 picture is blurred: edges are %2 px wide."),
    QT_TRANSLATE_NOOP(
        "core", "The %1 picture shows the corners to %2 px only: too dark, too small, or blurred."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's pictures have another size than the session began with."),
    QT_TRANSLATE_NOOP("core", "The pan-tilt head is not at home: turn it home first."),
    QT_TRANSLATE_NOOP("core", "There is nothing to undo."),
    QT_TRANSLATE_NOOP("core", "The folder %1 can't be made: %2."),
    QT_TRANSLATE_NOOP("core", "Choose a place that can be written to."),
    QT_TRANSLATE_NOOP("core", "%1 holds a calibration session already."),
    QT_TRANSLATE_NOOP("core", "Resume it, or choose another folder."),
    QT_TRANSLATE_NOOP("core",
                      "The scale rests on the target's sizes alone; a baseline measured by tape "
                      "would check them."),
    QT_TRANSLATE_NOOP("core", "The template was updated by command."),
    QT_TRANSLATE_NOOP("core", "A new calibration is in use. Choose the template again."),
    QT_TRANSLATE_NOOP("core", "The head is steered to target %1 now."),
    QT_TRANSLATE_NOOP("core", "There is no target %1."),
    QT_TRANSLATE_NOOP("core", "Choose it in the left picture first."),
    QT_TRANSLATE_NOOP("core", "Targets have the numbers 1 to %1: there can't be a target %2."),
    QT_TRANSLATE_NOOP("core", "Clear a target, then choose this one with its number."),
    QT_TRANSLATE_NOOP("core", "There is no template to follow."),
    QT_TRANSLATE_NOOP("core", "Choose one in the left picture first."),
    QT_TRANSLATE_NOOP("core", "The target is not in sight, so its template can't be updated."),
    QT_TRANSLATE_NOOP("core", "Wait until it is tracked, or choose a new template."),
    QT_TRANSLATE_NOOP("core", "Frame %1 is no longer remembered."),
    QT_TRANSLATE_NOOP("core", "Choose the template in a newer picture."),
    QT_TRANSLATE_NOOP("core", "There is no pan-tilt head."),
    QT_TRANSLATE_NOOP("core", "Connect one, or name it when starting."),
    QT_TRANSLATE_NOOP("core",
                      "The head can't look there: it reaches %1 degrees to the sides and "
                      "%2 up and down."),
    QT_TRANSLATE_NOOP("core", "Give angles within these limits."),
    QT_TRANSLATE_NOOP("core",
                      "The head was halted: nobody said any more that it is to go on turning."),
    QT_TRANSLATE_NOOP("core", "The head can't be turned at a speed."),
    QT_TRANSLATE_NOOP("core", "The head can't be reset."),
    QT_TRANSLATE_NOOP("core", "The head has no zoom."),
    QT_TRANSLATE_NOOP("core", "The head has no focus."),
    QT_TRANSLATE_NOOP("core", "The head has no autofocus."),
    QT_TRANSLATE_NOOP("core", "The head has no presets."),
    QT_TRANSLATE_NOOP("core", "Use another head."),
    QT_TRANSLATE_NOOP("core", "There is no preset %1."),
    QT_TRANSLATE_NOOP("core", "Nothing was kept in preset %1."),
    QT_TRANSLATE_NOOP("core", "Keep a position in it first."),
    QT_TRANSLATE_NOOP("core", "Give a number from %1 to %2."),
    QT_TRANSLATE_NOOP("core", "Nothing is seen at that place of the pan-tilt picture."),
    QT_TRANSLATE_NOOP("core", "Choose one nearer to its middle."),
    QT_TRANSLATE_NOOP("core", "Calibrate it with the others first."),
    QT_TRANSLATE_NOOP("core", "The head answers."),
    QT_TRANSLATE_NOOP("core", "The head answers again."),
    QT_TRANSLATE_NOOP("core",
                      "The head does not answer. Check its power, the line and the address."),
    QT_TRANSLATE_NOOP("core", "The head does not answer any more; trying to reach it."),
    QT_TRANSLATE_NOOP("core", "The line to the head (%1) was lost (%2)."),
    QT_TRANSLATE_NOOP("core", "Plug it in again; it is tried on and on."),
    QT_TRANSLATE_NOOP("core", "The line to the head (%1) is there again."),
    QT_TRANSLATE_NOOP("core", "The line to the head (%1) can't be opened (%2)."),
    QT_TRANSLATE_NOOP(
        "core", "Check that it is plugged in and switched on, its name, and the right to use it."),
    QT_TRANSLATE_NOOP("core", "The head (%1) does not answer. Check its power and the line."),
    QT_TRANSLATE_NOOP("core", "The head was switched on, or the chain has changed: starting anew."),
    QT_TRANSLATE_NOOP("core", "The head is in standby: it is switched on."),
    QT_TRANSLATE_NOOP("core", "The head came to rest elsewhere: it is told again."),
    QT_TRANSLATE_NOOP("core", "The head stays %1 steps short of where it should look."),
    QT_TRANSLATE_NOOP("core", "The head said to be where it can't be; asked again."),
    QT_TRANSLATE_NOOP("core", "%1 bytes from the head made no sense and were passed over."),
    QT_TRANSLATE_NOOP("core", "The rig file does not say where the pan-tilt camera is."),
    QT_TRANSLATE_NOOP("core", "Calibrate it with the others, then hand over the steering."),
    QT_TRANSLATE_NOOP("core", "The source is over: there are no more pictures to take."),
    QT_TRANSLATE_NOOP("core", "Go back to an earlier frame, or open it again."),
    QT_TRANSLATE_NOOP("core", "There is no frame %1: the recording has %2."),
    QT_TRANSLATE_NOOP("core", "Live pictures can't be wound to another frame."),
    QT_TRANSLATE_NOOP("core", "Open a recording."),
    QT_TRANSLATE_NOOP("core", "The template %1 is not inside the picture of %2 pixels."),
    QT_TRANSLATE_NOOP("core", "Choose a rectangle that lies wholly inside."),
    QT_TRANSLATE_NOOP("core", "The template %1 is too small to be followed."),
    QT_TRANSLATE_NOOP("core", "Choose at least 7 x 7 pixels; 21 x 21 is a good size."),
    QT_TRANSLATE_NOOP("core", "The template %1 is too large to be followed."),
    QT_TRANSLATE_NOOP("core", "Choose at most 255 x 255 pixels; 31 x 31 is a good size."),
    QT_TRANSLATE_NOOP("core",
                      "The template %1 has no texture: its grey levels vary by %2, noise "
                      "included."),
    QT_TRANSLATE_NOOP("core", "Choose a piece with marks or edges, or a larger one."),
    QT_TRANSLATE_NOOP("core",
                      "The template %1 has texture in one direction only and would slide "
                      "along it."),
    QT_TRANSLATE_NOOP("core", "Include a corner, an end of the edge or another mark."),
    QT_TRANSLATE_NOOP("core",
                      "The template %1 lies where the left lens's calibration does not "
                      "reach."),
    QT_TRANSLATE_NOOP("core", "Choose a place nearer to the middle of the picture."),
    QT_TRANSLATE_NOOP("core", "There is no file %1."),
    QT_TRANSLATE_NOOP("core", "Check the name and the folder."),
    QT_TRANSLATE_NOOP("core", "No pictures have come from the cameras within five seconds."),
    QT_TRANSLATE_NOOP("core", "Check that they are connected and that nothing else uses them."),
    QT_TRANSLATE_NOOP("core",
                      "The left and right recordings have different lengths: %1 ends after "
                      "%2 frames, %3 goes on."),
    QT_TRANSLATE_NOOP("core", "Give two recordings of the same instants, or cut the longer one."),
    QT_TRANSLATE_NOOP("core",
                      "The pictures are %1 pixels, but the rig file is for %2, which is "
                      "another shape."),
    QT_TRANSLATE_NOOP("core",
                      "Use the rig file that belongs to these pictures, or calibrate "
                      "anew."),
    QT_TRANSLATE_NOOP("core", "No file fits the pattern %1."),
    QT_TRANSLATE_NOOP("core", "Check the folder and the pattern; on a command line, quote it."),
    QT_TRANSLATE_NOOP("core", "The pattern %1 is not understood."),
    QT_TRANSLATE_NOOP("core", "Use one number form such as left/%06d.png, or left/*.png."),
    QT_TRANSLATE_NOOP("core", "There is no folder %1."),
    QT_TRANSLATE_NOOP("core", "Check the name."),
    QT_TRANSLATE_NOOP("core", "%1 is a folder."),
    QT_TRANSLATE_NOOP("core", "Name its pictures, for example %1."),
    QT_TRANSLATE_NOOP(
        "core", "%1 can't be read as a picture: it is damaged, cut short or of another kind."),
    QT_TRANSLATE_NOOP("core", "Check the file, or leave it out."),
    QT_TRANSLATE_NOOP("core",
                      "%1 can't be read as a video: it is damaged, cut short or of another kind."),
    QT_TRANSLATE_NOOP("core", "Check that it plays elsewhere, or give pictures instead."),
    QT_TRANSLATE_NOOP(
        "core", "The video %1 is cut short: it announces %2 frames, but only %3 can be read."),
    QT_TRANSLATE_NOOP("core", "Copy it again from where it was recorded, or cut it at that frame."),
    QT_TRANSLATE_NOOP("core", "%1 has %2 pixels, the pictures before it %3."),
    QT_TRANSLATE_NOOP("core", "The left pictures are %1 pixels, the right ones %2."),
    QT_TRANSLATE_NOOP("core", "Give two sources of the same size."),
    QT_TRANSLATE_NOOP("core", "The rig file holds no right camera."),
    QT_TRANSLATE_NOOP("core", "Calibrate both cameras, or leave the right source out."),
    QT_TRANSLATE_NOOP("core", "The rig file is not valid YAML (%1)."),
    QT_TRANSLATE_NOOP("core", "Mend the file, or make it anew with calibrate or convert."),
    QT_TRANSLATE_NOOP("core", "There is no rig file."),
    QT_TRANSLATE_NOOP("core", "Name one with --rig."),
};

struct Phrase {
    QRegularExpression pattern;
    const char* source;
};

std::vector<Phrase> compiled() {
    std::vector<const char*> sources(std::begin(phrases), std::end(phrases));
    const auto of_calibration = calibration_phrases();
    sources.insert(sources.end(), of_calibration.begin(), of_calibration.end());
    const auto of_experiments = experiment_phrases();
    sources.insert(sources.end(), of_experiments.begin(), of_experiments.end());
    std::vector<Phrase> all;
    for (const char* source : sources) {
        QString pattern = QRegularExpression::escape(QString::fromUtf8(source));
        for (const char* place : {"\\%1", "\\%2", "\\%3", "\\%4", "%1", "%2", "%3", "%4"}) {
            // As little as will do: the first colon ends a target's number, or a state.
            pattern.replace(QString::fromLatin1(place), QStringLiteral("(.+?)"));
        }
        all.push_back(
            {QRegularExpression(QStringLiteral("\\A") + pattern + QStringLiteral("\\z")), source});
    }
    return all;
}

// The one name of a state that is no word.
const char* name_for_people(const char* source) {
    return QLatin1String(source) == QLatin1String("TemplateSet")
               ? QT_TRANSLATE_NOOP("core", "Template set")
               : source;
}

QString translated(const QString& text) {
    static const std::vector<Phrase> all = compiled();
    for (const Phrase& phrase : all) {
        const auto match = phrase.pattern.match(text);
        if (!match.hasMatch()) {
            continue;
        }
        QString result = QCoreApplication::translate("core", name_for_people(phrase.source));
        for (int i = 1; i <= match.lastCapturedIndex(); ++i) {
            result.replace(QLatin1Char('%') + QString::number(i), translated(match.captured(i)));
        }
        return result;
    }
    return text;
}

}  // namespace

QString translated(const std::string& text) {
    return translated(QString::fromStdString(text));
}

QString translated(const Error& error) {
    return translated(error.cause) + QLatin1Char(' ') + translated(error.remedy);
}

QString name_of(TrackState state) {
    return translated(to_string(state));
}

}  // namespace kambara::ui
