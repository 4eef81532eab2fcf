// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace kambara {
namespace {

Result<int> half(int n) {
    if (n % 2 != 0) {
        return Error{"The number is odd.", "Give an even one."};
    }
    return n / 2;
}

TEST(Result, HoldsTheValueOrTheError) {
    EXPECT_TRUE(half(6).ok());
    EXPECT_EQ(*half(6), 3);
    ASSERT_FALSE(half(5));
    EXPECT_EQ(half(5).error().text(), "The number is odd. Give an even one.");
}

TEST(Result, AskingForTheSideThatIsNotThereThrows) {
    EXPECT_THROW(half(5).value(), std::logic_error);
    EXPECT_THROW(half(6).error(), std::logic_error);
}

TEST(Result, GivesAwayWhatCanOnlyBeMoved) {
    Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
    const std::unique_ptr<int> taken = *std::move(result);
    EXPECT_EQ(*taken, 7);
}

}  // namespace
}  // namespace kambara
