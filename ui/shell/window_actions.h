// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include "core/vsystem/snapshot.h"

class QAction;

namespace kambara::ui {

/// Everything the window can be told to do, in the order of work, each with its key and a tooltip.
/// An action that can't be done now says in its tooltip why.
class WindowActions : public QObject {
    Q_OBJECT
  public:
    explicit WindowActions(QWidget* window);

    /// What is possible after this snapshot; null: nothing is open.
    void update(const Snapshot* snapshot, bool recording);

    QAction* open_recording;
    QAction* simulated_rig;
    QAction* close_form;
    QAction* quit;
    QAction* play;
    QAction* step;
    QAction* freeze;
    QAction* select;
    QAction* start;
    QAction* stop;
    QAction* update_template;
    QAction* clear;
    QAction* steer;
    QAction* servo;
    QAction* home;
    QAction* halt;
    QAction* reset_head;
    QAction* calibrate;
    QAction* level;
    QAction* range_experiment;
    QAction* calibrate_head;
    QAction* calibrate_zoom;
    QAction* stretch_map;
    QAction* default_layout;
    QAction* keys;
    QAction* about;

  private:
    QAction* make(const QString& text, const QString& key, const QString& help,
                  const char* object_name);
    static void allow(QAction* action, const QString& reason_not);
};

}  // namespace kambara::ui
