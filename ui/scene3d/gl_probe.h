// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kambara::ui {

/// Tries whether windows can draw with OpenGL 3.2 or newer here. Needs the application object; on
/// its thread only.
bool can_draw_with_gl();

/// Sets up the kind of window the 3-D view needs. Before the application object is made.
void prepare_for_gl();

}  // namespace kambara::ui
