// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/range_window.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTabWidget>

#include "core/base/text_file.h"
#include "core/camera/rig_file.h"
#include "ui/base/quantities.h"
#include "ui/experiments/background.h"
#include "ui/experiments/place_table.h"
#include "ui/experiments/range_result.h"
#include "ui/experiments/target_line.h"

namespace kambara::ui {

RangeWindow::RangeWindow(const ExperimentPorts& ports, QWidget* parent)
    : AssistantWindow(QStringLiteral("rangeWindow"), tr("Range experiment"), parent),
      ports_(ports),
      background_(new Background(this)) {
    resize(1180, 780);
    build();
    connect_all();
    changed();
}

RangeWindow::~RangeWindow() = default;

void RangeWindow::set_stations(const SimulatedStations& stations, bool simulated) {
    stations_ = stations;
    simulated_ = simulated;
}

void RangeWindow::set_source(const Rig& rig) {
    const bool waited = doing_ == Doing::waiting && stations_;
    if (doing_ != Doing::nothing && !waited) {
        stop();
        say(tr("Another source was opened: measuring ended."));
    }
    rig_ = rig;
    last_frame_ = -1;
    has_targets_ = false;
    chosen_px_.reset();
    if (waited) {
        doing_ = Doing::running;
    }
    true_baseline_mm_->setValue(rig.right ? baseline_mm(rig) : 0.0);
    target_->clear();
    changed();
}

void RangeWindow::load(const QString& file) {
    background_->run([read = ports_.read_places, path = file.toStdString()] { return read(path); },
                     [this, file](const Result<std::vector<Eigen::Vector3d>>& places) {
                         if (!places) {
                             say_failure(places.error());
                             return;
                         }
                         for (const Eigen::Vector3d& place : *places) {
                             table_->add_place(place);
                         }
                         table_->setCurrentCell(std::max(0, table_->next_to_measure(-1)), 0);
                         say(tr("Places read from %1: %2.").arg(file).arg(places->size()));
                     });
}

std::optional<Eigen::Vector3d> RangeWindow::known_in_left_mm(int row) const {
    const auto known = table_->known_mm(row);
    const QString frame = frame_->currentData().toString();
    if (!known || frame == QLatin1String("own")) {
        return std::nullopt;
    }
    const Rig& rig = table_->readings(row).empty() ? rig_ : measured_by_;
    return frame == QLatin1String("rig") ? rig.left.T_camera_from_rig * *known : *known;
}

// What was measured by one rig is judged by its baseline.
bool RangeWindow::refuse_other_rig() {
    if (table_->measured() == 0) {
        measured_by_ = rig_;
        return false;
    }
    if (rig_to_text(measured_by_) == rig_to_text(rig_)) {
        return false;
    }
    say_failure(tr("The places so far were measured by another rig. Clear the table first."));
    return true;
}

void RangeWindow::measure(bool on) {
    const int row = table_->currentRow();
    if (!on || row < 0 || refuse_other_rig()) {
        stop();
        return;
    }
    doing_ = Doing::measuring;
    row_ = row;
    readings_.clear();
    say({});
    show_live(row_, readings_);
    changed();
}

void RangeWindow::simulate(bool on) {
    const auto may_begin = [this] {
        return may_drop(tr("Begin without saving")) &&
               ((simulated_ && !has_targets_) || may_replace_source());
    };
    if (!on || !may_begin()) {
        const bool was_running = doing_ == Doing::running;
        stop();
        if (was_running && table_->measured() > 0) {
            judge();
        }
        return;
    }
    table_->remove_all();
    row_of_station_.clear();
    saved_ = true;
    frame_->setCurrentIndex(frame_->findData(QStringLiteral("left")));
    doing_ = Doing::waiting;
    say(tr("The simulated rig is being opened at its first station\u2026"));
    changed();
    emit stations_asked();
}

void RangeWindow::stop() {
    doing_ = Doing::nothing;
    readings_.clear();
    changed();
}

void RangeWindow::begin_run(const Snapshot& snapshot) {
    const Rectangle rectangle = stations_.target(snapshot.frame);
    chosen_px_ = Eigen::Vector2d(rectangle.centre_x_px(), rectangle.centre_y_px());
    chosen_frame_ = snapshot.frame;
    measured_by_ = rig_;
    emit command_asked(SelectTemplate{rectangle, snapshot.frame});
    emit command_asked(StartTracking{});
    say(tr("The target goes to %1 places by itself, a second each.").arg(stations_.count));
}

void RangeWindow::show_snapshot(const SnapshotPtr& snapshot) {
    const bool sure = show_target(*target_, *snapshot);
    if (snapshot->frame == last_frame_) {
        return;
    }
    last_frame_ = snapshot->frame;
    has_targets_ = !snapshot->tracks.empty();
    if (doing_ == Doing::running && !chosen_px_ && snapshot->pictures.stereo.left.picture) {
        begin_run(*snapshot);
        return;
    }
    const TrackEstimate estimate = steered_estimate(*snapshot);
    if (!sure) {
        return;
    }
    if (doing_ == Doing::measuring) {
        take_reading(estimate.position->point_in_left_mm);
    } else if (doing_ == Doing::running) {
        add_of_station(*snapshot, estimate.position->point_in_left_mm);
    }
}

void RangeWindow::take_reading(const Eigen::Vector3d& point_in_left_mm) {
    readings_.push_back(point_in_left_mm);
    show_live(row_, readings_);
    if (static_cast<int>(readings_.size()) < count_->value()) {
        return;
    }
    table_->set_readings(row_, readings_);
    saved_ = false;
    const int next = table_->next_to_measure(row_);
    const Spread told = spread_of(readings_);
    stop();
    if (!told.steady) {
        say_failure(tr("The target moved while place %1 was measured: its readings lie %2 about "
                       "their mean. Let it stand still and measure there again.")
                        .arg(row_ + 1)
                        .arg(millimetres(told.rms_mm)));
        return;
    }
    if (next >= 0) {
        table_->setCurrentCell(next, 0);
        say(tr("Place %1 is measured. Bring the target to place %2, then measure.")
                .arg(row_ + 1)
                .arg(next + 1));
    } else {
        say_done(tr("All places are measured. Judge them."));
    }
}

void RangeWindow::add_of_station(const Snapshot& snapshot,
                                 const Eigen::Vector3d& point_in_left_mm) {
    const int station = stations_.station_in(snapshot.frame);
    const auto known = stations_.known_in_left_mm(*chosen_px_, chosen_frame_, snapshot.frame);
    if (station < 0 || !known) {
        return;
    }
    const auto found = row_of_station_.find(station);
    const int row = found != row_of_station_.end() ? found->second : table_->add_place(*known);
    row_of_station_[station] = row;
    std::vector<Eigen::Vector3d> readings = table_->readings(row);
    readings.push_back(point_in_left_mm);
    show_live(row, readings);
    table_->set_readings(row, readings);
    table_->setCurrentCell(row, 0);
    saved_ = false;
    refresh_differences();
    if (station + 1 == stations_.count && readings.size() >= 10) {
        stop();
        judge();
    }
}

void RangeWindow::show_live(int row, const std::vector<Eigen::Vector3d>& readings) {
    if (readings.empty()) {
        live_->setText(tr("Place %1: waiting for the tracked target\u2026").arg(row + 1));
        return;
    }
    const Spread told = spread_of(readings);
    const Eigen::Vector3d mean = told.mean_mm;
    QString text = tr("Place %1, reading %2: ").arg(row + 1).arg(readings.size());
    if (const auto known = known_in_left_mm(row)) {
        const Eigen::Vector3d off = mean - *known;
        text += tr("estimate less truth x %1, y %2, z %3; range %4")
                    .arg(millimetres(off.x(), 2), millimetres(off.y(), 2), millimetres(off.z(), 2),
                         percent(mean.norm() / known->norm() - 1.0, 3));
    } else {
        text += tr("x %1, y %2, z %3")
                    .arg(millimetres(mean.x()), millimetres(mean.y()), millimetres(mean.z()));
    }
    live_->setText(text + tr("; spread %1").arg(millimetres(told.rms_mm)));
}

void RangeWindow::refresh_differences() {
    for (int row = 0; row < table_->rowCount(); ++row) {
        const auto known = known_in_left_mm(row);
        const auto& readings = table_->readings(row);
        if (!known || readings.empty()) {
            table_->show_difference(row, std::nullopt);
            continue;
        }
        const Eigen::Vector3d mean = spread_of(readings).mean_mm;
        table_->show_difference(
            row,
            PlaceTable::Difference{mean - *known, 100.0 * (mean.norm() / known->norm() - 1.0)});
    }
}

void RangeWindow::changed() {
    const bool idle = doing_ == Doing::nothing;
    const int row = table_->currentRow();
    empty_->setVisible(table_->rowCount() == 0);
    table_->setVisible(table_->rowCount() > 0);
    for (QWidget* part : std::initializer_list<QWidget*>{load_, add_, frame_}) {
        part->setEnabled(idle);
    }
    table_->setEditTriggers(idle ? QAbstractItemView::DoubleClicked |
                                       QAbstractItemView::EditKeyPressed |
                                       QAbstractItemView::AnyKeyPressed
                                 : QAbstractItemView::NoEditTriggers);
    remove_->setEnabled(idle && row >= 0);
    clear_->setEnabled(idle && table_->rowCount() > 0);
    const bool place_known = row >= 0 && table_->known_mm(row);
    const bool measuring = doing_ == Doing::measuring;
    measure_->setEnabled(measuring || (idle && place_known && rig_.right));
    measure_->setChecked(measuring);
    measure_->setText(measuring ? tr("&Stop measuring") : tr("&Measure"));
    measure_->setToolTip(!rig_.right   ? tr("Positions need a rig of two cameras.")
                         : place_known ? tr("Averages the tracked target's next positions.")
                                       : tr("Choose a place whose coordinates are known."));
    const bool simulating = doing_ == Doing::waiting || doing_ == Doing::running;
    simulate_->setEnabled(idle || simulating);
    simulate_->setChecked(simulating);
    simulate_->setText(simulating ? tr("St&op the simulation") : tr("S&imulated experiment"));
    judge_->setEnabled(idle && table_->measured() > 0);
    judge_->setToolTip(table_->measured() > 0 ? QString() : tr("Measure a place first."));
    refresh_differences();
}

void RangeWindow::judge() {
    std::vector<RangeStation> stations;
    const bool in_rig = frame_->currentData() == QStringLiteral("rig");
    for (int row = 0; row < table_->rowCount(); ++row) {
        const auto known = table_->known_mm(row);
        if (table_->readings(row).empty()) {
            continue;
        }
        if (!known) {
            say_failure(tr("Place %1 has no coordinates. Write them, or remove it.").arg(row + 1));
            return;
        }
        stations.push_back({in_rig ? measured_by_.left.T_camera_from_rig * *known : *known,
                            table_->readings(row)});
    }
    RangeExperimentOptions options;
    options.baseline_mm = baseline_mm(measured_by_);
    options.fit_frame = frame_->currentData() == QStringLiteral("own");
    if (by_tape_->isChecked()) {
        options.true_baseline_mm = true_baseline_mm_->value();
    }
    background_->run(
        [stations = std::move(stations), options] { return judge_ranges(stations, options); },
        [this, baseline = options.baseline_mm](const Result<RangeExperiment>& judged) {
            show_judged(judged, baseline);
        });
}

void RangeWindow::show_judged(const Result<RangeExperiment>& judged, double baseline) {
    if (!judged) {
        say_failure(judged.error());
        return;
    }
    experiment_ = *judged;
    baseline_mm_ = baseline;
    saved_ = false;
    result_->show_experiment(*judged, baseline);
    tabs_->setTabEnabled(1, true);
    tabs_->setCurrentIndex(1);
    const int left_out = table_->rowCount() - table_->measured();
    const int missed =
        row_of_station_.empty() ? 0 : stations_.count - static_cast<int>(row_of_station_.size());
    say(left_out > 0
            ? tr("Places that took no part, since they were not measured: %1.").arg(left_out)
        : missed > 0 ? tr("Simulated places that the target was not followed to: %1.").arg(missed)
                     : QString());
}

void RangeWindow::save(const QString& file, bool page) {
    if (!experiment_) {
        return;
    }
    background_->run(
        [ports = ports_, experiment = *experiment_, baseline = baseline_mm_, page,
         path = file.toStdString()] {
            return write_text_file_atomically(path, page ? ports.range_page(experiment, baseline)
                                                         : ports.range_table(experiment));
        },
        [this, file](const Result<Done>& written) {
            if (!written) {
                say_failure(written.error());
                return;
            }
            saved_ = true;
            say_done(tr("Saved: %1").arg(file));
        });
}

QString RangeWindow::unsaved() const {
    if (!saved_ && table_->measured() > 0) {
        return tr("The measured places have not been saved.");
    }
    const int typed = table_->typed_only();
    return typed > 0
               ? tr("Places that were typed and not measured yet would be lost: %1.").arg(typed)
               : QString();
}

void RangeWindow::leave() {
    stop();
    say({});
}

}  // namespace kambara::ui
