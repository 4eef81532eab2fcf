// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/result.h"

namespace kambara::visca {

/// A pseudo-terminal under a name of one's own: what opens the name has a serial line to whoever
/// holds this. It is raw from the beginning, and the name goes away with it.
class PseudoTerminal {
  public:
    /// Refuses a name under which there is anything but a link.
    static Result<PseudoTerminal> open(const std::string& name);
    ~PseudoTerminal();
    PseudoTerminal(PseudoTerminal&& other) noexcept;
    PseudoTerminal& operator=(PseudoTerminal&&) = delete;

    /// Our end. Whoever takes it has to close it.
    int take_descriptor();

  private:
    PseudoTerminal(std::string name, int ours, int theirs)
        : name_(std::move(name)), ours_(ours), theirs_(theirs) {}
    std::string name_;
    int ours_ = -1;
    int theirs_ = -1;  // held, so that our end does not fail while nobody has it open
};

}  // namespace kambara::visca
