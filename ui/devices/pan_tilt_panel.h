// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/vsystem/snapshot.h"

class QAction;
class QLabel;

namespace kambara::ui {

class PanTiltPad;

/// The head by hand: its pad, where it looks, and the buttons of the actions that belong to it.
class PanTiltPanel : public QWidget {
    Q_OBJECT
  public:
    /// The actions become buttons, in that order.
    explicit PanTiltPanel(const QList<QAction*>& actions, QWidget* parent = nullptr);

    void show_snapshot(const SnapshotPtr& snapshot);
    PanTiltPad* pad() const { return pad_; }

  private:
    PanTiltPad* pad_;
    QLabel* angles_;
    QLabel* note_;
};

}  // namespace kambara::ui
