// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/vsystem/snapshot.h"

class QAction;
class QLabel;
class QSlider;

namespace kambara::ui {

/// Play, pause, step and seek of a recording.
class PlaybackBar : public QWidget {
    Q_OBJECT
  public:
    PlaybackBar(QAction* play, QAction* step, QWidget* parent = nullptr);

    void show_snapshot(const Snapshot& snapshot);

  signals:
    void seek_asked(qint64 frame);

  private:
    QSlider* slider_;
    QLabel* place_;
};

}  // namespace kambara::ui
