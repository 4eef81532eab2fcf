// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "core/stereo/range_experiment.h"
#include "ui/experiments/assistant_window.h"
#include "ui/experiments/experiment_ports.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QPushButton;
class QSpinBox;
class QTabWidget;

namespace kambara::ui {

class Background;
class PlaceTable;
class RangeResult;
class SaveRow;

/// The range experiment (1999, section 7.2.3): the tracked target stands at known places, one
/// after the other; its positions there are averaged and held against them, before and after a
/// correction of the baseline. On the simulated stations it goes by itself, with truth known.
///
///     choosing --measure--> measuring --N readings, or stop--> choosing --judge--> result
///         +--simulate--> waiting --opened--> running --last station, or stop--> result
class RangeWindow : public AssistantWindow {
    Q_OBJECT
  public:
    explicit RangeWindow(const ExperimentPorts& ports, QWidget* parent = nullptr);
    ~RangeWindow() override;

    /// Before set_source(): what is known where the source is the simulated stations, and whether
    /// it is a simulation at all.
    void set_stations(const SimulatedStations& stations, bool simulated);
    void set_source(const Rig& rig) override;
    void show_snapshot(const SnapshotPtr& snapshot) override;
    QString unsaved() const override;

    /// Adds the known places of a table.
    void load(const QString& file);

  signals:
    /// The simulated rig should show its stations from the first one on.
    void stations_asked();

  protected:
    void leave() override;

  private:
    enum class Doing { nothing, measuring, waiting, running };

    void build();
    QWidget* places_page();
    QWidget* result_page();
    void connect_all();
    void measure(bool on);
    void simulate(bool on);
    void begin_run(const Snapshot& snapshot);
    void add_of_station(const Snapshot& snapshot, const Eigen::Vector3d& point_in_left_mm);
    void take_reading(const Eigen::Vector3d& point_in_left_mm);
    void stop();
    void changed();
    void refresh_differences();
    std::optional<Eigen::Vector3d> known_in_left_mm(int row) const;
    bool refuse_other_rig();
    void judge();
    void show_judged(const Result<RangeExperiment>& judged, double baseline_mm);
    void save(const QString& file, bool page);
    void show_live(int row, const std::vector<Eigen::Vector3d>& readings);

    const ExperimentPorts ports_;
    SimulatedStations stations_;
    bool simulated_ = false;
    bool has_targets_ = false;  // what is followed now would be forgotten with its source
    Rig rig_;
    Rig measured_by_;
    Doing doing_ = Doing::nothing;
    int row_ = -1;  // that is measured
    std::vector<Eigen::Vector3d> readings_;
    std::map<int, int> row_of_station_;
    std::optional<Eigen::Vector2d> chosen_px_;  // of the simulated target, in chosen_frame_
    std::int64_t chosen_frame_ = -1;
    std::int64_t last_frame_ = -1;
    bool saved_ = true;
    std::optional<RangeExperiment> experiment_;
    double baseline_mm_ = 0.0;

    QTabWidget* tabs_;
    QComboBox* frame_;
    QSpinBox* count_;
    QCheckBox* by_tape_;
    QDoubleSpinBox* true_baseline_mm_;
    PlaceTable* table_;
    QLabel* empty_;
    QLabel* target_;
    QLabel* live_;
    QPushButton* load_;
    QPushButton* add_;
    QPushButton* remove_;
    QPushButton* clear_;
    QPushButton* measure_;
    QPushButton* simulate_;
    QPushButton* judge_;
    RangeResult* result_;
    SaveRow* save_table_;
    SaveRow* save_page_;
    Background* background_;
};

}  // namespace kambara::ui
