// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "core/geometry/rigid_transform.h"

namespace kambara::ui {

/// Holds a simulated target by hand: a drag moves it, with Shift it turns and tilts, with Ctrl it
/// rolls, the wheel takes it nearer and farther; arrow keys and Page up and down likewise.
class HoldPad : public QWidget {
    Q_OBJECT
  public:
    explicit HoldPad(QWidget* parent = nullptr);

    /// Where the target is, and its middle in its own frame.
    void set_pose(const RigidTransform& T_left_from_target, const Eigen::Vector3d& middle_mm);

    QSize sizeHint() const override { return {260, 84}; }
    QSize minimumSizeHint() const override { return {200, 72}; }

  signals:
    void held_at(const kambara::RigidTransform& T_left_from_target);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void move_by(const Eigen::Vector3d& by_mm);
    void turn_by(double turn_rad, double tilt_rad, double roll_rad);

    std::optional<RigidTransform> pose_;
    Eigen::Vector3d middle_mm_ = Eigen::Vector3d::Zero();
    std::optional<QPointF> from_;
};

}  // namespace kambara::ui
