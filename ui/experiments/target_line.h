// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/vsystem/snapshot.h"

class QLabel;

namespace kambara::ui {

/// Tells how it stands with the tracked target, and what to do where there is none. True where its
/// position is known for sure.
bool show_target(QLabel& label, const Snapshot& snapshot);

}  // namespace kambara::ui
