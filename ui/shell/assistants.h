// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "core/camera/rig.h"
#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

class QWidget;

namespace kambara::ui {

class AssistantWindow;
class LevellingWindow;

/// The forms of the Tools menu, each made when it is first asked for, and what they are fed with.
class Assistants : public QObject {
    Q_OBJECT
  public:
    explicit Assistants(QWidget* main_window);

    void show_levelling();

    void set_source(const Rig& rig);
    /// Of those that are open.
    void show_snapshot(const SnapshotPtr& snapshot);
    /// Asks where something unsaved would be lost; false where the program must not close.
    bool may_close();

  signals:
    void command_asked(const kambara::Command& command);
    /// The mount of the rig in use is known now.
    void mount_found(const kambara::Mount& mount);

  private:
    void show(AssistantWindow* window);

    QWidget* main_window_;
    QList<AssistantWindow*> windows_;
    LevellingWindow* levelling_ = nullptr;
    Rig rig_;
};

}  // namespace kambara::ui
