// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

class QAction;
class QBoxLayout;
class QLabel;
class QScrollArea;
class QSlider;

namespace kambara::ui {

class HandDrive;
class HeadStick;
class LensControls;
class PanTiltPad;

/// The head by hand: the buttons of the actions that belong to it and where it looks, always in
/// sight and in their places; below, scrolled where there is no room for all, stick and map, how
/// fast it is driven, and its lens.
class PanTiltPanel : public QWidget {
    Q_OBJECT
  public:
    /// The actions become buttons, in that order. The stick and the speed are `drive`'s.
    PanTiltPanel(const QList<QAction*>& actions, HandDrive* drive, QWidget* parent = nullptr);

    void show_snapshot(const SnapshotPtr& snapshot);
    PanTiltPad* pad() const { return pad_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

  signals:
    void asked(const kambara::Command& command);

  private:
    static QString told(const ServoSnapshot& servo);
    void build_controls(QBoxLayout* column);
    void build_speed(QBoxLayout* column);
    void build_buttons(QBoxLayout* column, const QList<QAction*>& actions);

    HandDrive* drive_;
    QScrollArea* scrolled_;
    QWidget* controls_;
    HeadStick* stick_;
    PanTiltPad* pad_;
    QLabel* angles_;
    QLabel* note_;
    QSlider* speed_;
    QLabel* speed_text_;
    LensControls* lens_;
};

}  // namespace kambara::ui
