// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/track_state.h"

#include <array>
#include <utility>

namespace kambara {
namespace {

constexpr std::array<std::pair<TrackState, std::string_view>, 5> names{{
    {TrackState::idle, "Idle"},
    {TrackState::template_set, "TemplateSet"},
    {TrackState::tracking, "Tracking"},
    {TrackState::doubtful, "Doubtful"},
    {TrackState::lost, "Lost"},
}};

}  // namespace

std::string to_string(TrackState state) {
    for (const auto& [value, name] : names) {
        if (value == state) {
            return std::string(name);
        }
    }
    return "Idle";
}

std::optional<TrackState> track_state_from(std::string_view wanted) {
    for (const auto& [value, name] : names) {
        if (name == wanted) {
            return value;
        }
    }
    return std::nullopt;
}

}  // namespace kambara
