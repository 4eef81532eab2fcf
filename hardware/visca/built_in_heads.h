// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace kambara::visca {

/// The text of resources/heads/visca.yaml as it was when the program was built.
const char* built_in_heads_text();

}  // namespace kambara::visca
