// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/stereo/levelling.h"
#include "ui/experiments/assistant_window.h"

class QComboBox;
class QDoubleSpinBox;
class QPushButton;

namespace kambara::ui {

class Background;
class MovementView;
class SaveRow;

/// The levelling assistant (1999, section 7.2.2): records where the tracked target is while it is
/// moved straight up and down, or over a wall, and finds the angle in which the rig is mounted.
///
///     idle --record--> recording --stop--> recorded --use this--> saved
///       ^                                     |  ^------- record (goes on) ----+
///       +-------------- clear ----------------+
class LevellingWindow : public AssistantWindow {
    Q_OBJECT
  public:
    explicit LevellingWindow(QWidget* parent = nullptr);
    ~LevellingWindow() override;

    void set_source(const Rig& rig) override;
    void show_snapshot(const SnapshotPtr& snapshot) override;
    QString unsaved() const override;

  signals:
    /// The rig that was saved, with its mount: positions can be told in the vehicle's frame now.
    void mount_found(const kambara::Rig& rig);

  protected:
    void leave() override;

  private:
    struct Found {
        std::vector<Eigen::Vector3d> points_in_rig_mm;
        bool wall = false;
        Movement movement;
        Result<Levelling> levelling;
    };

    void build();
    bool by_wall() const;
    void record(bool on);
    void clear();
    void changed();
    void solve();
    void show_found(const Found& found);
    QString warnings(const Found& found) const;
    void save(const QString& file);

    Rig rig_;
    Rig measured_by_;  // what the recorded positions came from
    std::vector<Eigen::Vector3d> points_in_left_mm_;
    std::int64_t last_frame_ = -1;
    bool recording_ = false;
    bool stale_ = false;  // what was found does not hold all points
    bool saved_ = false;
    std::optional<Levelling> levelling_;
    bool found_by_wall_ = false;

    QComboBox* way_;
    QLabel* how_;
    QLabel* target_;
    QDoubleSpinBox* roll_deg_;
    QLabel* roll_label_;
    QPushButton* record_;
    QPushButton* clear_;
    QLabel* count_;
    QLabel* extent_;
    QLabel* straightness_;
    QLabel* left_out_;
    QLabel* pitch_;
    QLabel* roll_;
    QLabel* warning_;
    MovementView* view_;
    SaveRow* save_;
    Background* background_;
};

}  // namespace kambara::ui
