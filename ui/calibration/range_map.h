// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/calibration/range_error.h"

namespace kambara::ui {

/// What the calibration leaves open of ranges at the rig's height, one deviation in percent of the
/// range: directions across, depths upwards.
class RangeMap : public QWidget {
    Q_OBJECT
  public:
    explicit RangeMap(const std::vector<RangeErrorPoint>& points, QWidget* parent = nullptr);

    std::size_t places() const { return points_.size(); }
    QSize sizeHint() const override { return {520, 380}; }
    QSize minimumSizeHint() const override { return {320, 220}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    std::vector<RangeErrorPoint> points_;
};

}  // namespace kambara::ui
