// SPDX-License-Identifier: GPL-3.0-or-later
// The time that a calibration takes from pictures to rig: three cameras and forty views of the
// 24-box target, rendered at 640 x 480 (the rendering is not counted). Prints the detector's time
// a picture on one thread, then the whole on all cores against the bound of 10 s on two.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include "core/calibration/target_detector.h"
#include "core/camera/nominal_rig.h"
#include "tests/core/calibration/rig_samples.h"
#include "tests/support/detected_views.h"

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

}  // namespace

int main() {
    using namespace kambara;
    constexpr int views = 40;
    const Rig truth = nominal_rig();
    const auto shown = testing_support::shown_targets(truth, views, 7);

    std::vector<double> times_ms;
    int found = 0;
    for (const auto& one : shown) {
        for (const Image& picture : one.pictures) {
            const auto start = Clock::now();
            found += detect_target(picture, two_plane_24()) ? 1 : 0;
            times_ms.push_back(1000.0 * seconds_since(start));
        }
    }
    std::sort(times_ms.begin(), times_ms.end());
    std::printf("%d of %zu pictures hold a target that is found\n", found, times_ms.size());
    std::printf("detection, one thread: median %.1f ms, nine in ten %.1f ms, longest %.1f ms\n",
                times_ms[times_ms.size() / 2], times_ms[times_ms.size() * 9 / 10], times_ms.back());

    const auto start = Clock::now();
    const auto seen = testing_support::detected_views(shown, two_plane_24());
    const double detection_s = seconds_since(start);
    const auto report = calibrate_rig(seen, two_plane_24(), testing_support::options_for(truth));
    const double all_s = seconds_since(start);
    std::printf("%d views by 3 cameras on %u cores: detection %.2f s, solution %.2f s, %s\n", views,
                std::thread::hardware_concurrency(), detection_s, all_s - detection_s,
                to_string(report.verdict).c_str());
    std::printf("together %.2f s (bound: 10 s on 2 cores)\n", all_s);
    return all_s < 10.0 && report.verdict != Verdict::refused ? 0 : 1;
}
