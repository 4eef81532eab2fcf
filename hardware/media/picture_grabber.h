// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/devices/grabber_base.h"
#include "hardware/media/open_media.h"

namespace kambara {

/// Single pictures, one after the other, as a source. Frame 0 is the first file.
class PictureGrabber final : public GrabberBase {
  public:
    static Result<std::unique_ptr<GrabberBase>> open(const std::string& pattern,
                                                     const MediaOptions& options);

    Result<std::optional<Frame>> grab(std::stop_token stop) override;
    GrabberInfo info() const override { return info_; }
    Result<Done> seek(std::int64_t index) override;

  private:
    PictureGrabber(std::vector<std::filesystem::path> files, GrabberInfo info, std::int64_t start)
        : files_(std::move(files)), info_(std::move(info)), next_(start) {}

    const std::vector<std::filesystem::path> files_;
    const GrabberInfo info_;
    std::int64_t next_;
    std::optional<Error> failed_;
};

}  // namespace kambara
