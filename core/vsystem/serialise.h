// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

namespace kambara {

/// Commands, replies, events and snapshots as JSON text on one line (resources/README.md: link
/// messages), so that the front end and the vehicle can sit on two machines. A snapshot goes
/// without its pictures' pixels; those are asked for apart. Reading gives back what was written,
/// and refuses anything else with the key at fault; any bytes are safe to pass.
std::string to_json(const Command& command);
std::string to_json(const Reply& reply);
std::string to_json(const Event& event);
std::string to_json(const Snapshot& snapshot);

Result<Command> command_from_json(std::string_view text);
Result<Reply> reply_from_json(std::string_view text);
Result<Event> event_from_json(std::string_view text);
Result<Snapshot> snapshot_from_json(std::string_view text);

}  // namespace kambara
