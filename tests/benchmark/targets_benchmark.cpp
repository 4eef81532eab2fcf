// SPDX-License-Identifier: GPL-3.0-or-later
// The time of one pair of the simulated rig's pictures with 1, 4 and 16 targets, on one thread and
// on as many as the machine has cores. The counter tells how many were in sight at the end.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <deque>
#include <memory>

#include "core/image/frame.h"
#include "core/vsystem/target_set.h"
#include "hardware/simulated/simulated_profile.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

constexpr int frames = 20;
constexpr int side_px = 31;

const SimulatedWorld& world() {
    static const SimulatedWorld made(simulated_profile("default").value());
    return made;
}

Frame drawn(FixedCamera camera, int frame) {
    Frame result;
    result.picture = std::make_shared<const Image>(world().picture(camera, frame));
    result.index = frame;
    result.time_ns = world().time_ns(frame);
    return result;
}

const std::deque<StereoFrame>& recording() {
    static const std::deque<StereoFrame> pairs = [] {
        std::deque<StereoFrame> made;
        for (int i = 0; i < frames; ++i) {
            made.push_back({drawn(FixedCamera::left, i), drawn(FixedCamera::right, i)});
        }
        return made;
    }();
    return pairs;
}

// The moving target, then pieces of the seabed before it.
void choose(TargetSet& targets, int count) {
    const StereoFrame& first = recording().front();
    (void)targets.set_template(1, first, world().suggested_template(side_px)).ok();
    for (int y = 340; y <= 420; y += 40) {
        for (int x = 60; x < 400; x += 50) {
            const int next = static_cast<int>(targets.all().size()) + 1;
            if (next <= count) {
                (void)targets.set_template(next, first, {x, y, side_px, side_px}).ok();
            }
        }
    }
}

// There and back again, so that nothing leaps.
StereoFrame pair_at(std::int64_t round) {
    const std::int64_t step = round % (2 * frames - 2);
    const std::int64_t shown = step < frames ? step : 2 * frames - 2 - step;
    StereoFrame pair = recording()[static_cast<std::size_t>(shown)];
    for (Frame* frame : {&pair.left, &pair.right}) {
        frame->index = round;
        frame->time_ns = world().time_ns(round);
    }
    return pair;
}

void one_pair(benchmark::State& state) {
    const int count = static_cast<int>(state.range(0));
    TargetSet targets(world().rig(), {}, static_cast<int>(state.range(1)));
    choose(targets, count);
    (void)targets.start(std::nullopt, {recording().front()}).ok();
    std::int64_t round = 0;
    for (auto _ : state) {
        targets.process(pair_at(++round));
    }
    int in_sight = 0;
    for (const FollowedTarget& target : targets.all()) {
        in_sight += target.tracker.estimate().state == TrackState::tracking ? 1 : 0;
    }
    state.counters["in_sight"] = in_sight;
}
BENCHMARK(one_pair)
    ->ArgNames({"targets", "threads"})  // 0: as many as the machine has cores
    ->ArgsProduct({{1, 4, 16}, {1, 0}})
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace kambara
