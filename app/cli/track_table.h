// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/geometry/rigid_transform.h"
#include "core/vsystem/snapshot.h"

namespace kambara::cli {

/// The rows that `track` writes, one a frame (resources/README.md: track table). Positions are of
/// the point that was the template's centre, in the frame that the transform leads to: the left
/// camera's where it is left out. The sigmas are what the pictures' noise makes of them, and apart
/// from that what the calibration does. What is not known is left empty.
std::string track_table_header();
/// Of the steered target.
std::string track_table_row(const Snapshot& snapshot, const RigidTransform& T_frame_from_left = {});

/// Likewise with several targets: a row for each, with its number in one more column.
std::string targets_table_header();
std::string targets_table_rows(const Snapshot& snapshot,
                               const RigidTransform& T_frame_from_left = {});

}  // namespace kambara::cli
