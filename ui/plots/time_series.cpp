// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/time_series.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>

namespace kambara::ui {

void TimeSeries::add(double time_s, double value) {
    if (!samples_.empty() && time_s < samples_.back().time_s) {
        samples_.clear();
    }
    if (!samples_.empty() && time_s == samples_.back().time_s) {
        samples_.back().value = value;
        return;
    }
    samples_.push_back({time_s, value});
    while (samples_.front().time_s < time_s - window_s_) {
        samples_.pop_front();
    }
}

void TimeSeries::decimated(int columns, QVector<double>& times_s, QVector<double>& values) const {
    times_s.clear();
    values.clear();
    if (samples_.empty() || columns <= 0) {
        return;
    }
    const double begin_s = samples_.back().time_s - window_s_;
    const auto column_of = [&](const Sample& sample) {
        return static_cast<int>((sample.time_s - begin_s) / window_s_ * columns);
    };
    const auto put = [&](const Sample& sample) {
        times_s.push_back(sample.time_s);
        values.push_back(sample.value);
    };
    for (std::size_t first = 0; first < samples_.size();) {
        const int column = column_of(samples_[first]);
        std::size_t end = first;
        bool gap = false;
        std::size_t least = first;
        std::size_t most = first;
        for (; end < samples_.size() && column_of(samples_[end]) == column; ++end) {
            gap = gap || !std::isfinite(samples_[end].value);
            least = samples_[end].value < samples_[least].value ? end : least;
            most = samples_[end].value > samples_[most].value ? end : most;
        }
        if (gap || end - first <= 4) {
            for (std::size_t i = first; i < end; ++i) {
                put(samples_[i]);
            }
        } else {
            const std::size_t last = end - 1;
            std::size_t kept[] = {first, std::min(least, most), std::max(least, most), last};
            for (std::size_t i = 0; i < 4; ++i) {
                if (i == 0 || kept[i] != kept[i - 1]) {
                    put(samples_[kept[i]]);
                }
            }
        }
        first = end;
    }
}

double TimeSeries::at(double time_s) const {
    if (samples_.empty()) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    auto after = std::lower_bound(samples_.begin(), samples_.end(), time_s,
                                  [](const Sample& s, double t) { return s.time_s < t; });
    if (after == samples_.end()) {
        return samples_.back().value;
    }
    if (after != samples_.begin() && time_s - std::prev(after)->time_s < after->time_s - time_s) {
        --after;
    }
    return after->value;
}

}  // namespace kambara::ui
