// SPDX-License-Identifier: GPL-3.0-or-later
// PTZ-5: a moving target is followed over a line that loses, damages and delays, and is unplugged
// every 20 s. The time is the simulation's own, so that ten minutes take seconds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <vector>

#include "hardware/visca/head_driver.h"
#include "tests/hardware/visca/simulated_link.h"

namespace kambara::visca {
namespace {

constexpr double unplug_every_s = 20.0;
constexpr double unplug_for_s = 2.0;
constexpr double on_target_deg = 2.0;  // STR-1's bound

struct Outcome {
    int unplugs = 0;
    std::vector<double> returns_s;  // from the plug's return until on target
    double longest_astray_s = 0.0;  // away from the target at a stretch, with the plug in
    double on_target_share = 0.0;   // of the time with the plug in, but for a second after it
    std::map<std::string, int> notes;
    double status_error_deg = 0.0;  // worst, of what is said of the head
    int commands = 0;

    double longest_return_s() const {
        return returns_s.empty() ? 0.0 : *std::max_element(returns_s.begin(), returns_s.end());
    }
    double mean_return_s() const {
        const double sum = std::accumulate(returns_s.begin(), returns_s.end(), 0.0);
        return returns_s.empty() ? 0.0 : sum / static_cast<double>(returns_s.size());
    }
    int notes_with(const char* text) const {
        int count = 0;
        for (const auto& [note, times] : notes) {
            count += note.find(text) != std::string::npos ? times : 0;
        }
        return count;
    }
};

// The target goes to and fro by 30 degrees; up to 9.4 degrees a second.
HeadAngles target_at(double time_s) {
    const double phase = 2.0 * std::numbers::pi * time_s / unplug_every_s;
    return {rad_from_deg(30.0 * std::sin(phase + 1.0)), rad_from_deg(8.0 * std::sin(2.0 * phase))};
}

Outcome follow(double seconds, LineFaults faults, bool device_vanishes) {
    ManualClock clock(123'456'789);
    const std::int64_t start_ns = clock.now_ns();
    SimulatedLine line(start_ns, faults);
    SimulatedLink link(clock, line);
    link.device_vanishes = device_vanishes;
    HeadQueue queue;
    HeadDriver::Options options;
    options.heads = built_in_heads();
    options.session.byte_ns = byte_time_ns(9600);
    HeadDriver driver(link, queue, clock, options);

    Outcome outcome;
    bool was_plugged = true;
    double returned_s = 0.0;
    bool returns = false;
    double astray_since_s = 0.0;
    double last_s = 0.0;
    double next_aim_s = 0.0;
    double counted_s = 0.0;
    double on_target_s = 0.0;
    while (last_s < seconds) {
        driver.step();
        const double now_s = static_cast<double>(clock.now_ns() - start_ns) * 1e-9;
        if (now_s >= next_aim_s) {
            queue.put(Motion{Motion::Kind::look, target_at(now_s)});
            next_aim_s += 1.0 / 30.0;
        }
        for (const HeadNote& note : driver.take_notes()) {
            ++outcome.notes[note.text];
        }
        const bool plugged = line.plugged(clock.now_ns());
        const auto state = line.camera.state();
        const double off_deg =
            std::hypot(state.pan_steps / 8.8 - deg_from_rad(target_at(now_s).pan_rad),
                       state.tilt_steps / 12.0 - deg_from_rad(target_at(now_s).tilt_rad));
        if (plugged != was_plugged) {
            outcome.unplugs += plugged ? 0 : 1;
            returned_s = now_s;
            returns = plugged;
            was_plugged = plugged;
        }
        if (!plugged || off_deg < on_target_deg) {
            astray_since_s = now_s;
        }
        if (returns && off_deg < on_target_deg) {
            outcome.returns_s.push_back(now_s - returned_s);
            returns = false;
        }
        if (plugged && now_s > returned_s + 1.0) {
            outcome.longest_astray_s = std::max(outcome.longest_astray_s, now_s - astray_since_s);
            counted_s += now_s - last_s;
            on_target_s += off_deg < on_target_deg ? now_s - last_s : 0.0;
            if (const auto status = driver.status()) {
                outcome.status_error_deg = std::max(
                    outcome.status_error_deg,
                    std::abs(deg_from_rad(status->angles.pan_rad) - state.pan_steps / 8.8));
            }
        }
        last_s = now_s;
    }
    outcome.on_target_share = on_target_s / counted_s;
    outcome.commands = static_cast<int>(link.sent.size());
    return outcome;
}

LineFaults bad_line(std::uint64_t seed) {
    LineFaults faults;
    faults.lost_bytes = 0.01;
    faults.late_packets = 0.01;
    faults.unplug_every_s = unplug_every_s;
    faults.unplug_for_s = unplug_for_s;
    faults.seed = seed;
    return faults;
}

void expect_good(const Outcome& outcome, double seconds, bool device_vanishes) {
    const int unplugs = static_cast<int>(seconds / unplug_every_s);
    EXPECT_EQ(outcome.unplugs, unplugs);
    EXPECT_GE(static_cast<int>(outcome.returns_s.size()), unplugs - 1) << "stuck";
    EXPECT_LE(outcome.longest_return_s(), 1.0);
    EXPECT_LE(outcome.longest_astray_s, 2.0) << "stuck";
    EXPECT_GE(outcome.on_target_share, 0.8);
    // Each unplugging and each return is in the log, and what went wrong in between.
    EXPECT_EQ(outcome.notes_with("does not answer") + outcome.notes_with("was lost") >= unplugs - 1,
              true);
    if (device_vanishes) {
        EXPECT_EQ(outcome.notes_with("The line was lost."), unplugs);
        EXPECT_GE(outcome.notes_with("is there again"), unplugs - 1);
    }
    EXPECT_GE(outcome.notes_with("The head answers"), unplugs);
    EXPECT_GT(outcome.notes_with("No reply"), 0);
    EXPECT_GT(outcome.notes_with("made no sense"), 0);
}

void print(const char* what, const Outcome& outcome) {
    std::printf(
        "%s: %d unplugs, back within %.2f s (mean %.2f), astray %.2f s at most, on target "
        "%.1f %%, %d "
        "packets sent, status within %.1f deg\n",
        what, outcome.unplugs, outcome.longest_return_s(), outcome.mean_return_s(),
        outcome.longest_astray_s, 100.0 * outcome.on_target_share, outcome.commands,
        outcome.status_error_deg);
}

TEST(ViscaFaults, AMinuteOnABadLine) {
    for (const bool vanishes : {true, false}) {
        const Outcome outcome = follow(60.0, bad_line(1), vanishes);
        expect_good(outcome, 60.0, vanishes);
        print(vanishes ? "device vanishes" : "line goes silent", outcome);
    }
}

TEST(ViscaFaultsSlow, TenMinutesOnBadLines) {
    std::size_t returns = 0;
    double longest_s = 0.0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        for (const bool vanishes : {true, false}) {
            SCOPED_TRACE(testing::Message() << "seed " << seed << " vanishes " << vanishes);
            const Outcome outcome = follow(600.0, bad_line(seed), vanishes);
            expect_good(outcome, 600.0, vanishes);
            print(vanishes ? "device vanishes" : "line goes silent", outcome);
            returns += outcome.returns_s.size();
            longest_s = std::max(longest_s, outcome.longest_return_s());
        }
    }
    EXPECT_GE(returns, 500U);
    std::printf("%zu returns of the plug, back on target within %.2f s each time\n", returns,
                longest_s);
}

TEST(ViscaFaults, UnplugsAloneCostNoMoreThanASecond) {
    LineFaults faults;
    faults.unplug_every_s = unplug_every_s;
    faults.unplug_for_s = unplug_for_s;
    for (const bool vanishes : {true, false}) {
        const Outcome outcome = follow(600.0, faults, vanishes);
        EXPECT_GE(outcome.returns_s.size(), 29U);
        EXPECT_LE(outcome.longest_return_s(), 1.0);
        EXPECT_GE(outcome.on_target_share, 0.999);
        print(vanishes ? "device vanishes" : "line goes silent", outcome);
    }
}

TEST(ViscaFaults, AGoodLineHasNothingToTell) {
    const Outcome outcome = follow(60.0, {}, true);
    EXPECT_EQ(outcome.notes.size(), 1U);
    EXPECT_EQ(outcome.notes_with("The head answers."), 1);
    EXPECT_GE(outcome.on_target_share, 0.999);
    EXPECT_LT(outcome.status_error_deg, 1.5);
    print("good line", outcome);
}

TEST(ViscaFaults, GarbageAndDoubledBytesDoNoLastingHarm) {
    LineFaults faults;
    faults.garbled_bytes = 0.003;
    faults.doubled_bytes = 0.003;
    const Outcome outcome = follow(120.0, faults, true);
    EXPECT_LE(outcome.longest_astray_s, 2.0);
    EXPECT_GE(outcome.on_target_share, 0.8);
    print("garbled", outcome);
}

}  // namespace
}  // namespace kambara::visca
