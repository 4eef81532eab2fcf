// SPDX-License-Identifier: GPL-3.0-or-later
// A target that walks, bends and shrinks, in a real recording with true boxes.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/base/median.h"
#include "tests/support/box_sequence.h"

namespace kambara {
namespace {

using namespace testing_support;

TEST(Pedestrian, IsFollowedWithItsSizeFromNineStarts) {
    const std::filesystem::path folder = std::filesystem::path(KAMBARA_DATA) / "crossing";
    if (!std::filesystem::is_directory(folder)) {
        GTEST_SKIP() << "skipped: there is no recording at " << folder;
    }
    const BoxSequence sequence = read_box_sequence(folder);
    ASSERT_EQ(sequence.colour.size(), 120U);
    std::vector<double> overlaps;
    std::vector<double> nears;
    for (const Box& first : nine_starts(sequence)) {
        const BoxScore score = score_of(sequence, followed(sequence, first));
        overlaps.push_back(score.overlap);
        nears.push_back(score.near);
    }
    std::printf("overlap %.3f (worst %.3f), within 20 px in %.1f %% (worst %.1f %%)\n",
                median(overlaps), *std::min_element(overlaps.begin(), overlaps.end()),
                100.0 * median(nears), 100.0 * *std::min_element(nears.begin(), nears.end()));
    EXPECT_GE(median(overlaps), 0.70);
    EXPECT_GE(median(nears), 0.95);
}

}  // namespace
}  // namespace kambara
