// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace kambara::cli {

/// One line of the benchmark: the same search by this program and by OpenCV.
struct BenchRow {
    std::string name;
    int width_px = 320;  ///< of the picture
    int height_px = 240;
    int template_width_px = 14;
    int template_height_px = 18;
    std::optional<double> rate_1999_hz;  ///< what 1999's table says, on a 300 MHz Pentium II
    std::optional<double> bar_avx512;    ///< how many times faster than OpenCV it should be
    std::optional<double> bar_avx2;
    std::optional<double> most_us;  ///< what our side may take at most, on any of these
    std::function<void()> ours;
    std::function<void()> opencv;
};

/// All rows: their pictures live as long as they do.
std::vector<BenchRow> bench_rows();

}  // namespace kambara::cli
