// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace kambara {

/// True where the bytes begin as a JPEG or PNG but never reach its end marker. JPEG decoders fill
/// what is missing with grey and call it read, so it must be found beforehand. Other formats:
/// false, their decoders refuse by themselves. (Structure: ITU-T T.81 annex B; PNG specification.)
bool is_cut_short(std::string_view bytes);

}  // namespace kambara
