// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "core/stereo/range_experiment.h"

class QLabel;
class QTableWidget;
class QVBoxLayout;

namespace kambara::ui {

/// What a range experiment came to: verdict, the errors before and after the correction, and plots
/// of them against depth, height and side, as figure 46 of 1999, with the places from above.
class RangeResult : public QWidget {
    Q_OBJECT
  public:
    explicit RangeResult(QWidget* parent = nullptr);

    void show_experiment(const RangeExperiment& experiment, double baseline_mm);

  private:
    static QString verdict(const RangeExperiment& experiment,
                           const std::function<QString(const RangeErrors&)>& numbers);

    QLabel* verdict_;
    QLabel* sentence_;
    QTableWidget* numbers_;
    QVBoxLayout* column_;
    QWidget* plots_ = nullptr;
};

/// The plots alone.
QWidget* range_plots(const RangeExperiment& experiment, QWidget* parent);

}  // namespace kambara::ui
