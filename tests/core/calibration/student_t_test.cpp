// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/student_t.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

namespace kambara {
namespace {

TEST(StudentT, OneAndTwoDegreesHaveClosedForms) {
    for (const double p : {0.001, 0.1, 0.3, 0.6, 0.9, 0.975, 0.9999}) {
        const double one = std::tan(std::numbers::pi * (p - 0.5));
        EXPECT_NEAR(student_t_quantile(p, 1.0), one, 1e-10 * std::abs(one)) << p;
        const double two = (2.0 * p - 1.0) / std::sqrt(2.0 * p * (1.0 - p));
        EXPECT_NEAR(student_t_quantile(p, 2.0), two, 1e-10 * std::abs(two)) << p;
    }
}

TEST(StudentT, ThePublishedTableComesOut) {
    for (const auto& [degrees, t] : {std::pair{4.0, 2.776},
                                     {7.0, 2.365},
                                     {8.0, 2.306},
                                     {10.0, 2.228},
                                     {11.0, 2.201},
                                     {30.0, 2.042},
                                     {120.0, 1.980},
                                     {1e7, 1.960}}) {
        EXPECT_NEAR(student_t_quantile(0.975, degrees), t, 5e-4) << degrees;
    }
    EXPECT_NEAR(student_t_quantile(0.975, 1e9), 1.959963985, 1e-8);
    EXPECT_NEAR(student_t_quantile(0.995, 5.0), 4.032142984, 1e-8);
}

TEST(StudentT, ProbabilityAndQuantileAreEachOthersInverse) {
    for (const double degrees : {0.7, 3.0, 17.5, 181.0, 5000.0}) {
        for (const double p : {1e-6, 0.01, 0.2, 0.5, 0.8, 0.999}) {
            const double t = student_t_quantile(p, degrees);
            EXPECT_NEAR(student_t_probability(t, degrees), p, 1e-12) << degrees << ' ' << p;
            EXPECT_NEAR(student_t_quantile(1.0 - p, degrees), -t, 1e-9 * (1.0 + std::abs(t)));
        }
    }
}

TEST(StudentT, WhatIsNoProbabilityHasNoQuantile) {
    EXPECT_TRUE(std::isnan(student_t_quantile(0.0, 3.0)));
    EXPECT_TRUE(std::isnan(student_t_quantile(1.0, 3.0)));
    EXPECT_TRUE(std::isnan(student_t_quantile(0.5, 0.0)));
    EXPECT_TRUE(std::isnan(student_t_probability(1.0, -1.0)));
    EXPECT_EQ(student_t_probability(-INFINITY, 3.0), 0.0);
}

}  // namespace
}  // namespace kambara
