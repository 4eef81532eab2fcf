// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/devices/grabber_base.h"
#include "hardware/media/open_media.h"

namespace kambara {

/// A video file as a source, decoded by OpenCV's videoio.
class VideoGrabber final : public GrabberBase {
  public:
    static Result<std::unique_ptr<GrabberBase>> open(const std::string& file,
                                                     const MediaOptions& options);
    ~VideoGrabber() override;

    Result<std::optional<Frame>> grab(std::stop_token stop) override;
    GrabberInfo info() const override { return info_; }
    /// Backwards it reads the video anew from its beginning: exact, but not fast.
    Result<Done> seek(std::int64_t index) override;

  private:
    struct Video;
    VideoGrabber(std::unique_ptr<Video> video, GrabberInfo info);

    Result<Done> skip_to(std::int64_t index);

    std::unique_ptr<Video> video_;
    const GrabberInfo info_;
    std::int64_t next_ = 0;
    std::optional<Error> failed_;
};

}  // namespace kambara
