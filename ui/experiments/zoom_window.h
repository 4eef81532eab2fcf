// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <optional>
#include <vector>

#include "core/calibration/zoom_calibration.h"
#include "ui/experiments/assistant_window.h"
#include "ui/experiments/experiment_ports.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;
class QTableWidget;

namespace kambara::ui {

class Background;
class SaveRow;

/// The zoom's calibration: the head stands still before a scene at rest, its lens is zoomed from
/// wide to tele place by place, and a picture is taken at each one. From the pictures comes how
/// much it enlarges, to be kept in a table of heads.
///
///     idle --go--> zooming --there, and a newer picture--> zooming (the next place) --last-->
///     measuring --> idle            (stop, the head moved, or a fault: idle)
class ZoomWindow : public AssistantWindow {
    Q_OBJECT
  public:
    explicit ZoomWindow(const ExperimentPorts& ports, QWidget* parent = nullptr);
    ~ZoomWindow() override;

    void set_source(const Rig& rig) override;
    void show_snapshot(const SnapshotPtr& snapshot) override;
    QString unsaved() const override;

  protected:
    void leave() override;

  private:
    enum class Doing { nothing, zooming, measuring };

    void build();
    void go(bool on);
    void zoom_on();
    void go_on();
    void take();
    void measure();
    void stop();
    void changed();
    void show_rows();
    void show_verdict();
    void show_lens_of_kind();
    void save(const QString& file);
    QString hindrance() const;

    struct Taken {
        ZoomView view;
        double told_magnification = 0.0;  ///< 0 where the head does not know its lens
    };

    const ExperimentPorts ports_;
    Rig rig_;
    SnapshotPtr newest_;
    Doing doing_ = Doing::nothing;
    int run_ = 0;  // what belongs to an earlier one is dropped
    QElapsedTimer clock_;
    std::int64_t since_ms_ = 0;            // asked for, then there
    std::optional<std::int64_t> picture_;  // the newest when it was there
    HeadAngles stood_at_;
    double zoomed_before_ = 0.0;
    std::vector<Taken> taken_;
    std::vector<ZoomPlace> places_;
    bool saved_ = true;

    QLabel* state_;
    QTableWidget* table_;
    QLabel* empty_;
    QPushButton* go_;
    QLabel* verdict_;
    QComboBox* kind_;
    QDoubleSpinBox* widest_;
    QDoubleSpinBox* sensor_;
    SaveRow* save_;
    Background* background_;
};

}  // namespace kambara::ui
