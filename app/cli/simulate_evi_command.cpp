// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/simulate_evi_command.h"

#include <chrono>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/terminal.h"
#include "core/base/clock.h"

namespace kambara::cli {
namespace {

constexpr std::chrono::milliseconds look_interval{50};

}  // namespace

Outcome run_simulate_evi(const SimulateEviOptions& options) {
    if (options.server.pty.empty() && !options.server.udp_port && !options.server.tcp_port) {
        Outcome outcome{Error{"It is not said where the simulated camera is to be reached.",
                              "Give --pty NAME, --udp PORT or --tcp PORT, or several."}};
        outcome.wrong_usage = true;
        return outcome;
    }
    SteadyClock clock;
    auto server = visca::EviServer::open(options.server, clock);
    if (!server) {
        return Outcome{server.error()};
    }
    nlohmann::json places = nlohmann::json::array();
    for (const std::string& place : (*server)->places()) {
        std::printf("A simulated EVI-D30 answers %s.\n", place.c_str());
        places.push_back(place);
    }
    std::puts("Ctrl-C ends it.");
    std::fflush(stdout);
    const auto report = [](const std::string& line) {
        std::puts(line.c_str());
        std::fflush(stdout);
    };
    const auto started = std::chrono::steady_clock::now();
    {
        std::jthread serving(
            [&](const std::stop_token& stop) { (*server)->run(stop, report, options.packets); });
        while (!interrupted()) {
            std::this_thread::sleep_for(look_interval);
            const std::chrono::duration<double> so_far = std::chrono::steady_clock::now() - started;
            if (options.seconds && so_far.count() >= *options.seconds) {
                break;
            }
        }
    }
    return Outcome{std::nullopt, nlohmann::json{{"places", places}}.dump(2)};
}

}  // namespace kambara::cli
