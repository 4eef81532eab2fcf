// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "core/base/angles.h"
#include "core/vsystem/snapshot.h"

namespace kambara::ui {

/// The head's field as a map: pan across, tilt up. A dot shows where it looks, a ring where it is
/// told to look; a press or a drag asks for a place.
class PanTiltPad : public QWidget {
    Q_OBJECT
  public:
    explicit PanTiltPad(QWidget* parent = nullptr);

    void show_head(const std::optional<HeadSnapshot>& head);
    void set_limits(const HeadLimits& limits);

    QPointF point_of(const HeadAngles& angles) const;
    HeadAngles angles_at(const QPointF& point) const;  ///< held within the limits

    QSize sizeHint() const override { return {220, 110}; }
    QSize minimumSizeHint() const override { return {120, 70}; }

  signals:
    void asked_for(double pan_rad, double tilt_rad);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    QRectF field() const;
    void ask(const QPointF& point);

    HeadLimits limits_;
    std::optional<HeadSnapshot> head_;
};

}  // namespace kambara::ui
