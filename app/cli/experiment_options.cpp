// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/experiment_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/argument_checks.h"

namespace kambara::cli {

CLI::App* add_range_test(CLI::App& app, RangeTestOptions& o) {
    CLI::App* c = app.add_subcommand(
        "range-test",
        "Known places against measured positions, before and after a correction of "
        "the baseline");
    c->add_option("--rig", o.rig, "The rig that measured; not needed with sim:");
    c->add_option("--known", o.known,
                  "Table with columns x_mm,y_mm,z_mm and either left_x_px,left_y_px,right_x_px,"
                  "right_y_px or first_frame,last_frame; not needed with sim:stations");
    c->add_option("--track", o.track,
                  "Track table whose frames the known places speak of; written first with --left");
    c->add_option("--left", o.left, "Follow the target in these left pictures, or sim:stations");
    c->add_option("--right", o.right, "Right pictures");
    c->add_option("--template", o.templ, "X,Y,W,H in the first frame; auto with sim:")
        ->capture_default_str();
    c->add_option("--frame", o.frame,
                  "Frame of the known places: left (camera), rig, or own: wherever it lies, it is "
                  "fitted")
        ->capture_default_str()
        ->check(CLI::IsMember({"left", "rig", "own"}));
    c->add_option("--baseline", o.true_baseline_mm,
                  "The baseline measured by other means, mm; else the one that suits the places "
                  "best")
        ->check(above_zero());
    c->add_option("--csv", o.csv, "Table to write");
    c->add_option("--report", o.report, "HTML page to write");
    return c;
}

CLI::App* add_level(CLI::App& app, LevelOptions& o) {
    CLI::App* c = app.add_subcommand(
        "level",
        "The angle in which the rig is mounted, from a movement straight up and down or "
        "from an upright wall");
    c->add_option("--rig", o.rig, "The rig that measured")->required();
    c->add_option("--track", o.track,
                  "Track table (frame left) of a target moved straight up and down");
    c->add_option("--points", o.points,
                  "Table with columns x_mm,y_mm,z_mm in the left camera's frame, or left_x_px,"
                  "left_y_px,right_x_px,right_y_px");
    c->add_option("--by", o.by, "vertical: a movement; wall: points of a wall before the rig")
        ->capture_default_str();
    c->add_option("--roll", o.roll_deg,
                  "By a wall, which does not tell it: how far the rig's right side hangs down, "
                  "degrees (0, or the rig file's)");
    c->add_option("--heading", o.heading_deg,
                  "How far the rig looks to the right of the bow, degrees (0, or the rig file's)");
    c->add_option("--rig-at", o.rig_in_vehicle,
                  "X,Y,Z: the rig's origin in the vehicle's frame, mm: forward, to the right, down "
                  "(0,0,0, or the rig file's)");
    c->add_option("--out", o.out, "Rig file to write, with the mount");
    return c;
}

CLI::App* add_calibrate_head(CLI::App& app, CalibrateHeadOptions& o) {
    CLI::App* c =
        app.add_subcommand("calibrate-head",
                           "The head's axes, lever arms and backlash, from pictures of a target at "
                           "several head positions");
    c->add_option("--rig", o.rig, "Rig file of all three cameras, the head at home")->required();
    c->add_option("--views", o.views,
                  "Table with columns left,right,pan_tilt (pictures),pan_deg,tilt_deg and, for the "
                  "backlash, pan_from,tilt_from (below or above)")
        ->required();
    c->add_option("--target", o.target, "As for calibrate")->capture_default_str();
    c->add_option("--out", o.out, "Rig file to write, with the head's model")->required();
    c->add_flag("--refine-rig", o.refine_rig,
                "Write the left and right camera as the views correct them, too; needs a rig file "
                "with calibration_covariance");
    return c;
}

CLI::App* add_calibrate_zoom(CLI::App& app, CalibrateZoomOptions& o) {
    CLI::App* c = app.add_subcommand(
        "calibrate-zoom",
        "How much larger a head's lens shows things at each place of its zoom, from pictures of a "
        "scene at rest");
    c->add_option("--rig", o.rig, "Rig file with the pan-tilt camera, calibrated at its widest")
        ->required();
    c->add_option("--views", o.views,
                  "Table with columns pan_tilt (pictures) and zoom_share (0 wide to 1 tele, as "
                  "pan-tilt tells it); from one to the next at most a half larger")
        ->required();
    c->add_option("--head", o.head, "The kind of head, a name of the table")->capture_default_str();
    c->add_option("--heads", o.heads, "Table of heads; the one that is built in where not given");
    c->add_option("--widest", o.widest,
                  "F,WIDTH: focal length at the widest and the sensor's width, mm, where the table "
                  "does not know them");
    c->add_option("--out", o.out,
                  "Table of heads to write, with the curve, without the comments of the one read")
        ->required();
    return c;
}

}  // namespace kambara::cli
