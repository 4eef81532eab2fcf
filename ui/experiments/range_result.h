// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/stereo/range_experiment.h"

class QLabel;
class QTableWidget;
class QVBoxLayout;

namespace kambara::ui {

/// The bar of 1999 (section 7.2.3): the mean and the worst range error after its baseline had been
/// corrected.
inline constexpr double mean_range_error_1999_pct = 1.33;
inline constexpr double worst_range_error_1999_pct = 2.76;

/// What a range experiment came to: verdict, the errors before and after the correction, and plots
/// of them against depth, height and side, as figure 46 of 1999, with the places from above.
class RangeResult : public QWidget {
    Q_OBJECT
  public:
    explicit RangeResult(QWidget* parent = nullptr);

    void show_experiment(const RangeExperiment& experiment, double baseline_mm);

  private:
    QLabel* verdict_;
    QLabel* sentence_;
    QTableWidget* numbers_;
    QVBoxLayout* column_;
    QWidget* plots_ = nullptr;
};

/// The plots alone.
QWidget* range_plots(const RangeExperiment& experiment, QWidget* parent);

}  // namespace kambara::ui
