// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "hardware/visca/message.h"

namespace kambara::visca {

/// A message's bytes as a text of tokens, one for each byte or group of bytes:
///   06         this byte
///   [02,03]    a byte with one of these values, or ranges [01-18]: a value
///   2[2-7]     this upper half, and a lower half with one of these values: a value
///   u2, u4     so many bytes 0n, the upper half of the number first: a value
///   s4         likewise, in two's complement
///   pan, tilt  likewise; pan has as many bytes as the dialect says
///   w          two whole bytes: a value
///   refresh    the dialect's code of the MD refresh time
struct MessageRow {
    Op op;
    const char* name;
    const char* pattern;
    bool d30 = true;
    const char* answer = nullptr;  ///< of inquiries
};

/// All rows, in the order of Op.
std::span<const MessageRow> message_table();

}  // namespace kambara::visca
