// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_run.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <limits>

#include "core/base/median.h"
#include "core/tracking/stereo_tracker.h"

namespace kambara::cli {
namespace {

constexpr std::size_t timed_pairs = 21;  // while Tracking
constexpr std::size_t tried_pairs = 30;

TrackerOptions options_with(const MatchMethod& method) {
    TrackerOptions options;
    options.search.method = method;
    return options;
}

std::optional<Sighting> sighting_of(const TrackEstimate& estimate) {
    if (estimate.state != TrackState::tracking || !estimate.left_px) {
        return std::nullopt;
    }
    Sighting sighting{*estimate.left_px, estimate.right_px, std::nullopt};
    if (estimate.position) {
        sighting.range_mm = estimate.position->point_in_left_mm.norm();
    }
    return sighting;
}

Result<Done> begin(StereoTracker& tracker, const StereoFrame& pair, const Rectangle& templ) {
    const auto chosen = tracker.set_template(pair, templ);
    return chosen ? tracker.start() : chosen;
}

// The template as it is seen in another frame: at a pixel, grown.
Rectangle seen_as(const Rectangle& templ, const Eigen::Vector2d& centre_px, double scale) {
    Rectangle seen;
    seen.width = static_cast<int>(std::lround(scale * templ.width));
    seen.height = static_cast<int>(std::lround(scale * templ.height));
    seen.x = static_cast<int>(std::lround(centre_px.x() - 0.5 * (seen.width - 1)));
    seen.y = static_cast<int>(std::lround(centre_px.y() - 0.5 * (seen.height - 1)));
    return seen;
}

// From the last frame in which a template can be cut where the target was seen, back to the first.
void follow_back(const CompareScene& scene, const std::vector<double>& scales, CompareRun& run) {
    run.seen_back.resize(run.seen.size());
    for (std::size_t from = run.seen.size(); from-- > 0;) {
        if (!run.seen[from]) {
            continue;
        }
        const Eigen::Vector2d& centre_px = run.seen[from]->left_px;
        const Rectangle templ = seen_as(scene.templ, centre_px, scales[from]);
        StereoTracker tracker(scene.rig, options_with(run.method));
        if (!begin(tracker, scene.pairs[from], templ)) {
            continue;
        }
        // A template lies on whole pixels: what that moves it by is taken back.
        const Eigen::Vector2d off_px =
            centre_px - Eigen::Vector2d(templ.centre_x_px(), templ.centre_y_px());
        for (std::size_t i = from + 1; i-- > 0;) {
            StereoFrame pair = scene.pairs[i];
            for (Frame* frame : {&pair.left, &pair.right}) {  // time runs on
                frame->time_ns = 2 * scene.pairs[from].left.time_ns - frame->time_ns;
            }
            run.seen_back[i] = sighting_of(tracker.process(pair));
            if (run.seen_back[i]) {
                run.seen_back[i]->left_px += off_px;
                if (run.seen_back[i]->right_px) {
                    *run.seen_back[i]->right_px += off_px;
                }
            }
        }
        return;
    }
}

}  // namespace

std::vector<MatchMethod> all_methods() {
    std::vector<MatchMethod> methods;
    for (const char* transform :
         {"none", "gauss", "gradient", "rank3", "rank5", "sdog", "census"}) {
        for (const char* measure : {"zncc", "ncc", "sad", "hamming"}) {
            if (const auto method = parse_method(measure, transform)) {
                methods.push_back(*method);
            }
        }
    }
    return methods;
}

MatchMethod default_method() {
    return TrackerOptions{}.search.method;
}

std::string label_of(const MatchMethod& method) {
    if (method == default_method()) {
        return to_string(method.measure) + ", smoothed where dim";
    }
    const std::string after =
        method.transform == Transform::none ? "" : " after " + to_string(method.transform);
    const std::string sparse = method.step == 1   ? ""
                               : method.step == 2 ? ", every 2nd px"
                                                  : ", step " + std::to_string(method.step);
    return to_string(method.measure) + after + sparse;
}

CompareRun run_method(const CompareScene& scene, const MatchMethod& method) {
    CompareRun run;
    run.method = method;
    run.ms_median = std::numeric_limits<double>::quiet_NaN();
    run.seen.resize(scene.pairs.size());
    StereoTracker tracker(scene.rig, options_with(method));
    if (const auto begun = begin(tracker, scene.pairs.front(), scene.templ); !begun) {
        run.refused = begun.error();
        return run;
    }
    std::vector<double> scales;
    for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
        const TrackEstimate estimate = tracker.process(scene.pairs[i]);
        run.seen[i] = sighting_of(estimate);
        run.best_left_px.push_back(estimate.left_px);
        scales.push_back(estimate.scale);
    }
    if (!scene.has_truth()) {
        follow_back(scene, scales, run);
    }
    return run;
}

double time_of_method_ms(const CompareScene& scene, const MatchMethod& method) {
    std::vector<double> spent_ms;
    StereoTracker tracker(scene.rig, options_with(method));
    if (begin(tracker, scene.pairs.front(), scene.templ)) {
        const std::size_t end = std::min(tried_pairs, scene.pairs.size());
        for (std::size_t i = 0; i < end && spent_ms.size() < timed_pairs; ++i) {
            const std::clock_t start = std::clock();
            const TrackEstimate estimate = tracker.process(scene.pairs[i]);
            const auto spent = static_cast<double>(std::clock() - start);
            if (estimate.state == TrackState::tracking) {
                spent_ms.push_back(1e3 * spent / CLOCKS_PER_SEC);
            }
        }
    }
    if (spent_ms.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return median(std::move(spent_ms));
}

}  // namespace kambara::cli
