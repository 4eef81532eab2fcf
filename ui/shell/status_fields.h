// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/camera/rig.h"
#include "core/pointing/stick_law.h"
#include "core/vsystem/snapshot.h"

class QLabel;
class QStatusBar;

namespace kambara::ui {

/// The fixed fields of the status bar: source, medium, frame rate, latency, frames lost.
class StatusFields : public QObject {
    Q_OBJECT
  public:
    explicit StatusFields(QStatusBar* bar);

    void show_source(const QString& title, const Rig& rig);
    void show_snapshot(const Snapshot& snapshot);
    void show_gamepad(PadState state, const QString& name);

  private:
    QLabel* add(const char* object_name, const QString& help, const QString& widest);

    QStatusBar* bar_;
    QLabel* gamepad_;
    QLabel* source_;
    QLabel* medium_;
    QLabel* rate_;
    QLabel* latency_;
    QLabel* lost_;
};

}  // namespace kambara::ui
