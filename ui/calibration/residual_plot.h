// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/calibration/calibration_report.h"

namespace kambara::ui {

/// One camera's residuals over its picture, a hundred times as long as they are.
class ResidualPlot : public QWidget {
    Q_OBJECT
  public:
    ResidualPlot(std::size_t camera, const CalibrationReport& report, QWidget* parent = nullptr);

    std::size_t arrows() const { return residuals_.size(); }
    QSize sizeHint() const override { return {460, 380}; }
    QSize minimumSizeHint() const override { return {260, 220}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    QString title_;
    QSizeF picture_;
    std::vector<Residual> residuals_;
};

}  // namespace kambara::ui
