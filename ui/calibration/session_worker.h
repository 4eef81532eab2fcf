// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <thread>

#include "core/base/latest_value.h"
#include "core/base/work_thread.h"
#include "core/calibration/session/calibration_session.h"
#include "core/vsystem/snapshot.h"
#include "ui/calibration/calibration_ports.h"

namespace kambara::ui {

/// What a session holds, after a change of it.
struct SessionState {
    SessionSetup setup;
    std::filesystem::path folder;
    std::vector<Shot> shots;
    int kept = 0;
    bool can_undo = false;
    Coverage coverage;
    std::optional<NextView> next;
    double range_error = 0.0;  ///< by prediction, over the range; 0 before the first shot
};
using SessionStatePtr = std::shared_ptr<const SessionState>;

/// One look at the newest pictures.
struct SessionLook {
    PictureSet pictures;
    Look look;
};
using SessionLookPtr = std::shared_ptr<const SessionLook>;
using SessionOutcomePtr = std::shared_ptr<const SessionOutcome>;

/// Runs a guided session away from the window's thread: one thread looks at the newest pictures
/// (those that came meanwhile are passed over) and keeps the shots, another solves. Members are
/// called on the window's thread, where all signals are emitted as well.
class SessionWorker : public QObject {
    Q_OBJECT
  public:
    explicit SessionWorker(CalibrationPorts ports, QObject* parent = nullptr);
    ~SessionWorker() override;

    void begin(const SessionSetup& setup, const std::filesystem::path& folder);
    void resume(const std::filesystem::path& folder);
    /// Pictures to be looked at, while it watches.
    void offer(const SnapshotPtr& snapshot);
    void watch(bool on);
    /// Takes the next pictures without waiting for stillness.
    void capture_by_hand() { by_hand_ = true; }
    void set_kept(int shot, bool kept);
    void undo();
    void solve();
    void cancel();
    /// Writes the rig with where it comes from, or the report. `solved` is what solve() gave.
    void save_rig(const SessionOutcomePtr& solved, const std::filesystem::path& path);
    void save_report(const SessionOutcomePtr& solved, const std::filesystem::path& path);

  signals:
    void begun();
    void changed(const kambara::ui::SessionStatePtr& state);
    void looked(const kambara::ui::SessionLookPtr& look);
    void progressed(double share);
    void solved(const kambara::ui::SessionOutcomePtr& outcome);
    void cancelled();
    void saved(const QString& file);
    void failed(const kambara::Error& error);

  private:
    void on_window(std::function<void()> work);
    void take(Result<CalibrationSession> session, const std::filesystem::path& folder);
    void look_at_newest();
    void tell_state();
    void after(const Result<Done>& done);
    void solve_on_thread(bool quietly);

    const CalibrationPorts ports_;
    LatestValue<SnapshotPtr> newest_;
    std::atomic<bool> look_pending_ = false;
    std::atomic<bool> watching_ = false;
    std::atomic<bool> by_hand_ = false;
    // The worker's alone.
    std::optional<CalibrationSession> session_;
    std::filesystem::path folder_;
    int generation_ = 0;  // of sessions
    int learnt_at_ = 0;   // shots kept
    std::atomic<bool> solving_for_window_ = false;
    std::jthread solver_;  // begun and stopped by the worker
    WorkThread worker_;
};

/// How a session was asked for, in words.
std::string settings_text(const SessionSetup& setup);
/// The rig with its provenance: date, program, settings and the pictures' hashes.
Result<Rig> rig_with_provenance(const SessionOutcome& outcome, const std::filesystem::path& folder,
                                const CalibrationPorts& ports);

}  // namespace kambara::ui
