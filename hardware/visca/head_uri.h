// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "hardware/visca/session.h"

namespace kambara::visca {

/// Where a head is and how to speak to it:
///   visca:/dev/ttyS0?address=1&baud=9600
///   visca-udp:HOST:PORT     with Sony's header; port 52381 where none is given
///   visca-udp-raw:HOST:PORT without; 1259
///   visca-tcp:HOST:PORT     5678
/// and after ? any of address=1..7, baud=, model=NAME, heads=FILE (a table in place of the built-in
/// one), sequence=any (a camera that counts wrongly), timeout=MS (80 unless given).
struct HeadUri {
    std::string text;
    Wiring wiring = Wiring::serial;
    std::string device;  ///< of a serial line
    std::string host;
    int port = 0;
    int baud = 9600;
    int address = 1;
    std::string model;  ///< empty: by the version inquiry
    std::string heads;
    bool checks_sequence = true;
    int timeout_ms = 80;
};

/// True for what begins as such a URI does.
bool names_a_visca_head(std::string_view text);
Result<HeadUri> parse_head_uri(std::string_view text);

}  // namespace kambara::visca
