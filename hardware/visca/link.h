// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/base/clock.h"
#include "core/base/result.h"
#include "hardware/visca/head_uri.h"
#include "hardware/visca/packet.h"

namespace kambara::visca {

/// The way to a camera and back: bytes, or datagrams. Used by one thread, but for `wake`. It can be
/// opened again after it was closed or failed.
class Link {
  public:
    virtual ~Link() = default;

    virtual std::string name() const = 0;
    /// An error says why it can't be opened now (not plugged in, no permission, nobody listens).
    virtual Result<Done> open() = 0;
    virtual void close() = 0;
    /// Takes a packet or datagram and does not wait until it is out. An error: the link is lost.
    virtual Result<Done> send(const Bytes& packet) = 0;
    /// Waits until something came, or `wake`, or the clock's time; pieces of a stream, or a
    /// datagram each. Closed, it only waits. An error: the link is lost.
    virtual Result<std::vector<Bytes>> receive(std::int64_t until_ns) = 0;
    /// From any thread: a `receive` under way, or else the next one, returns at once.
    virtual void wake() = 0;
};

/// The link that the URI names, not yet open. `clock` outlives it.
std::unique_ptr<Link> make_link(const HeadUri& uri, const Clock& clock);

}  // namespace kambara::visca
