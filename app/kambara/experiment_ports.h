// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/experiments/experiment_ports.h"

namespace kambara {

/// The tables and pages of the experiments are those of the command line.
ui::ExperimentPorts experiment_ports();

}  // namespace kambara
