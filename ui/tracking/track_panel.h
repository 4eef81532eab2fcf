// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/camera/rig.h"
#include "core/vsystem/snapshot.h"

class QComboBox;
class QLabel;

namespace kambara::ui {

/// The steered target in numbers: state and reason, position with its uncertainty in the frame that
/// the operator chose, range, quality.
class TrackPanel : public QWidget {
    Q_OBJECT
  public:
    explicit TrackPanel(QWidget* parent = nullptr);

    /// What positions are told by; frames that it does not know are not offered.
    void set_rig(const Rig& rig);
    void show_snapshot(const SnapshotPtr& snapshot);
    void clear();

  private:
    void add_frames();
    void choose_frame();
    QLabel* add_row(const QString& name, const QString& object_name, const QString& help);

    Rig rig_;
    RigidTransform T_frame_from_left_;  // the frame that was chosen
    SnapshotPtr shown_;
    QComboBox* frame_;
    QLabel* state_;
    QLabel* reason_;
    QLabel* number_;
    QLabel* x_;
    QLabel* y_;
    QLabel* z_;
    QLabel* calibration_;
    QLabel* range_;
    QLabel* quality_;
    QLabel* residual_;
    QLabel* updates_;
};

}  // namespace kambara::ui
