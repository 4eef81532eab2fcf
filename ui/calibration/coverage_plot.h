// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/calibration/session/coverage.h"

namespace kambara::ui {

/// How the target was held in the shots kept: turn and tilt on a field of degrees, depths on a
/// scale beside it.
class CoveragePlot : public QWidget {
    Q_OBJECT
  public:
    explicit CoveragePlot(QWidget* parent = nullptr);

    void show_coverage(const Coverage& coverage);
    std::size_t poses_shown() const { return coverage_.poses.size(); }
    QSize sizeHint() const override { return {300, 220}; }
    QSize minimumSizeHint() const override { return {260, 190}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    Coverage coverage_;
};

}  // namespace kambara::ui
