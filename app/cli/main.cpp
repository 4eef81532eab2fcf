// SPDX-License-Identifier: GPL-3.0-or-later
// kambara-cli: the vision system without a screen. Reads the command line, runs one command, tells
// how it went. Exit codes: 0 done, 1 failed or refused, 2 wrong usage.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/argument_checks.h"
#include "app/cli/bench_command.h"
#include "app/cli/calibrate_command.h"
#include "app/cli/calibrate_points_command.h"
#include "app/cli/calibration_statistics_command.h"
#include "app/cli/compare_command.h"
#include "app/cli/convert_command.h"
#include "app/cli/detect_command.h"
#include "app/cli/experiment_options.h"
#include "app/cli/head_options.h"
#include "app/cli/live_command.h"
#include "app/cli/match_command.h"
#include "app/cli/simulate_command.h"
#include "app/cli/target_command.h"
#include "app/cli/terminal.h"
#include "app/cli/track_command.h"
#include "app/cli/triangulate_command.h"
#include "core/base/text_file.h"

namespace {

using namespace kambara;
using namespace kambara::cli;

constexpr int exit_failed = 1;
constexpr int exit_usage = 2;

const std::vector<std::string> measure_words{"sad", "ncc", "zncc", "hamming"};
const std::vector<std::string> transform_words{"none",   "gauss", "rank3",   "rank5",
                                               "census", "sdog",  "gradient"};

struct Chosen {
    std::function<Outcome()> run;
    std::string json;  // a file, or - for standard output
};

void add_json(CLI::App& command, Chosen& chosen) {
    command.add_option("--json", chosen.json,
                       "Write the result as JSON to this file; - for standard output");
}

void add_position_method(CLI::App& command, std::string& method) {
    command
        .add_option("--position-method", method,
                    "reprojection (least error in both pictures), or for comparison 1999's sine "
                    "(rule), midpoint, parallel (parallel cameras only)")
        ->capture_default_str()
        ->check(CLI::IsMember({"reprojection", "sine", "midpoint", "parallel"}));
}

void add_track(CLI::App& app, Chosen& chosen, TrackOptions& o) {
    CLI::App* c = app.add_subcommand("track", "Follow targets through stereo pictures");
    c->add_option("--rig", o.sources.rig,
                  "Rig file; not needed with sim:, nor with --left alone (then without positions)");
    c->add_option("--left", o.sources.left, "Left pictures: a video, a pattern, or sim:PROFILE")
        ->required();
    c->add_option("--right", o.sources.right, "Right pictures");
    c->add_option(
         "--template", o.templates,
         "X,Y,W,H in the first frame; auto with sim:. Given again (up to 16 times): one more "
         "target")
        ->required()
        ->check(a_rectangle(true))
        ->allow_extra_args(false);
    c->add_option("--steer", o.steer, "The target that the head is steered to, counted from 1")
        ->capture_default_str();
    c->add_option("--start", o.sources.start, "Begin at this frame; numbering stays")
        ->check(not_negative());
    c->add_option("--rate", o.sources.pictures_rate_hz,
                  "Single pictures a second, which carry no time themselves")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 1000.0));
    c->add_option("--measure", o.measure, "sad, ncc, zncc or hamming")
        ->capture_default_str()
        ->check(CLI::IsMember(measure_words));
    c->add_option("--transform", o.transform,
                  "none, gauss, rank3, rank5, census, sdog or gradient; with zncc, none turns to "
                  "gauss while noise is much")
        ->capture_default_str()
        ->check(CLI::IsMember(transform_words));
    c->add_option("--temporal", o.temporal,
                  "Filter the pictures over time first: median:N or mean:N, N up to 15; for still "
                  "cameras");
    c->add_option("--pan-tilt", o.sources.pan_tilt,
                  "Head to steer: sim:PROFILE, visca:/dev/ttyS0?address=1, visca-udp:HOST:PORT, "
                  "visca-udp-raw:HOST:PORT or visca-tcp:HOST:PORT");
    c->add_flag("--servo", o.servo,
                "Make the aim right by the pan-tilt camera's own picture; with sim:");
    c->add_option("--seconds", o.seconds, "Stop after so much of the source's time")
        ->check(above_zero());
    c->add_option("--record", o.record, "Folder to record the session in; not in this version yet");
    add_position_method(*c, o.position_method);
    c->add_option("--frame", o.frame,
                  "Frame of the table's positions: left (camera), rig, level or vehicle; the last "
                  "two need a rig file with a mount")
        ->capture_default_str()
        ->check(CLI::IsMember({"left", "rig", "level", "vehicle"}));
    c->add_option("--csv", o.csv, "Table to write")->required();
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_track(o); }; });
}

void add_calibrate(CLI::App& app, Chosen& chosen, CalibrateOptions& o) {
    CLI::App* c = app.add_subcommand("calibrate", "Calibrate cameras from pictures of a target");
    c->add_option("--left", o.left, "Left pictures (pattern)")->required();
    c->add_option("--right", o.right, "Right pictures (pattern)");
    c->add_option("--pan-tilt", o.pan_tilt, "Pan-tilt camera's pictures (pattern)");
    c->add_option("--target", o.target,
                  "A target file, chessboard:9x6:30 (inner corners, square in mm), "
                  "charuco:5x7:40:20:DICT_6X6_250 or two-plane-24")
        ->required();
    c->add_option("--model", o.model, "brown or tsai")
        ->capture_default_str()
        ->check(CLI::IsMember({"brown", "tsai"}));
    c->add_option("--sensor", o.sensor, "dx,dy,Ncx,Nfx (for tsai)");
    c->add_option("--baseline", o.baseline, "Baseline measured by tape: MM,SIGMA");
    c->add_option("--medium", o.medium, "Where the pictures were taken: air or water")
        ->capture_default_str()
        ->check(CLI::IsMember({"air", "water"}));
    c->add_option("--expected", o.expected,
                  "Rig file to hold the result against: nominal, or an earlier calibration");
    c->add_flag("--estimate-target", o.estimate_target,
                "Let the target's corners move within their deviations");
    c->add_option("--out", o.out, "Rig file to write")->required();
    c->add_option("--report", o.report, "HTML report to write");
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_calibrate(o); }; });
}

void add_calibrate_points(CLI::App& app, Chosen& chosen, CalibratePointsOptions& o) {
    CLI::App* c = app.add_subcommand("calibrate-points",
                                     "Tsai's calibration from a list of points and their pixels");
    c->add_option("--points", o.points,
                  "Text file with lines: x y z X Y, or x y z XL YL XR YR for two cameras")
        ->required();
    c->add_option("--sensor", o.sensor,
                  "dx,dy,Ncx,Nfx: pixel pitch in mm, columns on the chip "
                  "and in the picture")
        ->required();
    c->add_option("--center", o.center, "Cx,Cy: the picture's centre, px")->required();
    c->add_option("--method", o.method, "basic (f, T_z, kappa1 refined) or full (everything)")
        ->capture_default_str()
        ->check(CLI::IsMember({"basic", "full"}));
    c->add_flag("--coplanar", o.coplanar, "The points are on one plane; s_x is taken as 1");
    c->add_option("--size", o.size, "W,H of the pictures, for the rig file");
    c->add_option("--out", o.out, "Rig file to write");
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_calibrate_points(o); }; });
}

void add_calibration_statistics(CLI::App& app, Chosen& chosen, CalibrationStatisticsOptions& o) {
    CLI::App* c = app.add_subcommand("calibration-statistics",
                                     "Mean, deviation and intervals of repeated calibrations");
    c->add_option("records", o.records, "CSV: environment,camera,record, then the parameters")
        ->required();
    c->add_option("--index-of-water", o.index_of_water, "For comparing air and water")
        ->capture_default_str()
        ->check(CLI::Range(1.0, 2.0));
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_calibration_statistics(o); }; });
}

void add_convert(CLI::App& app, Chosen& chosen, ConvertOptions& o) {
    CLI::App* c = app.add_subcommand("convert", "Rig files from and to other programs' formats");
    c->add_option("files", o.files,
                  "With --from: the other program's files; with --to: a rig file, then a folder")
        ->required();
    CLI::Option* from = c->add_option("--from", o.from, "opencv, ros, kalibr or kitti")
                            ->check(CLI::IsMember({"opencv", "ros", "kalibr", "kitti"}));
    CLI::Option* to = c->add_option("--to", o.to, "opencv, ros or kalibr")
                          ->excludes(from)
                          ->check(CLI::IsMember({"opencv", "ros", "kalibr"}));
    from->needs(c->add_option("--out", o.out, "Rig file to write (with --from)")->excludes(to));
    c->add_option("--size", o.size, "Picture size W,H where the files do not tell it");
    add_json(*c, chosen);
    c->callback([&, from, to] {
        if (from->count() + to->count() == 0) {
            throw CLI::RequiredError("--from or --to");
        }
        chosen.run = [&o] { return run_convert(o); };
    });
}

void add_detect(CLI::App& app, Chosen& chosen, DetectOptions& o) {
    CLI::App* c = app.add_subcommand("detect", "Find a calibration target in a picture");
    c->add_option("image", o.image, "The picture")->required();
    c->add_option("--target", o.target,
                  "A target file, chessboard:9x6:30 (inner corners, square in mm), "
                  "charuco:5x7:40:20:DICT_6X6_250 or two-plane-24")
        ->required();
    c->add_option("--stages", o.stages, "Folder for a picture of every stage");
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_detect(o); }; });
}

void add_match(CLI::App& app, Chosen& chosen, MatchOptions& o) {
    CLI::App* c = app.add_subcommand("match", "Find a template picture in another picture");
    c->add_option("image", o.image, "The picture")->required();
    c->add_option("template", o.templ, "The template picture")->required();
    c->add_option("--measure", o.measure, "sad, ncc, zncc or hamming")
        ->capture_default_str()
        ->check(CLI::IsMember(measure_words));
    c->add_option("--transform", o.transform, "none, gauss, rank3, rank5, census, sdog or gradient")
        ->capture_default_str()
        ->check(CLI::IsMember(transform_words));
    MatchSearchOptions& s = o.search;
    c->add_option("--search", s.strategy,
                  "full, window, sparse, window-sparse, epipolar or epipolar-sparse")
        ->capture_default_str();
    c->add_option("--near", s.near_px,
                  "X,Y: where the template's centre is expected; decides between equal scores");
    c->add_option("--radius", s.radius_px, "Of a window about --near, px (20)")
        ->check(CLI::Range(1, 100000));
    c->add_option("--step", s.step, "Sparse: every N-th pixel of every N-th row counts (2)")
        ->check(CLI::Range(1, 64));
    c->add_option("--rig", s.rig, "Epipolar: rig file; the picture is the right camera's");
    c->add_option("--left-point", s.left_point_px,
                  "Epipolar: X,Y in the left picture, about which the template was cut");
    c->add_option("--band", s.band_px, "Epipolar: so far beside the curve, px (2)")
        ->check(CLI::Range(0, 1000));
    c->add_option("--nearest-mm", s.nearest_mm, "Epipolar: least distance (250)")
        ->check(above_zero());
    c->add_option("--farthest-mm", s.farthest_mm, "Epipolar: largest distance (1e6)")
        ->check(above_zero());
    c->add_option("--map", o.map, "Write the scores as a 32-bit float TIFF");
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_match(o); }; });
}

void add_triangulate(CLI::App& app, Chosen& chosen, TriangulateOptions& o) {
    CLI::App* c = app.add_subcommand("triangulate", "Positions from pairs of pixels");
    c->add_option("--rig", o.rig, "Rig file")->required();
    c->add_option("--points", o.points, "Text file with lines: xl yl xr yr")->required();
    add_position_method(*c, o.method);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_triangulate(o); }; });
}

void add_simulate(CLI::App& app, Chosen& chosen, SimulateOptions& o) {
    CLI::App* c = app.add_subcommand("simulate", "Record the simulated rig, with its truth");
    c->add_option("--profile", o.profile,
                  "default, chessboard or two-plane-24, with ?key=value&...; for water colour=1, "
                  "water=clear, coastal or harbour, lamps=1, snow=N")
        ->capture_default_str();
    c->add_option("--seconds", o.seconds, "How long")->capture_default_str()->check(above_zero());
    c->add_option("--out", o.out, "Folder to make")->required();
    c->add_flag("--servo", o.servo, "Make the aim right by the pan-tilt camera's own picture");
    add_position_method(*c, o.position_method);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_simulate(o); }; });
}

void add_target(CLI::App& app, Chosen& chosen, TargetOptions& o) {
    CLI::App* c =
        app.add_subcommand("target", "Print a calibration target at its true size: a PDF");
    c->add_option("--target", o.target,
                  "A target file, two-plane-24, chessboard:9x6:30 (inner corners, square in mm) or "
                  "charuco:5x7:40:20:DICT_6X6_250")
        ->required();
    c->add_option("--paper", o.paper,
                  "A4, A3, A2, A1, A0, letter, legal or tabloid, turned as the target needs it; "
                  "auto: the smallest of A4 to A0 that takes it")
        ->capture_default_str();
    c->add_option("--out", o.out, "PDF file to write, a page a plane")->required();
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_target(o); }; });
}

void add_live(CLI::App& app, Chosen& chosen, LiveOptions& o) {
    CLI::App* c =
        app.add_subcommand("live", "The main job on the simulated rig, live in the terminal");
    c->add_option("--profile", o.profile, "Simulated scene")->capture_default_str();
    c->add_option("--pan-tilt", o.pan_tilt,
                  "A real head in place of the simulated one: visca:/dev/ttyS0 and so on");
    c->add_option("--seconds", o.seconds, "How long; until Ctrl-C where not given")
        ->check(above_zero());
    c->add_flag("--servo", o.servo,
                "Make the aim right by the simulated pan-tilt camera's own picture");
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_live(o); }; });
}

void add_heads(CLI::App& app, Chosen& chosen, PanTiltOptions& p, SimulateEviOptions& e) {
    CLI::App* c = add_pan_tilt(app, p);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&p] { return run_pan_tilt(p); }; });
    c = add_simulate_evi(app, e);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&e] { return run_simulate_evi(e); }; });
}

void add_experiments(CLI::App& app, Chosen& chosen, RangeTestOptions& r, LevelOptions& l,
                     CalibrateHeadOptions& h, CalibrateZoomOptions& z) {
    CLI::App* c = add_range_test(app, r);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&r] { return run_range_test(r); }; });
    c = add_level(app, l);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&l] { return run_level(l); }; });
    c = add_calibrate_head(app, h);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&h] { return run_calibrate_head(h); }; });
    c = add_calibrate_zoom(app, z);
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&z] { return run_calibrate_zoom(z); }; });
}

void add_compare(CLI::App& app, Chosen& chosen, CompareOptions& o) {
    CLI::App* c = app.add_subcommand(
        "compare-methods",
        "Every measure and transform side by side: robustness, accuracy, time. All six simulated "
        "scenes take about five minutes on two cores");
    c->add_option("--scenes", o.scenes,
                  "A list of air, clear, coastal, harbour, turbid-0.5, turbid-1.5 (attenuation per "
                  "m, with particles, steps of light, the background swapped), water (all but "
                  "air), all; all where no profile and no recording is given either");
    c->add_option("--profile", o.profiles, "More simulated scenes");
    c->add_option("--left", o.recording.left, "A recording's left pictures");
    c->add_option("--right", o.recording.right, "Its right pictures; with one camera none");
    c->add_option("--rig", o.recording.rig, "Its rig file; not needed with one camera");
    c->add_option("--template", o.templates,
                  "X,Y,W,H in the recording's first frame; given again: one more scene")
        ->check(a_rectangle(false))
        ->allow_extra_args(false);
    c->add_option("--truth", o.truth,
                  "Where the template's centre is: a table such as simulate writes");
    c->add_option("--start", o.recording.start, "Begin at this frame")->check(not_negative());
    c->add_option("--rate", o.recording.pictures_rate_hz,
                  "Single pictures a second, which carry no time themselves")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 1000.0));
    c->add_option("--seconds", o.seconds,
                  "Of each scene: 7 where it is simulated, and up to 600 frames of a recording")
        ->check(CLI::Range(0.1, 600.0));
    c->add_option("--template-size", o.template_px,
                  "Side of the square on the simulated target, px")
        ->capture_default_str()
        ->check(CLI::Range(9, 127));
    c->add_flag("--sparse", o.sparse,
                "Every method a second time with every 2nd pixel of every 2nd row; takes twice as "
                "long");
    c->add_option("--temporal", o.temporal,
                  "Filter the pictures over time first: median:N or mean:N, N up to 15");
    c->add_option("--report", o.report, "HTML file to write");
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_compare(o); }; });
}

void add_bench(CLI::App& app, Chosen& chosen, BenchOptions& o) {
    CLI::App* c = app.add_subcommand("bench", "Measure the speed, with OpenCV beside it");
    c->add_option("what", o.what, "correlation")
        ->capture_default_str()
        ->check(CLI::IsMember({"correlation"}));
    add_json(*c, chosen);
    c->callback([&] { chosen.run = [&o] { return run_bench(o); }; });
}

// The result for programs; a refusal says why, also where the command itself left it empty.
std::string json_of(const Outcome& outcome) {
    if (outcome.failure && outcome.json == Outcome{}.json) {
        return nlohmann::json{{"error", outcome.failure->text()}}.dump(2);
    }
    return outcome.json;
}

int finish(const Outcome& outcome, const std::string& json) {
    if (json == "-") {
        std::cout << json_of(outcome) << '\n';
    } else {
        std::cout << outcome.summary;
    }
    std::cout.flush();
    if (outcome.failure) {
        std::cerr << "kambara-cli: " << outcome.failure->text() << '\n';
    }
    if (!json.empty() && json != "-") {
        if (const auto written = write_text_file_atomically(json, json_of(outcome) + "\n");
            !written) {
            std::cerr << "kambara-cli: " << written.error().text() << '\n';
            return exit_failed;
        }
    }
    if (outcome.failure) {
        return outcome.wrong_usage ? exit_usage : exit_failed;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App app("Stereo vision for underwater vehicles: calibrate, track, position, point.",
                 "kambara-cli");
    app.require_subcommand(1);
    Chosen chosen;
    TrackOptions track;
    CalibrateOptions calibrate;
    CalibratePointsOptions calibrate_points;
    CalibrationStatisticsOptions calibration_statistics;
    ConvertOptions convert;
    DetectOptions detect;
    MatchOptions match;
    TriangulateOptions triangulate;
    SimulateOptions simulate;
    TargetOptions target;
    LiveOptions live;
    BenchOptions bench;
    CompareOptions compare;
    PanTiltOptions pan_tilt;
    SimulateEviOptions simulate_evi;
    RangeTestOptions range_test;
    LevelOptions level;
    CalibrateHeadOptions calibrate_head;
    CalibrateZoomOptions calibrate_zoom;
    add_calibrate(app, chosen, calibrate);
    add_calibrate_points(app, chosen, calibrate_points);
    add_calibration_statistics(app, chosen, calibration_statistics);
    add_track(app, chosen, track);
    add_triangulate(app, chosen, triangulate);
    add_detect(app, chosen, detect);
    add_match(app, chosen, match);
    add_convert(app, chosen, convert);
    add_simulate(app, chosen, simulate);
    add_target(app, chosen, target);
    add_live(app, chosen, live);
    add_bench(app, chosen, bench);
    add_compare(app, chosen, compare);
    add_heads(app, chosen, pan_tilt, simulate_evi);
    add_experiments(app, chosen, range_test, level, calibrate_head, calibrate_zoom);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error);
        return code == 0 ? 0 : exit_usage;
    }
    for (const CLI::App* command : app.get_subcommands()) {
        if (const std::string clash = clash_of_files(*command); !clash.empty()) {
            std::cerr << "kambara-cli: " << clash << '\n';
            return exit_usage;
        }
    }
    catch_interrupt();
    return finish(chosen.run(), chosen.json);
}
