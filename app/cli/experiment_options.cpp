// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/experiment_options.h"

#include <CLI/CLI.hpp>

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
        ->check(CLI::PositiveNumber);
    c->add_option("--csv", o.csv, "Table to write");
    c->add_option("--report", o.report, "HTML page to write");
    return c;
}

}  // namespace kambara::cli
