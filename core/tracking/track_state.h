// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace kambara {

/// The life of a template (correspondence: template life cycle).
enum class TrackState { idle, template_set, tracking, doubtful, lost };

std::string to_string(TrackState state);  ///< Idle, TemplateSet, Tracking, Doubtful, Lost
std::optional<TrackState> track_state_from(std::string_view name);

}  // namespace kambara
