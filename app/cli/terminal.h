// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace kambara::cli {

/// True where standard error (or output) is a terminal that a person looks at.
bool error_is_terminal();
bool output_is_terminal();

/// Ctrl-C ends a long job in good order: after this, it only sets a flag.
void catch_interrupt();
bool interrupted();

/// A line on standard error that is written over as work goes on; silent where that is no
/// terminal. Ends with a cleared line.
class ProgressLine {
  public:
    ProgressLine();
    ~ProgressLine();
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    /// A bar for a share in [0, 1] where the end is known, and a text.
    void show(double share, const std::string& text);
    /// Without a known end.
    void show(const std::string& text);

  private:
    bool shown_ = false;
    std::int64_t last_ns_ = 0;
};

}  // namespace kambara::cli
