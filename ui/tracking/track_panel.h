// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/vsystem/snapshot.h"

class QLabel;

namespace kambara::ui {

/// The steered target in numbers: state and reason, position with its uncertainty, range, quality.
class TrackPanel : public QWidget {
    Q_OBJECT
  public:
    explicit TrackPanel(QWidget* parent = nullptr);

    void show_snapshot(const SnapshotPtr& snapshot);
    void clear();

  private:
    QLabel* add_row(const QString& name, const QString& object_name, const QString& help);

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
