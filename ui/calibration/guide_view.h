// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QWidget>
#include <vector>

#include "ui/calibration/session_worker.h"

namespace kambara::ui {

/// One camera's picture during a session: the corners found in it, what of the picture is covered
/// (green, the more views the stronger), and the outline to bring the target to.
class GuideView : public QWidget {
    Q_OBJECT
  public:
    GuideView(std::size_t camera, const QString& title, QWidget* parent = nullptr);

    void show_look(const SessionLook& look);
    void show_state(const SessionState& state);
    void clear();

    std::size_t corners_shown() const { return sight_.corners.size(); }
    std::size_t outlines_shown() const { return outlines_px_.size(); }
    QSize sizeHint() const override { return {560, 420}; }
    QSize minimumSizeHint() const override { return {220, 165}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    const std::size_t camera_;
    const QString title_;
    QImage image_;
    CameraSight sight_;
    std::vector<std::vector<Eigen::Vector2d>> outlines_px_;
    PictureCoverage coverage_;
};

/// A camera's name for people.
QString camera_title(std::size_t camera);

}  // namespace kambara::ui
