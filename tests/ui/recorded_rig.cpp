// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/recorded_rig.h"

#include <unistd.h>

#include <opencv2/core/mat.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/camera/rig_file.h"
#include "hardware/media/picture_file.h"

namespace kambara::testing_support {
namespace {

namespace fs = std::filesystem;

fs::path fresh_place() {
    static int count = 0;
    const fs::path folder =
        fs::temp_directory_path() /
        ("kambara_recorded_" + std::to_string(getpid()) + "_" + std::to_string(count++));
    fs::remove_all(folder);
    fs::create_directories(folder / "left");
    fs::create_directories(folder / "right");
    return folder;
}

void require(bool done, const char* what) {
    if (!done) {
        throw std::runtime_error(what);
    }
}

}  // namespace

RecordedRig::RecordedRig(fs::path folder) : folder_(std::move(folder)) {}

RecordedRig::RecordedRig(RecordedRig&& other) noexcept
    : folder_(std::exchange(other.folder_, {})), request_(std::move(other.request_)) {}

RecordedRig::~RecordedRig() {
    if (!folder_.empty()) {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
}

RecordedRig RecordedRig::as_pictures(const SimulatedProfile& profile, int frames, int vanishes_at) {
    RecordedRig recorded(fresh_place());
    const SimulatedWorld world(profile);
    SimulatedProfile other = profile;
    other.seed = profile.seed + 1000;
    const SimulatedWorld elsewhere(other);
    for (int i = 0; i < frames; ++i) {
        const SimulatedWorld& seen = i < vanishes_at ? world : elsewhere;
        const std::string name = std::to_string(10000 + i) + ".png";
        for (const auto& [camera, side] :
             {std::pair{FixedCamera::left, "left"}, {FixedCamera::right, "right"}}) {
            require(write_picture(recorded.folder_ / side / name, seen.picture(camera, i)).ok(),
                    "a picture can't be written");
        }
    }
    require(write_rig_file(recorded.folder_ / "rig.yaml", world.rig()).ok(),
            "the rig file can't be written");
    recorded.request_ = {recorded.folder_ / "left/*.png", recorded.folder_ / "right/*.png",
                         recorded.folder_ / "rig.yaml", profile.rate_hz};
    return recorded;
}

RecordedRig RecordedRig::as_videos(const SimulatedProfile& profile, int frames) {
    RecordedRig recorded(fresh_place());
    const SimulatedWorld world(profile);
    for (const auto& [camera, name] :
         {std::pair{FixedCamera::left, "left.avi"}, {FixedCamera::right, "right.avi"}}) {
        cv::VideoWriter writer;
        for (int i = 0; i < frames; ++i) {
            Image picture = grey_from(world.picture(camera, i));
            if (i == 0) {
                writer.open(recorded.folder_ / name, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'),
                            profile.rate_hz, {picture.width(), picture.height()}, false);
                require(writer.isOpened(), "a video can't be written");
                writer.set(cv::VIDEOWRITER_PROP_QUALITY, 95);
            }
            writer.write(cv::Mat(picture.height(), picture.width(), CV_8UC1, picture.row(0)));
        }
    }
    require(write_rig_file(recorded.folder_ / "rig.yaml", world.rig()).ok(),
            "the rig file can't be written");
    recorded.request_ = {recorded.folder_ / "left.avi", recorded.folder_ / "right.avi",
                         recorded.folder_ / "rig.yaml", profile.rate_hz};
    return recorded;
}

}  // namespace kambara::testing_support
