// SPDX-License-Identifier: GPL-3.0-or-later
#include <QtGlobal>
#include <array>

#include "ui/base/core_phrases.h"

namespace kambara::ui {
namespace {

// Longer ones first where one is part of another.
constexpr std::array phrases{
    QT_TRANSLATE_NOOP("core", "The target was not moved along a line."),
    QT_TRANSLATE_NOOP("core", "Move it straight up or down, as on a plumb line, and nothing else."),
    QT_TRANSLATE_NOOP("core", "The movement is far from upright in the pictures."),
    QT_TRANSLATE_NOOP("core",
                      "Move the target up and down, not across or away; a rig that looks down by "
                      "more than 60 degrees can't be levelled so."),
    QT_TRANSLATE_NOOP("core", "The points do not lie spread over a plane."),
    QT_TRANSLATE_NOOP("core", "Measure points all over a flat, upright wall."),
    QT_TRANSLATE_NOOP("core", "The wall is seen too much from its side."),
    QT_TRANSLATE_NOOP("core", "Stand the rig before the wall, looking at it."),
    QT_TRANSLATE_NOOP(
        "core", "The points scatter so much that the mount's angle is known to %1 degrees only."),
    QT_TRANSLATE_NOOP("core", "Measure more points, over more height, nearer to the rig."),
    QT_TRANSLATE_NOOP("core", "%1 points are too few to level by."),
    QT_TRANSLATE_NOOP("core", "Station %1 %2."),
    QT_TRANSLATE_NOOP("core", "was measured behind the left camera"),
    QT_TRANSLATE_NOOP("core", "has a coordinate that is no number"),
    QT_TRANSLATE_NOOP("core", "has a known place that is not before the left camera"),
    QT_TRANSLATE_NOOP(
        "core", "Leave it out, or mend the tables of known places and of measured positions."),
    QT_TRANSLATE_NOOP("core", "The known places do not fix where their frame lies."),
    QT_TRANSLATE_NOOP("core",
                      "Give four or more that are not on one line, or give them in the rig's or "
                      "the left camera's frame."),
    QT_TRANSLATE_NOOP("core",
                      "The baseline that suits the known places best is %1 mm, the rig's is %2 mm, "
                      "and the range error is %3 % in the mean: that is no wrong baseline."),
    QT_TRANSLATE_NOOP("core",
                      "Check the known places, their frame and their unit, and that the target "
                      "that was followed stood there; or give the baseline measured by tape."),
    QT_TRANSLATE_NOOP("core", "The rig file holds no pan-tilt camera."),
    QT_TRANSLATE_NOOP("core", "Calibrate all three cameras with the head at home first."),
    QT_TRANSLATE_NOOP("core", "%1 views are too few to calibrate the head."),
    QT_TRANSLATE_NOOP(
        "core", "Give at least %1, over the whole range of pan and tilt that the target allows."),
    QT_TRANSLATE_NOOP("core", "The head's positions lie too near together to tell its axes."),
    QT_TRANSLATE_NOOP("core",
                      "Spread them over at least 20 degrees of pan and 10 degrees of tilt."),
    QT_TRANSLATE_NOOP("core", "A point lies where the pan-tilt camera can't see it."),
    QT_TRANSLATE_NOOP("core",
                      "Check the signs of the angles (pan to the right, tilt upwards) and the "
                      "pan-tilt camera's pose in the rig file."),
    QT_TRANSLATE_NOOP("core", "The views don't fit a head of two axes: RMS %1 px."),
    QT_TRANSLATE_NOOP("core",
                      "Check that each picture stands beside the angles it was taken at, the head "
                      "still, and that pan is positive to the right and tilt upwards."),
    QT_TRANSLATE_NOOP("core", "The %1 picture is not of the size that the rig was calibrated for."),
    QT_TRANSLATE_NOOP("core", "Give pictures of that size."),
    QT_TRANSLATE_NOOP("core",
                      "The left and the right picture share only %1 corners of the target."),
    QT_TRANSLATE_NOOP("core", "Show it to both."),
    QT_TRANSLATE_NOOP("core", "A picture of the three cameras is missing."),
    QT_TRANSLATE_NOOP("core", "Check that all three deliver pictures."),
    QT_TRANSLATE_NOOP("core", "The head's camera sees too few of the target's corners."),
    QT_TRANSLATE_NOOP("core", "Turn the head towards it."),
    QT_TRANSLATE_NOOP("core", "pan_deg and tilt_deg are not two numbers."),
    QT_TRANSLATE_NOOP("core", "%1 has no column %2."),
    QT_TRANSLATE_NOOP("core", "Name the columns in its first line, separated by commas."),
    QT_TRANSLATE_NOOP("core", "%1 holds no rows."),
    QT_TRANSLATE_NOOP("core", "Write one line for each."),
    QT_TRANSLATE_NOOP("core", "Line %1 of %2 holds no place."),
    QT_TRANSLATE_NOOP("core", "Give every place three numbers: x_mm, y_mm, z_mm."),
    QT_TRANSLATE_NOOP("core", "Give at least %1."),
    QT_TRANSLATE_NOOP("core", "From zoom %1 to %2 the %3 points found again fit no zoom."),
    QT_TRANSLATE_NOOP("core", "From zoom %1 to %2 only %3 points are found again."),
    QT_TRANSLATE_NOOP("core",
                      "Take more views between these, of a scene at rest with much detail, in "
                      "focus, the head at rest as well."),
    QT_TRANSLATE_NOOP("core", "The view at zoom %1 has %2 x %3 pixels, the camera %4 x %5."),
    QT_TRANSLATE_NOOP("core", "Use the rig file of the camera that took the views."),
    QT_TRANSLATE_NOOP("core", "Two views are at the same zoom, %1."),
    QT_TRANSLATE_NOOP("core", "Leave one of them out."),
    QT_TRANSLATE_NOOP("core", "The lens of the head \"%1\" at its widest is not known."),
    QT_TRANSLATE_NOOP("core",
                      "Tell its focal length and its sensor's width, mm (--widest F,WIDTH)."),
    QT_TRANSLATE_NOOP("core", "Save under another name."),
};

}  // namespace

std::span<const char* const> experiment_phrases() {
    return phrases;
}

}  // namespace kambara::ui
