// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/media/picture_grabber.h"

#include <utility>

#include "hardware/media/picture_file.h"

namespace kambara {

Result<std::unique_ptr<GrabberBase>> PictureGrabber::open(const std::string& pattern,
                                                          const MediaOptions& options) {
    auto files = files_of_pattern(pattern);
    if (!files) {
        return files.error();
    }
    const auto count = static_cast<std::int64_t>(files->size());
    if (options.start >= count) {
        return Error{"Frame " + std::to_string(options.start) + " does not exist: " + pattern +
                         " has " + std::to_string(count) + " pictures.",
                     "Start at a frame from 0 to " + std::to_string(count - 1) + "."};
    }
    const auto first = read_picture(files->front());
    if (!first) {
        return first.error();
    }
    GrabberInfo info{pattern, first->width(), first->height(), options.pictures_rate_hz,
                     false,   count};
    return std::unique_ptr<GrabberBase>(
        new PictureGrabber(std::move(*files), std::move(info), options.start));
}

Result<std::optional<Frame>> PictureGrabber::grab(std::stop_token stop) {
    if (failed_) {
        return *failed_;
    }
    if (stop.stop_requested() || next_ >= static_cast<std::int64_t>(files_.size())) {
        return std::optional<Frame>();
    }
    const auto& file = files_[static_cast<std::size_t>(next_)];
    auto picture = read_picture(file);
    if (!picture) {
        failed_ = picture.error();
        return *failed_;
    }
    if (picture->width() != info_.width_px || picture->height() != info_.height_px) {
        failed_ = Error{file.string() + " has " + std::to_string(picture->width()) + " x " +
                            std::to_string(picture->height()) + " pixels, the pictures before it " +
                            std::to_string(info_.width_px) + " x " +
                            std::to_string(info_.height_px) + ".",
                        "Keep pictures of one size in a sequence, or leave this one out."};
        return *failed_;
    }
    Frame frame;
    frame.picture = std::make_shared<const Image>(std::move(*picture));
    frame.index = next_;
    frame.sequence = static_cast<std::uint32_t>(next_);
    frame.time_ns = static_cast<std::int64_t>(static_cast<double>(next_) * 1e9 / info_.rate_hz);
    ++next_;
    return std::optional<Frame>(std::move(frame));
}

Result<Done> PictureGrabber::seek(std::int64_t index) {
    if (index < 0 || index >= info_.frames) {
        return Error{"There is no frame " + std::to_string(index) + " in " + info_.name + ".",
                     "Give a number from 0 to " + std::to_string(info_.frames - 1) + "."};
    }
    next_ = index;
    failed_.reset();
    return Done{};
}

}  // namespace kambara
