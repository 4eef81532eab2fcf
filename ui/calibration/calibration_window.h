// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "ui/calibration/session_worker.h"

class QStackedWidget;

namespace kambara::ui {

class CapturePage;
class ResultPage;
class SetupPage;

/// The guided calibration session:
///
///     choose --begin, resume--> capture --calibrate--> result
///        ^-------- leave ----------+  ^----- back -------+
///
/// It needs nothing but the pictures; whoever opens it hands snapshots and the rig in use over.
class CalibrationWindow : public QWidget {
    Q_OBJECT
  public:
    explicit CalibrationWindow(const CalibrationPorts& ports, QWidget* parent = nullptr);
    ~CalibrationWindow() override;

    /// The source that is open now. `simulated`: it can show any target that is asked for.
    void set_source(const Rig& rig, const TargetHand& hand, bool simulated);
    void show_snapshot(const SnapshotPtr& snapshot);
    /// Goes on with a session's folder.
    void resume(const QString& folder);

  signals:
    /// The simulated rig should show this target; set_source() is to follow.
    void simulated_target_asked(const QString& target);

  protected:
    void closeEvent(QCloseEvent* event) override;

  private:
    void begin(const SessionSetup& setup, const QString& folder);
    void connect_worker();
    void connect_pages();
    void fail(const Error& error);
    void leave();
    void start_capturing();
    void save(const QString& file, bool report);

    SetupPage* setup_;
    CapturePage* capture_;
    ResultPage* result_;
    QStackedWidget* pages_;
    SessionWorker* worker_;
    TargetHand hand_;
    bool simulated_ = false;
    SessionStatePtr state_;
    SessionOutcomePtr outcome_;
    std::optional<std::pair<SessionSetup, QString>> waiting_;  // for the simulated target
};

}  // namespace kambara::ui
