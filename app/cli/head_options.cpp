// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/head_options.h"

#include "app/cli/argument_checks.h"

#include <CLI/CLI.hpp>

namespace kambara::cli {

CLI::App* add_pan_tilt(CLI::App& app, PanTiltOptions& o) {
    CLI::App* c = app.add_subcommand("pan-tilt", "Drive a pan-tilt head by hand");
    c->add_option("--device", o.device,
                  "visca:/dev/ttyS0?address=1, visca-udp:HOST:PORT, visca-udp-raw:HOST:PORT or "
                  "visca-tcp:HOST:PORT")
        ->required();
    c->add_option(
         "action", o.action,
         "position; move PAN,TILT (degrees); drive PAN,TILT (degrees a second, the nearest that "
         "the head has); halt; "
         "home; reset; zoom SHARE (0 wide to 1 tele); focus SHARE (0 far to 1 near) or "
         "auto; keep N; recall N")
        ->capture_default_str();
    c->add_option("value", o.value, "What the action needs");
    c->add_option(
         "--seconds", o.seconds,
         "Of a drive: halt after so long. Without it the head turns on to its end, or until "
         "halt")
        ->check(above_zero());
    return c;
}

CLI::App* add_simulate_evi(CLI::App& app, SimulateEviOptions& o) {
    CLI::App* c = app.add_subcommand("simulate-evi", "An EVI-D30 for any VISCA client");
    visca::EviServerOptions& s = o.server;
    c->add_option("--pty", s.pty, "A name to give to a pseudo-terminal, such as /tmp/evi");
    c->add_option("--udp", s.udp_port, "UDP port, with Sony's header or without (52381, 1259)")
        ->check(CLI::Range(0, 65535));
    c->add_option("--tcp", s.tcp_port, "TCP port (5678)")->check(CLI::Range(0, 65535));
    c->add_flag("--everywhere", s.everywhere, "For other machines, too");
    c->add_option("--baud", s.baud, "Of the pseudo-terminal's line; 0 for as fast as it goes")
        ->capture_default_str()
        ->check(CLI::Range(0, 115200));
    c->add_flag("--pal", s.camera.pal, "50 fields a second instead of 60");
    c->add_flag("--packets", o.packets, "Tell every packet");
    c->add_option("--seconds", o.seconds, "How long; until Ctrl-C where not given")
        ->check(above_zero());
    visca::LineFaults& f = s.faults;
    const auto share = [&](const char* name, double& where, const char* what) {
        c->add_option(name, where, what)->check(CLI::Range(0.0, 1.0));
    };
    share("--lose", f.lost_bytes, "This share of the bytes is lost (0.01 for 1 %)");
    share("--double", f.doubled_bytes, "This share of the bytes comes twice");
    share("--garble", f.garbled_bytes, "In this share of the bytes a bit is turned over");
    share("--late", f.late_packets, "This share of the packets is late (not over UDP)");
    c->add_option("--late-by", f.late_s, "By so many seconds")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 60.0));
    c->add_option("--unplug-every", f.unplug_every_s, "The plug is pulled every so many seconds")
        ->check(above_zero());
    c->add_option("--unplug-for", f.unplug_for_s, "And put in again after so many")
        ->capture_default_str()
        ->check(above_zero());
    c->add_flag("--power", s.power_goes_too, "Its power is gone as long");
    c->add_option("--seed", f.seed, "Of the faults")->capture_default_str();
    return c;
}

}  // namespace kambara::cli
