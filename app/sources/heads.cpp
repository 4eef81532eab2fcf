// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/sources/heads.h"

#include "hardware/visca/evi_camera.h"
#include "hardware/visca/head_uri.h"

namespace kambara {

bool names_a_real_head(const std::string& name) {
    return visca::names_a_visca_head(name);
}

Result<std::shared_ptr<PanTiltCamera>> open_head(const std::string& name, const Clock& clock) {
    if (!names_a_real_head(name)) {
        return Error{"There is no driver for the pan-tilt head " + name + ".",
                     "Name one as visca:/dev/ttyS0 or visca-udp:HOST."};
    }
    auto camera = visca::open_evi_camera(name, clock);
    if (!camera) {
        return camera.error();
    }
    return std::shared_ptr<PanTiltCamera>(std::move(*camera));
}

}  // namespace kambara
