// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/now.h"

#include <ctime>

namespace kambara::cli {

const char* const program_name = "kambara-cli " KAMBARA_VERSION;

std::string now_iso8601() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

}  // namespace kambara::cli
