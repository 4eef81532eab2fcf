// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "app/cli/compare_score.h"

namespace kambara::cli {

/// The same results for programs, for the terminal, and as a page with plots. `shipped` is the
/// method that they are held against.
nlohmann::json compare_json(const std::vector<SceneResult>& results, const MatchMethod& shipped);
std::string compare_tables(const std::vector<SceneResult>& results, const MatchMethod& shipped);
std::string compare_html(const std::vector<SceneResult>& results, const MatchMethod& shipped);

}  // namespace kambara::cli
