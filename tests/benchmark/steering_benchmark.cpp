// SPDX-License-Identifier: GPL-3.0-or-later
// What steering adds to a pair's time in the pipeline: the same pairs by turns through a pipeline
// with a head and one without; with the head's axes through its optical centre, and with a head
// model, whose angles are found by iteration. Told are the medians' difference of the pipeline
// thread's own computing time, and the quickest tenth's of the time that passed: on a busy machine,
// what else runs takes the processor away whenever the head's thread is woken. Ends with 1 where
// the computing is more than 0.1 ms.
#include <time.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <memory>
#include <vector>

#include "core/image/frame.h"
#include "core/vsystem/pipeline.h"
#include "hardware/simulated/simulated_head.h"
#include "hardware/simulated/simulated_profile.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

constexpr int frames = 30;
constexpr int rounds = 2000;
constexpr double most_ms = 0.1;

StereoFrame drawn(const SimulatedWorld& world, int frame) {
    StereoFrame pair;
    pair.left.picture = std::make_shared<const Image>(world.picture(FixedCamera::left, frame));
    pair.right.picture = std::make_shared<const Image>(world.picture(FixedCamera::right, frame));
    return pair;
}

// There and back again, so that nothing leaps.
ImageSet set_at(const SimulatedWorld& world, const std::vector<StereoFrame>& recording,
                std::int64_t round, std::int64_t now_ns) {
    const std::int64_t step = round % (2 * frames - 2);
    const std::int64_t shown = step < frames ? step : 2 * frames - 2 - step;
    ImageSet set;
    set.stereo = recording[static_cast<std::size_t>(shown)];
    for (Frame* frame : {&set.stereo.left, &set.stereo.right}) {
        frame->index = round;
        frame->time_ns = world.time_ns(round);
    }
    set.arrived_ns = now_ns;
    return set;
}

double quantile(std::vector<double> values, double share) {
    const auto place = values.begin() +
                       static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

double own_ms() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double added_ms(const SimulatedWorld& world, const std::vector<StereoFrame>& recording,
                const Rig& rig, const char* what) {
    SteadyClock clock;
    int told = 0;
    VisionSystemOptions options;
    options.threads = 1;  // so that all computing is this thread's
    const auto make = [&](bool steers) {
        std::shared_ptr<PanTiltCamera> head;
        if (steers) {
            head =
                std::make_shared<SimulatedHead>(std::shared_ptr<const Clock>(&clock, [](auto*) {}));
        }
        auto pipeline = std::make_unique<Pipeline>(
            rig, head, nullptr, options, clock,
            [&told](const SnapshotPtr& snapshot) {
                told += snapshot->head && snapshot->head->commanded ? 1 : 0;
            },
            [](const Event&) {});
        pipeline->process(set_at(world, recording, 0, clock.now_ns()), 0);
        (void)pipeline->select({world.suggested_template(31), std::nullopt, 1});
        (void)pipeline->start({});
        return pipeline;
    };
    const std::unique_ptr<Pipeline> pipelines[] = {make(false), make(true)};
    std::vector<double> computing_ms[2];
    std::vector<double> passed_ms[2];
    for (int round = 1; round <= rounds; ++round) {
        // Who comes first takes turns: it finds the pictures less warm.
        for (int turn = 0; turn < 2; ++turn) {
            const int which = (round + turn) % 2;
            const auto started = std::chrono::steady_clock::now();
            const double own_before_ms = own_ms();
            pipelines[which]->process(set_at(world, recording, round, clock.now_ns()), 0);
            const std::chrono::duration<double, std::milli> took =
                std::chrono::steady_clock::now() - started;
            computing_ms[which].push_back(own_ms() - own_before_ms);
            passed_ms[which].push_back(took.count());
        }
    }
    const double without = quantile(computing_ms[0], 0.5);
    const double with = quantile(computing_ms[1], 0.5);
    const double passed_without = quantile(passed_ms[0], 0.1);
    const double passed_with = quantile(passed_ms[1], 0.1);
    std::printf(
        "%s: computing %.3f ms a pair without steering, %.3f with: %.3f ms added; passed, "
        "quickest tenth: %.3f and %.3f: %.3f added (%d snapshots with a command)\n",
        what, without, with, with - without, passed_without, passed_with,
        passed_with - passed_without, told);
    return with - without;
}

int run() {
    const SimulatedWorld world(simulated_profile("default").value());
    std::vector<StereoFrame> recording;
    for (int i = 0; i < frames; ++i) {
        recording.push_back(drawn(world, i));
    }
    Rig with_model = world.rig();
    HeadModel model;
    model.T_base_from_rig = with_model.pan_tilt->T_camera_from_rig;
    model.tilt_axis_ahead_mm = 40.0;
    model.T_camera_from_tilt.t_mm = {0.0, -15.0, -30.0};
    with_model.head = model;
    const double plain = added_ms(world, recording, world.rig(), "axes through the centre");
    const double arms = added_ms(world, recording, with_model, "head model with lever arms");
    return std::max(plain, arms) <= most_ms ? 0 : 1;
}

}  // namespace
}  // namespace kambara

int main() {
    return kambara::run();
}
