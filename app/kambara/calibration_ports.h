// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/calibration/calibration_ports.h"

namespace kambara {

/// Picture files by hardware/media, the report by the page that the command line writes.
ui::CalibrationPorts calibration_ports();

}  // namespace kambara
