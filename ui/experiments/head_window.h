// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <memory>
#include <optional>
#include <vector>

#include "core/pointing/head_calibration.h"
#include "core/vsystem/head_view.h"
#include "ui/calibration/calibration_ports.h"
#include "ui/experiments/assistant_window.h"
#include "ui/experiments/experiment_ports.h"
#include "ui/experiments/head_sequence.h"

class QComboBox;
class QFormLayout;
class QPushButton;
class QTableWidget;

namespace kambara::ui {

class Background;
class SaveRow;

/// A view as it was recorded, or what kept it from being one.
struct HeadRecorded {
    HeadAngles encoder;
    HeadApproach approach;
    HeadPictures pictures;  ///< none where it was read from a record
    std::optional<HeadView> view;
    std::string reason;  ///< why it is of no use
    std::optional<double> rms_rad;
};

/// The head's calibration: a target that stands still is shown to all three cameras, the head goes
/// to positions about it by itself, and at each one the pictures and the head's angles are
/// recorded; or a record of the command line's is read. From the views come the head's axes, lever
/// arms and backlash.
///
///     idle --go through--> opening (a simulated target) --> looking --found--> going --last-->
///     idle
///                                    (stop, a hand on the head, or a fault: idle)
class HeadWindow : public AssistantWindow {
    Q_OBJECT
  public:
    explicit HeadWindow(const ExperimentPorts& ports, QWidget* parent = nullptr);
    ~HeadWindow() override;

    /// Before set_source(): the hand of a simulated target, and whether the source is a simulation.
    void set_hand(const TargetHand& hand, bool simulated);
    void set_source(const Rig& rig) override;
    void show_snapshot(const SnapshotPtr& snapshot) override;
    QString unsaved() const override;
    /// Adds the views of a record.
    void load(const QString& file);

  signals:
    /// The simulated rig should show this target; set_source() is to follow.
    void simulated_target_asked(const QString& target);

  protected:
    void leave() override;

  private:
    enum class Doing { nothing, opening, looking, going };

    void build();
    QWidget* views_part();
    QWidget* result_part();
    void connect_all();
    void go(bool on);
    void look_for_target(const SnapshotPtr& snapshot);
    void go_on(const SnapshotPtr& snapshot);
    void record(const SnapshotPtr& snapshot, const HeadApproach& approach);
    void add(const HeadRecorded& recorded);
    void hold_target();
    void stop();
    void break_off();
    void changed();
    void solve();
    void clear_result();
    void show_result();
    void fill_row(int row);
    void save_rig(const QString& file);
    void save_record(const QString& file);
    QString hindrance() const;
    std::optional<Target> target();
    bool moved_by_other(const HeadSnapshot& head);
    int views() const;

    const ExperimentPorts ports_;
    TargetHand hand_;
    bool simulated_ = false;
    Rig rig_;
    Rig recorded_by_;
    SnapshotPtr newest_;
    Doing doing_ = Doing::nothing;
    bool detecting_ = false;
    bool held_ = false;
    int run_ = 0;  // what belongs to an earlier one is dropped
    QElapsedTimer clock_;
    std::int64_t since_ms_ = 0;
    HeadSequence sequence_;
    std::optional<HeadAngles> seen_at_;  // the target, when it was last looked for
    std::optional<HeadAngles> asked_;
    bool taken_ = false;  // what was asked for, by the head
    std::vector<HeadRecorded> recorded_;
    std::optional<HeadCalibration> result_;
    bool rig_saved_ = true;
    bool record_saved_ = true;

    QComboBox* target_;
    QLabel* state_;
    QPushButton* go_;
    QPushButton* one_;
    QPushButton* load_;
    QPushButton* clear_;
    QPushButton* solve_;
    QTableWidget* table_;
    QLabel* empty_;
    QLabel* verdict_;
    QLabel* rms_;
    QLabel* rms_deg_;
    QLabel* without_;
    QLabel* ahead_;
    QLabel* arm_;
    QLabel* skew_;
    QLabel* pan_backlash_;
    QLabel* tilt_backlash_;
    QLabel* by_rig_;
    SaveRow* save_rig_;
    SaveRow* save_record_;
    Background* background_;
};

}  // namespace kambara::ui
