// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "core/tracking/stereo_tracker.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara::cli {
namespace {

constexpr double right_within = 0.01;  // of range
constexpr std::size_t least_voices = 3;

Frame frame_of(ImagePtr picture, std::int64_t index, std::int64_t time_ns) {
    Frame frame;
    frame.picture = std::move(picture);
    frame.index = index;
    frame.time_ns = time_ns;
    return frame;
}

double median_of(std::vector<double> values) {
    if (values.empty()) {
        return 0.0;
    }
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

Result<CompareScene> simulated_scene(const std::string& profile_text, int frames, int template_px) {
    const auto profile = simulated_profile(profile_text);
    if (!profile) {
        return profile.error();
    }
    if (profile->calibration_target) {
        return Error{"The profile " + profile_text + " shows no target to follow.",
                     "Use default, with any of its keys."};
    }
    const SimulatedWorld world(*profile);
    CompareScene scene;
    scene.name = profile_text;
    scene.rig = world.rig();
    scene.templ = world.suggested_template(template_px);
    const auto on_target =
        world.target_point_under({scene.templ.centre_x_px(), scene.templ.centre_y_px()}, 0);
    for (int i = 0; i < frames; ++i) {
        StereoFrame pair;
        for (auto [camera, frame] : {std::pair(FixedCamera::left, &pair.left),
                                     std::pair(FixedCamera::right, &pair.right)}) {
            auto picture = std::make_shared<const Image>(grey_from(world.picture(camera, i)));
            *frame = frame_of(std::move(picture), i, world.time_ns(i));
        }
        scene.pairs.push_back(std::move(pair));
        const Eigen::Vector3d truth = world.point_in_left_mm(*on_target, i);
        scene.truth_in_left_mm.emplace_back(truth);
        scene.attenuation_lengths_most =
            std::max(scene.attenuation_lengths_most, profile->haze_per_m * truth.norm() * 1e-3);
    }
    return scene;
}

Result<CompareScene> recorded_scene(const CompareOptions& options) {
    if (options.templ.empty()) {
        return Error{"It is not said which target of the recording to follow.",
                     "Give --template X,Y,W,H, a rectangle in its first frame."};
    }
    const auto rectangle = parse_rectangle(options.templ);
    if (!rectangle) {
        return rectangle.error();
    }
    SteadyClock clock;
    auto sources = open_sources(options.recording, clock);
    if (!sources) {
        return sources.error();
    }
    CompareScene scene;
    scene.name = options.recording.left;
    scene.rig = sources->parts.rig;
    scene.templ = *rectangle;
    if (!scene.rig.right || !sources->parts.grabbers.right) {
        return Error{"Methods are compared on stereo pictures.",
                     "Give --right and a rig file with two cameras."};
    }
    for (int i = 0; i < options.frames; ++i) {
        StereoFrame pair;
        bool over = false;
        for (auto [grabber, frame] :
             {std::pair(sources->parts.grabbers.left.get(), &pair.left),
              std::pair(sources->parts.grabbers.right.get(), &pair.right)}) {
            auto taken = grabber->grab({});
            if (!taken) {
                return taken.error();
            }
            over = over || !*taken;
            if (*taken) {
                *frame = std::move(**taken);
                frame->picture = grey_from(frame->picture);
            }
        }
        if (over) {
            break;
        }
        scene.pairs.push_back(std::move(pair));
    }
    if (scene.pairs.empty()) {
        return Error{"The recording has no pairs of pictures.", "Check the two patterns."};
    }
    const Image& first = *scene.pairs.front().left.picture;
    if (first.width() != scene.rig.left.width_px || first.height() != scene.rig.left.height_px) {
        return Error{"The pictures are not of the size that the rig file says.",
                     "Give the rig file that belongs to them."};
    }
    scene.truth_in_left_mm.resize(scene.pairs.size());
    return scene;
}

void low_pass(CompareScene& scene, const TemporalOptions& options) {
    TemporalFilter left(options);
    TemporalFilter right(options);
    for (StereoFrame& pair : scene.pairs) {
        for (auto [frame, filter] :
             {std::pair(&pair.left, &left), std::pair(&pair.right, &right)}) {
            frame->picture =
                std::make_shared<const Image>(filter->filter(*grey_from(frame->picture)));
        }
    }
    scene.name += ", " + to_string(options);
}

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

CompareRun run_method(const CompareScene& scene, const MatchMethod& method) {
    CompareRun run;
    run.method = method;
    run.tracked_in_left_mm.resize(scene.pairs.size());
    TrackerOptions options;
    options.search.method = method;
    StereoTracker tracker(scene.rig, options);
    const auto chosen = tracker.set_template(scene.pairs.front(), scene.templ);
    const auto started = chosen ? tracker.start() : chosen;
    if (!started) {
        run.refused = started.error();
        return run;
    }
    std::vector<double> spent_ms;
    for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
        const auto start = std::chrono::steady_clock::now();
        const TrackEstimate estimate = tracker.process(scene.pairs[i]);
        const std::chrono::duration<double, std::milli> spent =
            std::chrono::steady_clock::now() - start;
        spent_ms.push_back(spent.count());
        if (estimate.state == TrackState::tracking && estimate.position) {
            run.tracked_in_left_mm[i] = estimate.position->point_in_left_mm;
        }
    }
    run.ms_median = median_of(spent_ms);
    return run;
}

std::vector<std::optional<Eigen::Vector3d>> reference_of(const CompareScene& scene,
                                                         const std::vector<CompareRun>& runs) {
    auto reference = scene.truth_in_left_mm;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (reference[i]) {
            continue;
        }
        std::vector<double> said[3];
        for (const CompareRun& run : runs) {
            for (int k = 0; k < 3 && run.tracked_in_left_mm[i]; ++k) {
                said[k].push_back((*run.tracked_in_left_mm[i])[k]);
            }
        }
        if (said[0].size() >= least_voices) {
            reference[i] =
                Eigen::Vector3d(median_of(said[0]), median_of(said[1]), median_of(said[2]));
        }
    }
    return reference;
}

CompareScore score_of(const CompareRun& run,
                      const std::vector<std::optional<Eigen::Vector3d>>& reference) {
    CompareScore score;
    double frames = 0.0;
    double errors_pct = 0.0;
    double right = 0.0;
    double wrong = 0.0;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (!reference[i]) {
            continue;
        }
        frames += 1.0;
        if (!run.tracked_in_left_mm[i]) {
            continue;
        }
        const double error =
            (*run.tracked_in_left_mm[i] - *reference[i]).norm() / reference[i]->norm();
        if (error <= right_within) {
            right += 1.0;
            errors_pct += 100.0 * error;
        } else {
            wrong += 1.0;
        }
    }
    score.right = frames > 0.0 ? right / frames : 0.0;
    score.wrong = frames > 0.0 ? wrong / frames : 0.0;
    score.error_mean_pct =
        right > 0.0 ? errors_pct / right : std::numeric_limits<double>::quiet_NaN();
    return score;
}

}  // namespace kambara::cli
