// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/core_phrases.h"

#include <QtGlobal>
#include <array>

namespace kambara::ui {
namespace {

constexpr std::array phrases{
    QT_TRANSLATE_NOOP("core", "left"),
    QT_TRANSLATE_NOOP("core", "right"),
    QT_TRANSLATE_NOOP("core", "pan_tilt"),
    QT_TRANSLATE_NOOP("core", "It was stopped before its end."),
    QT_TRANSLATE_NOOP("core", "Only %1 views show the target; at least %2 are needed."),
    QT_TRANSLATE_NOOP("core",
                      "Only %1 views show the target to two cameras; at least %2 are needed."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's views determine no lens: show the target larger, at several "
                      "angles and distances."),
    QT_TRANSLATE_NOOP(
        "core",
        "No view of the %1 camera fits the target: check which target it is, and its numbers."),
    QT_TRANSLATE_NOOP("core", "No view shows the target to both the %1 and the %2 camera."),
    QT_TRANSLATE_NOOP("core",
                      "The pictures of the %1 and the %2 camera do not belong together: only %3 of "
                      "%4 pairs agree on where the cameras stand. Check that both lists are in the "
                      "same order, taken at the same instants, and neither mirrored."),
    QT_TRANSLATE_NOOP("core", "Only %1 views fit each other; at least %2 are needed."),
    QT_TRANSLATE_NOOP(
        "core",
        "The views do not determine the cameras: show the target at more angles and distances."),
    QT_TRANSLATE_NOOP("core",
                      "Pictures show the target mirrored and are left out: turn off the camera's "
                      "or the driver's mirroring."),
    QT_TRANSLATE_NOOP("core",
                      "%1 view repeats a picture of another view; each counts once. Move the "
                      "target between pictures."),
    QT_TRANSLATE_NOOP("core",
                      "%1 views repeat a picture of another view; each counts once. Move the "
                      "target between pictures."),
    QT_TRANSLATE_NOOP(
        "core", "%1 view does not fit the others and is left out; the list of views says why."),
    QT_TRANSLATE_NOOP(
        "core", "%1 views do not fit the others and are left out; the list of views says why."),
    QT_TRANSLATE_NOOP("core", "too few corners are seen"),
    QT_TRANSLATE_NOOP("core", "the target is mirrored in this picture"),
    QT_TRANSLATE_NOOP("core", "the %1 picture is the same as view %2's"),
    QT_TRANSLATE_NOOP("core", "its corners do not fit the target"),
    QT_TRANSLATE_NOOP("core", "fits far worse than the others (%1 px)"),
    QT_TRANSLATE_NOOP("core", "most of its corners contradict the other cameras'"),
    QT_TRANSLATE_NOOP(
        "core",
        "the %1 and %2 pictures contradict each other: not the same instant, or another target"),
    QT_TRANSLATE_NOOP("core", "The %1 camera can't be: %2."),
    QT_TRANSLATE_NOOP(
        "core",
        "The %1 camera's optical axis comes out at (%2, %3) px, far from the picture's middle."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's pixels come out %2 off square: check the sensor's numbers."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's focal length is open to %2: show the target at more angles "
                      "and distances."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera saw the target in %2 of its picture only: show it near the "
                      "sides and corners, too."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's residuals hang together over the picture (%2 px): the lens "
                      "model does not describe this lens."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's pictures are blurred: edges are %2 px wide. Focus, and hold "
                      "the target still."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's focal length is %2 times the expected one's, where %3 "
                      "should be: the pictures look taken in the other medium."),
    QT_TRANSLATE_NOOP("core",
                      "The %1 camera's focal length is %2 times the expected one's, where %3 "
                      "should be: another lens, zoom or target size."),
    QT_TRANSLATE_NOOP(
        "core",
        "The %1 camera's kappa1 is %2 / mm2 where %3 is expected: %4 at the side of the picture."),
    QT_TRANSLATE_NOOP(
        "core",
        "The %1 camera's lens bends by %2 at the side of the picture where %3 is expected."),
    QT_TRANSLATE_NOOP("core",
                      "The residuals are %1 px, more than %2: blurred pictures, another target, or "
                      "wrong numbers of it."),
    QT_TRANSLATE_NOOP("core",
                      "The residuals are %1 px; below %2 would be good. Blur, motion or an uneven "
                      "target do this."),
    QT_TRANSLATE_NOOP("core", "%1 of the corners fit nowhere and are left out."),
    QT_TRANSLATE_NOOP("core",
                      "The residuals hang together over the target (%1 px): its sizes and gaps are "
                      "not as described. Measure it again."),
    QT_TRANSLATE_NOOP(
        "core",
        "The target was seen from %1 to %2 mm only: the depth is narrow, and focal length and "
        "distance can't be told apart well. Show it nearer and farther, by a factor of two."),
    QT_TRANSLATE_NOOP("core",
                      "The right camera comes out to the left of the left one: the sides are "
                      "exchanged, or all pictures mirrored."),
    QT_TRANSLATE_NOOP("core",
                      "The left and right focal lengths differ by %1: if both lenses are of one "
                      "kind, one is wrong."),
    QT_TRANSLATE_NOOP("core",
                      "The baseline comes out at %1 mm, %2 deviations from the measured %3 mm: "
                      "check the target's sizes and the tape."),
    QT_TRANSLATE_NOOP(
        "core", "Left and right see no place in common in the working volume: no range there."),
    QT_TRANSLATE_NOOP("core",
                      "The calibration leaves ranges open to %1 (one deviation; %2 at worst): too "
                      "much to measure with."),
    QT_TRANSLATE_NOOP("core",
                      "The calibration leaves ranges open to %1 (one deviation; %2 at worst): take "
                      "more views, nearer and farther, to the sides."),
    QT_TRANSLATE_NOOP("core",
                      "Views that took no part come out %1 too large: the calibration does not "
                      "hold for other views."),
    QT_TRANSLATE_NOOP("core",
                      "Views that took no part come out %1 too small: the calibration does not "
                      "hold for other views."),
    QT_TRANSLATE_NOOP(
        "core", "Views that took no part come out %1 too large: more views would make it surer."),
    QT_TRANSLATE_NOOP(
        "core", "Views that took no part come out %1 too small: more views would make it surer."),
    QT_TRANSLATE_NOOP("core", "There is no picture."),
    QT_TRANSLATE_NOOP("core", "The left camera does not take part."),
    QT_TRANSLATE_NOOP("core", "A camera's pictures have no size."),
    QT_TRANSLATE_NOOP("core", "The target can't be: %1."),
    QT_TRANSLATE_NOOP("core", "A list of points can't be found in pictures."),
    QT_TRANSLATE_NOOP("core", "Choose the cameras and the target first."),
    QT_TRANSLATE_NOOP("core", "Begin a new session in another folder."),
    QT_TRANSLATE_NOOP("core", "Mend the file, or begin a new session in another folder."),
    QT_TRANSLATE_NOOP("core", "Move the shot out of the session's folder and resume again."),
    QT_TRANSLATE_NOOP("core", "Move one of them out of its folder and resume again."),
    QT_TRANSLATE_NOOP("core", "There is no shot %1."),
    QT_TRANSLATE_NOOP("core", "Choose one of the list."),
    QT_TRANSLATE_NOOP("core", "Only %1 of the target's boxes are large and clear enough."),
    QT_TRANSLATE_NOOP("core", "Bring the target nearer, out of glare."),
    QT_TRANSLATE_NOOP("core", "%1 Those seen are about %2 px wide, which is too small."),
    QT_TRANSLATE_NOOP(
        "core",
        "%1 One plane shows %2 boxes; others beside it are about %3 px wide, which is too small."),
    QT_TRANSLATE_NOOP("core",
                      "%1 The picture is blurred: its sharpest edges are about %2 px wide."),
    QT_TRANSLATE_NOOP("core", "Bring the target nearer."),
    QT_TRANSLATE_NOOP("core",
                      "Turn the target so that it faces the camera with both planes, nearer."),
    QT_TRANSLATE_NOOP("core", "Focus the lens, or hold the target still."),
    QT_TRANSLATE_NOOP(
        "core",
        "%1 of the target's %2 boxes are found, but its round marks are not where they belong."),
    QT_TRANSLATE_NOOP("core",
                      "Show a mark, unhidden and without glare; check that the target is the one "
                      "that carries them."),
    QT_TRANSLATE_NOOP(
        "core",
        "No boxes that stand like the target's %1 boxes are found among %2 quadrilaterals."),
    QT_TRANSLATE_NOOP("core", "Show more of the target, evenly lit, within 45 degrees of upright."),
    QT_TRANSLATE_NOOP("core",
                      "Which of the target's %1 boxes the %2 found are can't be told for certain."),
    QT_TRANSLATE_NOOP(
        "core", "Show boxes of the top and the bottom row, and of the first and the last column."),
    QT_TRANSLATE_NOOP("core", "Show boxes of the top and the bottom row, and of both planes."),
    QT_TRANSLATE_NOOP("core", "No chessboard of %1 x %2 inner corners is found."),
    QT_TRANSLATE_NOOP(
        "core",
        "Show the whole board with a white margin, evenly lit, and check the numbers of corners."),
    QT_TRANSLATE_NOOP("core",
                      "The chessboard is too small in the picture: its corners are %1 px apart."),
    QT_TRANSLATE_NOOP("core", "Bring it nearer."),
    QT_TRANSLATE_NOOP("core", "The chessboard's corners are too blurred to be measured."),
    QT_TRANSLATE_NOOP("core", "Hold it still and focus."),
    QT_TRANSLATE_NOOP("core", "No marker of the ChArUco board is found."),
    QT_TRANSLATE_NOOP("core", "Show the board larger and evenly lit, and check its dictionary."),
    QT_TRANSLATE_NOOP("core", "Only %1 corners of the ChArUco board are found."),
    QT_TRANSLATE_NOOP("core", "Show more of the board: six corners that are not all in a row."),
    QT_TRANSLATE_NOOP("core", "There is no marker dictionary \"%1\"."),
    QT_TRANSLATE_NOOP("core", "Name one of OpenCV's, for example DICT_6X6_250."),
    QT_TRANSLATE_NOOP("core", "A target of %1 can't be found in pictures."),
    QT_TRANSLATE_NOOP("core", "Use boxes, a chessboard or a ChArUco board."),
    QT_TRANSLATE_NOOP("core", "The target \"%1\" can't be used: %2."),
    QT_TRANSLATE_NOOP("core", "Give the numbers of the printed board."),
    QT_TRANSLATE_NOOP("core", "The target \"%1\" is not one this program knows."),
    QT_TRANSLATE_NOOP("core",
                      "Give a target file (.yaml), chessboard:9x6:30 (inner corners across x down, "
                      "square in mm), charuco:5x7:40:20:DICT_6X6_250 (squares across x down, "
                      "square, marker, dictionary) or two-plane-24."),
    QT_TRANSLATE_NOOP("core",
                      "it needs 3 to 100 inner corners each way and a square of up to 10000 mm"),
    QT_TRANSLATE_NOOP("core", "it needs 3 to 100 squares each way and a square of up to 10000 mm"),
    QT_TRANSLATE_NOOP("core", "its marker is not smaller than its square"),
    QT_TRANSLATE_NOOP("core", "its dictionary has only %1 markers"),
    QT_TRANSLATE_NOOP("core", "there is no marker dictionary \"%1\""),
    QT_TRANSLATE_NOOP("core", "it needs 1 to 16 planes and 1 to 100 rows"),
    QT_TRANSLATE_NOOP("core", "its boxes touch each other: a pitch is larger than the box"),
    QT_TRANSLATE_NOOP("core", "The target file's %1."),
    QT_TRANSLATE_NOOP("core", "Mend the file, or start from one of those in resources/targets."),
    QT_TRANSLATE_NOOP("core", "A mark of the target does not lie on its sheet."),
    QT_TRANSLATE_NOOP("core",
                      "Move the mark in the target file, or give the target a wider margin_mm."),
    QT_TRANSLATE_NOOP(
        "core",
        "The target's points can't be printed: some lie on no plane with three others or more."),
    QT_TRANSLATE_NOOP("core", "Print targets whose points stand on up to 16 planes."),
    QT_TRANSLATE_NOOP("core",
                      "A sheet of %1 with its ruler does not fit on %2 (%3) at its true size."),
};

}  // namespace

std::span<const char* const> calibration_phrases() {
    return phrases;
}

}  // namespace kambara::ui
