// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "app/cli/outcome.h"

namespace kambara::cli {

struct BenchOptions {
    std::string what = "correlation";
};

/// The correlation engine beside OpenCV's matchTemplate in one process, single thread: the eight
/// rows of 1999's timing table (T11), then larger pictures and templates. Medians of interleaved
/// repetitions. JSON: vector_unit, kernel_peak_share, kernel_peak_share_bar,
/// rows[{name, image, template, ours_us, opencv_us, bar, most_us, met}]; bar is the ratio asked for
/// on this vector unit, most_us the time, absent where none is.
Outcome run_bench(const BenchOptions& options);

}  // namespace kambara::cli
