// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "core/devices/pan_tilt_camera.h"

namespace kambara {

/// True where a head's name means a device, not a simulation.
bool names_a_real_head(const std::string& name);

/// Opens a real head by its URI: visca:/dev/ttyS0?address=1, visca-udp:HOST:PORT,
/// visca-udp-raw:HOST:PORT or visca-tcp:HOST:PORT (hardware/visca/head_uri.h). Waits until it
/// answers, two seconds at most. `clock` outlives it.
Result<std::shared_ptr<PanTiltCamera>> open_head(const std::string& name, const Clock& clock);

}  // namespace kambara
