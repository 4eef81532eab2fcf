// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <sstream>
#include <utility>

#include "app/cli/compare_truth.h"
#include "core/matching/texture.h"
#include "hardware/simulated/simulated_world.h"

namespace kambara::cli {
namespace {

Frame frame_of(ImagePtr picture, std::int64_t index, std::int64_t time_ns) {
    Frame frame;
    frame.picture = std::move(picture);
    frame.index = index;
    frame.time_ns = time_ns;
    return frame;
}

// The last parts of a source's name, which tell recordings apart: sea/left/%06d.png.
std::string short_name(const std::string& source) {
    const std::filesystem::path path(source);
    const auto folder = path.parent_path();
    return (folder.parent_path().filename() / folder.filename() / path.filename()).string();
}

bool lasts_beyond(const std::optional<double>& seconds, std::int64_t first_ns,
                  std::int64_t time_ns) {
    return seconds && static_cast<double>(time_ns - first_ns) >= *seconds * 1e9;
}

// The next pair in grey; empty at the recording's end.
Result<std::optional<StereoFrame>> next_pair(VisionSystemParts& parts) {
    StereoFrame pair;
    for (auto [grabber, frame] : {std::pair(parts.grabbers.left.get(), &pair.left),
                                  std::pair(parts.grabbers.right.get(), &pair.right)}) {
        if (grabber == nullptr) {
            continue;
        }
        auto taken = grabber->grab({});
        if (!taken) {
            return taken.error();
        }
        if (!*taken) {
            return std::optional<StereoFrame>();
        }
        *frame = std::move(**taken);
        frame->picture = grey_from(frame->picture);
    }
    return std::optional(std::move(pair));
}

Result<CompareScene> pictures_of(const RecordedOptions& options) {
    SteadyClock clock;
    auto sources = open_sources(options.source, clock);
    if (!sources) {
        return sources.error();
    }
    CompareScene scene;
    scene.what = options.source.left;
    scene.rig = sources->parts.rig;
    if (options.source.right.empty()) {
        scene.rig.right.reset();
    } else if (!scene.rig.right) {
        return Error{"The rig file knows one camera only, and there are right pictures.",
                     "Give a rig file with two cameras, or leave --right out."};
    }
    while (scene.pairs.size() < most_recorded_frames) {
        auto pair = next_pair(sources->parts);
        if (!pair) {
            return pair.error();
        }
        if (!*pair ||
            (!scene.pairs.empty() && lasts_beyond(options.seconds, scene.pairs.front().left.time_ns,
                                                  (*pair)->left.time_ns))) {
            break;
        }
        scene.pairs.push_back(std::move(**pair));
    }
    if (scene.pairs.size() < 2) {
        return Error{"The recording has fewer than two pictures to follow a target through.",
                     "Check the patterns, --start and --seconds."};
    }
    const Image& first = *scene.pairs.front().left.picture;
    if (first.width() != scene.rig.left.width_px || first.height() != scene.rig.left.height_px) {
        return Error{"The pictures are not of the size that the rig file says.",
                     "Give the rig file that belongs to them."};
    }
    return scene;
}

}  // namespace

bool CompareScene::has_truth() const {
    return std::any_of(truth.begin(), truth.end(), [](const auto& place) { return !!place; });
}

const std::vector<NamedScene>& named_scenes() {
    static const std::vector<NamedScene> scenes{
        {"air", "default?seed=1&haze=0&particles=0"},
        {"clear", "default?seed=1&water=clear"},
        {"coastal", "default?seed=1&water=coastal"},
        {"harbour", "default?seed=1&water=harbour"},
        {"turbid-0.5",
         "default?seed=1&medium=water&haze=0.5&blur=0.3&particles=200&step=0.4&swap=2"},
        {"turbid-1.5",
         "default?seed=1&medium=water&haze=1.5&blur=0.3&particles=200&step=0.4&swap=2"},
    };
    return scenes;
}

Result<std::vector<NamedScene>> parse_scenes(const std::string& list) {
    std::vector<NamedScene> chosen;
    std::istringstream words(list);
    std::string known;
    for (const NamedScene& scene : named_scenes()) {
        known += std::string(scene.name) + ", ";
    }
    for (std::string word; std::getline(words, word, ',');) {
        const auto before = chosen.size();
        for (const NamedScene& scene : named_scenes()) {
            const bool meant = word == "all" || word == scene.name ||
                               (word == "water" && std::string(scene.name) != "air");
            const bool again = std::any_of(chosen.begin(), chosen.end(), [&](const auto& other) {
                return std::string(other.name) == scene.name;
            });
            if (meant && !again) {
                chosen.push_back(scene);
            }
        }
        if (chosen.size() == before) {
            return Error{"There is no scene '" + word + "', or it was named before.",
                         "Give a list of " + known + "water, all."};
        }
    }
    if (chosen.empty()) {
        return Error{"No scene was named.", "Give a list of " + known + "water, all."};
    }
    return chosen;
}

Result<CompareScene> simulated_scene(const std::string& name, const std::string& profile_text,
                                     double seconds, int template_px, WorkerPool& pool) {
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
    scene.name = name;
    scene.what = profile_text;
    scene.rig = world.rig();
    scene.templ = world.suggested_template(template_px);
    scene.simulated = true;
    scene.disturbed = profile->step > 0.0 && profile->swap_s > 0.0 &&
                      (profile->particles > 0 || profile->snow_per_litre > 0.0);
    const auto on_target =
        world.target_point_under({scene.templ.centre_x_px(), scene.templ.centre_y_px()}, 0);
    const auto wanted =
        static_cast<std::size_t>(std::max(2.0, std::round(seconds * profile->rate_hz)));
    const std::size_t frames =
        profile->frames < 0 ? wanted : std::min(wanted, static_cast<std::size_t>(profile->frames));
    scene.pairs.resize(frames);
    pool.for_each(frames, [&](std::size_t i) {
        const auto index = static_cast<std::int64_t>(i);
        for (auto [camera, frame] : {std::pair(FixedCamera::left, &scene.pairs[i].left),
                                     std::pair(FixedCamera::right, &scene.pairs[i].right)}) {
            auto picture = std::make_shared<const Image>(grey_from(world.picture(camera, index)));
            *frame = frame_of(std::move(picture), index, world.time_ns(index));
        }
    });
    for (std::size_t i = 0; i < frames; ++i) {
        const Eigen::Vector3d point =
            world.point_in_left_mm(*on_target, static_cast<std::int64_t>(i));
        scene.truth.push_back(sighting_of(scene.rig, point));
        scene.attenuation_lengths.push_back(profile->haze_per_m * point.norm() * 1e-3);
    }
    return scene;
}

Result<std::vector<CompareScene>> recorded_scenes(const RecordedOptions& options,
                                                  const std::vector<std::string>& templates) {
    if (templates.empty()) {
        return Error{"It is not said which target of the recording to follow.",
                     "Give --template X,Y,W,H, a rectangle in its first frame."};
    }
    std::vector<Rectangle> rectangles;
    for (const std::string& templ : templates) {
        const auto rectangle = parse_rectangle(templ);
        if (!rectangle) {
            return rectangle.error();
        }
        rectangles.push_back(*rectangle);
    }
    const auto recording = pictures_of(options);
    if (!recording) {
        return recording.error();
    }
    std::vector<CompareScene> scenes(rectangles.size(), *recording);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        scenes[i].templ = rectangles[i];
        scenes[i].name = short_name(scenes[i].what) + " at " + to_string(rectangles[i]);
        scenes[i].truth.resize(scenes[i].pairs.size());
        if (!options.truth.empty()) {
            if (const auto read = read_truth(options.truth, scenes[i]); !read) {
                return read.error();
            }
        }
        const Frame& first = scenes[i].pairs.front().left;
        if (auto fits = check_template(*grey_from(first.picture), rectangles[i]); !fits) {
            return fits.error();
        }
    }
    return scenes;
}

void low_pass(CompareScene& scene, const TemporalOptions& options) {
    TemporalFilter left(options);
    TemporalFilter right(options);
    for (StereoFrame& pair : scene.pairs) {
        for (auto [frame, filter] :
             {std::pair(&pair.left, &left), std::pair(&pair.right, &right)}) {
            if (frame->picture) {
                frame->picture =
                    std::make_shared<const Image>(filter->filter(*grey_from(frame->picture)));
            }
        }
    }
    scene.name += ", " + to_string(options);
}

}  // namespace kambara::cli
