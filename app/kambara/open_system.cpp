// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/open_system.h"

#include <memory>

#include "app/sources/heads.h"
#include "app/sources/sources.h"

namespace kambara {

ui::SystemOpener system_opener(Clock& clock, const std::string& pan_tilt) {
    return
        [&clock, pan_tilt, head = std::shared_ptr<PanTiltCamera>()](
            const ui::SourceRequest& request) mutable -> Result<std::unique_ptr<VsystemInterface>> {
            SourceOptions options;
            if (!pan_tilt.empty() && !head) {
                auto opened = open_head(pan_tilt, clock);
                if (!opened) {
                    return opened.error();
                }
                head = std::move(*opened);
            }
            options.head = head;
            options.left = request.left;
            options.right = request.right;
            options.rig = request.rig;
            options.pictures_rate_hz = request.pictures_rate_hz;
            options.live = true;
            options.pan_tilt_pictures = true;
            auto sources = open_sources(options, clock);
            if (!sources) {
                return sources.error();
            }
            VisionSystemOptions system_options;
            system_options.every_frame = sources->every_frame;
            system_options.in_real_time = sources->every_frame;
            system_options.start_paused = sources->every_frame;
            return open_vision_system(std::move(sources->parts), system_options, clock);
        };
}

}  // namespace kambara
