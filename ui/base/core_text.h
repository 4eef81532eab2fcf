// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

#include "core/base/error.h"
#include "core/tracking/track_state.h"

namespace kambara::ui {

/// What core says, in the window's language. Core speaks English and knows no translation; phrases
/// that are known here are translated with their numbers and names kept, any other stays as it is.
QString translated(const std::string& text);
QString translated(const Error& error);  ///< cause and remedy
QString name_of(TrackState state);

}  // namespace kambara::ui
