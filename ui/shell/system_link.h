// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "core/base/latest_value.h"
#include "core/base/work_thread.h"
#include "core/vsystem/vsystem_interface.h"
#include "ui/calibration/calibration_ports.h"
#include "ui/experiments/experiment_ports.h"

namespace kambara::ui {

/// What to open: two sources and the rig file that belongs to them.
struct SourceRequest {
    std::string left;
    std::string right;
    std::string rig;
    double pictures_rate_hz = 10.0;  ///< of single pictures, which carry no time
    bool operator==(const SourceRequest&) const = default;
};

/// A vision system that runs; the hand that holds its target, or the known places that it goes to,
/// where that is simulated.
struct OpenedSystem {
    std::unique_ptr<VsystemInterface> system;
    TargetHand hand;
    SimulatedStations stations = {};
};

/// Opens a vision system; may take its time. Given by the program, which knows the devices.
using SystemOpener = std::function<Result<OpenedSystem>(const SourceRequest& request)>;

/// The window's end of the vision system. Carries commands to it on a thread of its own, and opens
/// another one on a second, so that neither the window waits nor a halt; brings snapshots back
/// through a mailbox in which the newest wins, and events in their order. Members are called on the
/// window's thread, where all signals are emitted as well.
class SystemLink : public QObject {
    Q_OBJECT
  public:
    explicit SystemLink(SystemOpener opener, QObject* parent = nullptr);
    ~SystemLink() override;

    /// Opens another source. Until it is there, and when it can't be opened, the one before goes on
    /// and gets the commands.
    void open(const SourceRequest& request);
    /// Carries the commands out one after the other, up to the first that is refused.
    void send(std::vector<Command> commands);
    void send(const Command& command) { send(std::vector<Command>{command}); }
    /// One that a newer one of its kind replaces while it waits for its turn: a speed, a slider.
    void send_newest(const Command& command);
    bool busy() const { return under_way_ > 0; }
    /// Of the system that was opened last.
    const TargetHand& hand() const { return hand_; }
    const SimulatedStations& stations() const { return stations_; }

  signals:
    void snapshot_came(const kambara::SnapshotPtr& snapshot);
    void event_came(const kambara::Event& event);
    void opened(const kambara::ui::SourceRequest& request, const kambara::Rig& rig);
    void refused(const kambara::Error& error);  ///< of a command or of opening
    void open_failed(const kambara::ui::SourceRequest& request, const kambara::Error& error);
    void busy_changed(bool busy);

  private:
    void began();
    void enqueue(std::function<void()> work);
    void take(const SourceRequest& request, Result<OpenedSystem> system);
    void execute(const std::vector<Command>& commands);
    void on_window(std::function<void()> work);
    void watch();
    void put(const SnapshotPtr& snapshot);
    void fetch();
    void finished();

    const SystemOpener opener_;
    LatestValue<SnapshotPtr> newest_;
    std::mutex order_;  // of what is put into it
    std::atomic<bool> fetch_pending_ = false;
    std::atomic<int> generation_ = 0;
    int under_way_ = 0;  // the window's thread alone
    TargetHand hand_;    // likewise
    SimulatedStations stations_;
    std::mutex mutex_;  // of the following
    std::map<std::size_t, Command> newest_of_kind_;
    // The worker's alone; observations end before what they observe.
    std::unique_ptr<VsystemInterface> system_;
    std::unique_ptr<Observation> snapshots_;
    std::unique_ptr<Observation> events_;
    WorkThread worker_;
    WorkThread opening_;  // last: it hands what it opened to the worker
};

}  // namespace kambara::ui
