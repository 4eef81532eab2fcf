// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QVector>
#include <deque>

namespace kambara::ui {

/// A quantity over the last `window_s` seconds. Values that are not finite are gaps.
class TimeSeries {
  public:
    explicit TimeSeries(double window_s) : window_s_(window_s) {}

    /// Times grow; one that does not starts anew (a recording was wound back).
    void add(double time_s, double value);
    void clear() { samples_.clear(); }
    bool empty() const { return samples_.empty(); }
    double newest_s() const { return samples_.empty() ? 0.0 : samples_.back().time_s; }

    /// For drawing on `columns` pixels: of each column's samples the first, the least, the greatest
    /// and the last, in their order, so that no peak is lost. Gaps stay gaps.
    void decimated(int columns, QVector<double>& times_s, QVector<double>& values) const;

    /// The value of the sample nearest to a time; NaN where there is none.
    double at(double time_s) const;

  private:
    struct Sample {
        double time_s;
        double value;
    };
    double window_s_;
    std::deque<Sample> samples_;
};

}  // namespace kambara::ui
