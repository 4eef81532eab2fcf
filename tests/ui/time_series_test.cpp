// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/time_series.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace kambara::ui {
namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

TEST(TimeSeries, ForgetsWhatIsOlderThanItsWindow) {
    TimeSeries series(10.0);
    for (int i = 0; i <= 100; ++i) {
        series.add(0.5 * i, i);
    }
    EXPECT_DOUBLE_EQ(series.at(0.0), 80.0);  // the oldest kept: 40 s
    EXPECT_DOUBLE_EQ(series.at(45.2), 90.0);
    EXPECT_DOUBLE_EQ(series.at(99.0), 100.0);
    series.add(3.0, 7.0);  // wound back
    EXPECT_DOUBLE_EQ(series.at(50.0), 7.0);
    series.add(3.0, 8.0);  // the same instant again
    EXPECT_DOUBLE_EQ(series.at(3.0), 8.0);
}

TEST(TimeSeries, DecimatesWithoutLosingAPeakOrAGap) {
    TimeSeries series(60.0);
    for (int i = 0; i < 3600; ++i) {
        series.add(i / 60.0, i == 1717 ? 1000.0 : i == 2020 ? -1000.0 : i == 3000 ? gap : i % 7);
    }
    QVector<double> times_s;
    QVector<double> values;
    series.decimated(200, times_s, values);
    EXPECT_LE(values.size(), 4 * 201 + 40);
    EXPECT_TRUE(std::is_sorted(times_s.begin(), times_s.end()));
    EXPECT_EQ(std::count(values.begin(), values.end(), 1000.0), 1);
    EXPECT_EQ(std::count(values.begin(), values.end(), -1000.0), 1);
    EXPECT_EQ(std::count_if(values.begin(), values.end(), [](double v) { return std::isnan(v); }),
              1);
    EXPECT_DOUBLE_EQ(times_s.back(), 3599 / 60.0);
    TimeSeries(60.0).decimated(200, times_s, values);
    EXPECT_TRUE(times_s.isEmpty());
    EXPECT_TRUE(std::isnan(TimeSeries(60.0).at(1.0)));
}

}  // namespace
}  // namespace kambara::ui
