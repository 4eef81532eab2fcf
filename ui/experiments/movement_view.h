// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QWidget>
#include <optional>
#include <vector>

namespace kambara::ui {

/// Recorded positions as the rig sees them from the front and from its side, both to one scale,
/// with the direction that was found through their middle.
class MovementView : public QWidget {
    Q_OBJECT
  public:
    explicit MovementView(QWidget* parent = nullptr);

    /// In the rig's frame, mm. `direction`: straight down, or up the wall.
    void show_points(std::vector<Eigen::Vector3d> points_in_rig_mm,
                     const std::optional<Eigen::Vector3d>& direction);
    void set_hint(const QString& hint);
    std::size_t points() const { return points_.size(); }

    QSize sizeHint() const override { return {620, 420}; }
    QSize minimumSizeHint() const override { return {360, 240}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void paint_side(QPainter& painter, const QRectF& area, int across, const QString& title) const;
    double scale_for(const QSizeF& area) const;

    std::vector<Eigen::Vector3d> points_;
    std::optional<Eigen::Vector3d> direction_;
    Eigen::Vector3d least_ = Eigen::Vector3d::Zero();
    Eigen::Vector3d most_ = Eigen::Vector3d::Zero();
    QString hint_;
};

}  // namespace kambara::ui
