// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/base/result.h"

namespace kambara {

/// Refuses files that would be paired wrongly because one side lacks a picture: where the last
/// number in a left file's name stands in another place on the right. Sides that are numbered apart
/// by always the same, by times that differ, or not at all, are taken as they are.
Result<Done> check_pairs(const std::vector<std::filesystem::path>& left,
                         const std::vector<std::filesystem::path>& right);

}  // namespace kambara
