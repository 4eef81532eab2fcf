// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

class QAction;
class QBoxLayout;
class QLabel;
class QSlider;

namespace kambara::ui {

class HandDrive;
class HeadStick;
class LensControls;
class PanTiltPad;

/// The head by hand: stick and map, where it looks, how fast it is driven, its lens, and the
/// buttons of the actions that belong to it. Scrolls where there is no room for all.
class PanTiltPanel : public QScrollArea {
    Q_OBJECT
  public:
    /// The actions become buttons, in that order. The stick and the speed are `drive`'s.
    PanTiltPanel(const QList<QAction*>& actions, HandDrive* drive, QWidget* parent = nullptr);

    void show_snapshot(const SnapshotPtr& snapshot);
    PanTiltPad* pad() const { return pad_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {260, 120}; }

  signals:
    void asked(const kambara::Command& command);

  private:
    static QString told(const ServoSnapshot& servo);
    void build_speed(QBoxLayout* column);
    void build_buttons(QBoxLayout* column, const QList<QAction*>& actions);

    HandDrive* drive_;
    HeadStick* stick_;
    PanTiltPad* pad_;
    QLabel* angles_;
    QLabel* note_;
    QSlider* speed_;
    QLabel* speed_text_;
    LensControls* lens_;
};

}  // namespace kambara::ui
