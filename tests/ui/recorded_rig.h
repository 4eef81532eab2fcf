// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "hardware/simulated/simulated_world.h"
#include "ui/shell/system_link.h"

namespace kambara::testing_support {

/// A recording of the simulated rig in a folder of its own, removed with the object.
class RecordedRig {
  public:
    /// Numbered pictures; from frame `vanishes_at` on the target is not there: the pictures are
    /// those of another seabed.
    static RecordedRig as_pictures(const SimulatedProfile& profile, int frames, int vanishes_at);
    /// Motion-JPEG videos.
    static RecordedRig as_videos(const SimulatedProfile& profile, int frames);
    ~RecordedRig();
    RecordedRig(RecordedRig&& other) noexcept;
    RecordedRig& operator=(RecordedRig&&) = delete;
    RecordedRig(const RecordedRig&) = delete;
    RecordedRig& operator=(const RecordedRig&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    const ui::SourceRequest& request() const { return request_; }

  private:
    explicit RecordedRig(std::filesystem::path folder);

    std::filesystem::path folder_;
    ui::SourceRequest request_;
};

}  // namespace kambara::testing_support
