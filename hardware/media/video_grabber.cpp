// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/video_grabber.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <mutex>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/videoio.hpp>
#include <utility>

#include "core/image/opencv_view.h"
#include "hardware/media/video_container.h"

namespace kambara {

struct VideoGrabber::Video {
    cv::VideoCapture capture;
    VideoContainer container;
    std::int64_t announced_frames = 0;  // 0 where the container does not say
};

namespace {

// The decoders behind OpenCV would write on the terminal what is told as an Error here. They read
// this setting once, when the first video is opened.
void quieten_decoders() {
    static std::once_flag once;
    std::call_once(once, [] {
        setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", /*overwrite=*/0);
        cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    });
}

}  // namespace

VideoGrabber::VideoGrabber(std::unique_ptr<Video> video, GrabberInfo info)
    : video_(std::move(video)), info_(std::move(info)) {}

VideoGrabber::~VideoGrabber() = default;

Result<std::unique_ptr<GrabberBase>> VideoGrabber::open(const std::string& file,
                                                        const MediaOptions& options) {
    std::error_code code;
    if (!std::filesystem::exists(file, code)) {
        return Error{"There is no file " + file + ".", "Check the name and the folder."};
    }
    if (std::filesystem::is_directory(file, code)) {
        return Error{file + " is a folder.", "Name its pictures, for example " + file + "/*.png."};
    }
    quieten_decoders();
    auto video = std::make_unique<Video>();
    video->container = video_container(file);
    bool opened = false;
    try {
        opened = video->capture.open(file, cv::CAP_FFMPEG);
    } catch (const cv::Exception&) {
        // Told below: what can't be opened can't be opened.
    }
    GrabberInfo info;
    if (opened) {
        const auto property = [&](int which) { return video->capture.get(which); };
        info = {file, static_cast<int>(property(cv::CAP_PROP_FRAME_WIDTH)),
                static_cast<int>(property(cv::CAP_PROP_FRAME_HEIGHT)), property(cv::CAP_PROP_FPS),
                false};
        const double count = property(cv::CAP_PROP_FRAME_COUNT);
        video->announced_frames = count > 0.0 && count < 1e9 ? std::llround(count) : 0;
        if (!(info.rate_hz > 0.0) || info.rate_hz > 10000.0) {
            info.rate_hz = 30.0;
        }
        info.frames = video->announced_frames > 0 ? video->announced_frames : -1;
    }
    if (!opened || info.width_px <= 0 || info.height_px <= 0) {
        return Error{file +
                         " can't be read as a video: it is damaged, cut short or of another "
                         "kind.",
                     "Check that it plays elsewhere, or give pictures instead."};
    }
    std::unique_ptr<VideoGrabber> grabber(new VideoGrabber(std::move(video), std::move(info)));
    if (const auto there = grabber->skip_to(options.start); !there) {
        return there.error();
    }
    return std::unique_ptr<GrabberBase>(std::move(grabber));
}

// Seeking lands on key frames in some containers; reading and throwing away is exact.
Result<Done> VideoGrabber::skip_to(std::int64_t index) {
    while (next_ < index) {
        if (!video_->capture.grab()) {
            return Error{"Frame " + std::to_string(index) + " does not exist: " + info_.name +
                             " ends after " + std::to_string(next_) + " frames.",
                         "Start earlier."};
        }
        ++next_;
    }
    return Done{};
}

Result<Done> VideoGrabber::seek(std::int64_t index) {
    if (index < 0 || (info_.frames >= 0 && index >= info_.frames)) {
        return Error{"There is no frame " + std::to_string(index) + " in " + info_.name + ".",
                     "Give a number from 0 to " + std::to_string(info_.frames - 1) + "."};
    }
    if (index >= next_ && !failed_) {
        return skip_to(index);
    }
    auto anew = open(info_.name, {.start = index});
    if (!anew) {
        return anew.error();
    }
    auto& other = static_cast<VideoGrabber&>(**anew);
    video_ = std::move(other.video_);
    next_ = other.next_;
    failed_.reset();
    return Done{};
}

Result<std::optional<Frame>> VideoGrabber::grab(std::stop_token stop) {
    if (failed_) {
        return *failed_;
    }
    if (stop.stop_requested()) {
        return std::optional<Frame>();
    }
    cv::Mat pixels;
    bool read = false;
    try {
        read = video_->capture.read(pixels) && !pixels.empty();
    } catch (const cv::Exception&) {
        // The same as a frame that could not be read.
    }
    if (!read) {
        const bool count_binds = video_->container.counts_frames || video_->container.cut_short;
        if (next_ >= video_->announced_frames || !count_binds) {
            return std::optional<Frame>();
        }
        failed_ = Error{"The video " + info_.name + " is cut short: it announces " +
                            std::to_string(video_->announced_frames) + " frames, but only " +
                            std::to_string(next_) + " can be read.",
                        "Copy it again from where it was recorded, or cut it at that frame."};
        return *failed_;
    }
    if (pixels.cols != info_.width_px || pixels.rows != info_.height_px ||
        (pixels.type() != CV_8UC1 && pixels.type() != CV_8UC3)) {
        failed_ = Error{"Frame " + std::to_string(next_) + " of " + info_.name +
                            " has another size or kind than the first.",
                        "Convert the video to one size."};
        return *failed_;
    }
    Frame frame;
    frame.picture = std::make_shared<const Image>(image_from_opencv(pixels));
    frame.index = next_;
    frame.sequence = static_cast<std::uint32_t>(next_);
    frame.time_ns = static_cast<std::int64_t>(static_cast<double>(next_) * 1e9 / info_.rate_hz);
    ++next_;
    return std::optional<Frame>(std::move(frame));
}

}  // namespace kambara
