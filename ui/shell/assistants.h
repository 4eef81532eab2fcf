// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QObject>

#include "core/camera/rig.h"
#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"
#include "ui/calibration/calibration_ports.h"
#include "ui/experiments/experiment_ports.h"

class QWidget;

namespace kambara::ui {

class AssistantWindow;
class HeadWindow;
class LevellingWindow;
class RangeWindow;
class ZoomWindow;

/// The forms of the Tools menu, each made when it is first asked for, and what they are fed with.
class Assistants : public QObject {
    Q_OBJECT
  public:
    Assistants(const ExperimentPorts& ports, QWidget* main_window);

    void show_levelling();
    void show_range_experiment();
    void show_head_calibration();
    void show_zoom_calibration();

    void set_source(const Rig& rig, const SimulatedStations& stations, const TargetHand& hand,
                    bool simulated);
    /// Of those that are open.
    void show_snapshot(const SnapshotPtr& snapshot);
    /// Asks where something unsaved would be lost; false where the program must not close.
    bool may_close();
    /// All that are open, without asking.
    void close_all();

  signals:
    /// A simulated rig of that profile should be opened.
    void simulation_asked(const QString& source);
    void command_asked(const kambara::Command& command);
    /// The mount of the rig in use is known now.
    void mount_found(const kambara::Mount& mount);

  private:
    void show(AssistantWindow* window);

    const ExperimentPorts ports_;
    QWidget* main_window_;
    QList<AssistantWindow*> windows_;
    LevellingWindow* levelling_ = nullptr;
    RangeWindow* range_ = nullptr;
    HeadWindow* head_ = nullptr;
    ZoomWindow* zoom_ = nullptr;
    SnapshotPtr newest_;  // of the source that is open
    Rig rig_;
    SimulatedStations stations_;
    TargetHand hand_;
    bool simulated_ = false;
};

}  // namespace kambara::ui
