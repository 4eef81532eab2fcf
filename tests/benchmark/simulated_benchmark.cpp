// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <cstdint>

#include "hardware/simulated/simulated_profile.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara {
namespace {

// The counter is the share of one core that the work takes when repeated at the profile's rate.
void report_core_share(benchmark::State& state, const SimulatedWorld& world) {
    state.counters["core_pct_at_rate"] = benchmark::Counter(
        0.01 / world.profile().rate_hz,
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// Left and right pictures of one instant, as the simulated grabbers draw them.
void stereo_pictures(benchmark::State& state, const char* profile) {
    const SimulatedWorld world(simulated_profile(profile).value());
    world.picture(FixedCamera::left, 0);  // the seabed is drawn once, before the clock runs
    world.picture(FixedCamera::right, 0);
    std::int64_t frame = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(world.picture(FixedCamera::left, frame));
        benchmark::DoNotOptimize(world.picture(FixedCamera::right, frame));
        ++frame;
    }
    report_core_share(state, world);
}
BENCHMARK_CAPTURE(stereo_pictures, moving_target, "default")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stereo_pictures, in_water, "default?medium=water")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stereo_pictures, grey_coastal, "default?water=coastal")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stereo_pictures, colour, "default?colour=1")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stereo_pictures, colour_clear, "default?colour=1&water=clear")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stereo_pictures, colour_coastal, "default?colour=1&water=coastal")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stereo_pictures, colour_harbour_lamps, "default?colour=1&water=harbour&lamps=1")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(stereo_pictures, chessboard, "chessboard")->Unit(benchmark::kMillisecond);

// The pan-tilt camera's picture: the whole of it is cast anew.
void pan_tilt_picture(benchmark::State& state, const char* profile) {
    const SimulatedWorld world(simulated_profile(profile).value());
    std::int64_t frame = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(world.pan_tilt_picture(frame, HeadAngles{0.1, 0.05}));
        ++frame;
    }
    report_core_share(state, world);
}
BENCHMARK_CAPTURE(pan_tilt_picture, grey, "default")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(pan_tilt_picture, colour_coastal_lamps, "default?colour=1&water=coastal&lamps=1")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace kambara
