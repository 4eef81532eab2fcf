// SPDX-License-Identifier: GPL-3.0-or-later
// What the head's calibration came to, and where it goes.
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <cmath>
#include <filesystem>

#include "core/base/digits.h"
#include "core/base/text_file.h"
#include "core/camera/rig_file.h"
#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/experiments/background.h"
#include "ui/experiments/head_window.h"
#include "ui/experiments/save_row.h"

namespace kambara::ui {
namespace {

const QString none = QStringLiteral("\u2013");

struct Solved {
    Result<HeadCalibration> result;
    std::vector<std::optional<double>> rms_rad;  // of every recorded view
};

QString with_sigma(const QString& value, const QString& sigma) {
    return QStringLiteral("%1  \u00B1 %2").arg(value, sigma);
}

const char* side_name(int side) {
    return side > 0 ? "below" : side < 0 ? "above" : "";
}

}  // namespace

void HeadWindow::fill_row(int row) {
    const HeadRecorded& one = recorded_.at(static_cast<std::size_t>(row));
    const auto side = [](int from) {
        return from > 0 ? tr("below") : from < 0 ? tr("above") : none;
    };
    const QString cells[] = {
        degrees(one.encoder.pan_rad, 2),
        degrees(one.encoder.tilt_rad, 2),
        side(one.approach.pan) + QStringLiteral(" / ") + side(one.approach.tilt),
        one.view ? QString::number(one.view->sightings.size()) : none,
        one.rms_rad ? degrees(*one.rms_rad, 4) : none,
        translated(one.reason)};
    int column = 0;
    for (const QString& cell : cells) {
        auto* item = new QTableWidgetItem(cell);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        if (!one.view) {
            item->setForeground(theme::caution);
        }
        item->setToolTip(column == 5 ? cell : QString());
        table_->setItem(row, column++, item);
    }
}

void HeadWindow::clear_result() {
    result_.reset();
    for (HeadRecorded& one : recorded_) {
        one.rms_rad.reset();
    }
    show_result();
}

void HeadWindow::solve() {
    std::vector<std::optional<HeadView>> all;
    std::vector<HeadView> views;
    for (const HeadRecorded& one : recorded_) {
        all.push_back(one.view);
        if (one.view) {
            views.push_back(*one.view);
        }
    }
    say(tr("Solving\u2026"));
    background_->run(
        [rig = recorded_by_, all = std::move(all), views = std::move(views)] {
            Solved solved{calibrate_head(rig, views), {}};
            for (const auto& view : all) {
                solved.rms_rad.push_back(
                    view && solved.result
                        ? view_rms_rad(rig, solved.result->model_for_given_rig, *view)
                        : std::nullopt);
            }
            return solved;
        },
        [this](const Solved& solved) {
            if (!solved.result) {
                say_failure(solved.result.error());
                return;
            }
            if (solved.rms_rad.size() != recorded_.size()) {
                say({});
                return;  // more was recorded meanwhile: this says nothing of it
            }
            result_ = *solved.result;
            rig_saved_ = false;
            for (std::size_t i = 0; i < recorded_.size(); ++i) {
                recorded_[i].rms_rad = solved.rms_rad[i];
                fill_row(static_cast<int>(i));
            }
            show_result();
            changed();
            say({});
        });
}

void HeadWindow::show_result() {
    const bool known = result_.has_value();
    save_rig_->allow(known, tr("Solve first: there is no model to save."));
    if (!known) {
        for (QLabel* label : {rms_, rms_deg_, without_, ahead_, arm_, skew_, pan_backlash_,
                              tilt_backlash_, by_rig_}) {
            label->setText(none);
        }
        verdict_->setText(
            tr("No model yet: it takes 8 views, over 20\u00B0 of pan and 10\u00B0 of "
               "tilt."));
        return;
    }
    const HeadCalibration& found = *result_;
    const HeadModel& model = found.model;
    double squares = 0.0;
    double points = 0.0;
    for (const HeadRecorded& one : recorded_) {
        if (one.view && one.rms_rad) {
            const auto count = static_cast<double>(one.view->sightings.size());
            squares += count * *one.rms_rad * *one.rms_rad;
            points += count;
        }
    }
    verdict_->setText(tr("%1 views, %2 points").arg(found.views).arg(found.points));
    rms_->setText(pixels(found.rms_px, 3));
    rms_deg_->setText(points > 0.0 ? degrees(std::sqrt(squares / points), 4) : none);
    without_->setText(pixels(found.rms_without_model_px, 3));
    ahead_->setText(with_sigma(millimetres(model.tilt_axis_ahead_mm, 2),
                               millimetres(found.tilt_axis_ahead_sigma_mm, 2)));
    QStringList arms;
    const char* const axes[] = {"x", "y", "z"};
    for (int axis = 0; axis < 3; ++axis) {
        arms << QLatin1String(axes[axis]) + QLatin1Char(' ') +
                    with_sigma(millimetres(model.T_camera_from_tilt.t_mm[axis], 2),
                               millimetres(found.camera_from_tilt_sigma_mm[axis], 2));
    }
    arm_->setText(arms.join(QLatin1Char('\n')));
    skew_->setText(degrees(model.tilt_axis_skew_rad, 3));
    const auto backlash = [](bool seen, double rad, double sigma_rad) {
        return seen ? with_sigma(degrees(rad, 4), degrees(sigma_rad, 4))
                    : tr("not measured: no views from both sides");
    };
    pan_backlash_->setText(
        backlash(found.pan_backlash_seen, model.pan_backlash_rad, found.pan_backlash_sigma_rad));
    tilt_backlash_->setText(
        backlash(found.tilt_backlash_seen, model.tilt_backlash_rad, found.tilt_backlash_sigma_rad));
    by_rig_->setText(found.by_rig
                         ? tr("its own calibration took part; moved most: %1, by %2 of its "
                              "deviations")
                               .arg(QString::fromStdString(found.by_rig->most_moved),
                                    QLocale().toString(found.by_rig->most_moved_sigmas, 'f', 1))
                         : tr("held: it does not tell how well it is known"));
}

void HeadWindow::save_rig(const QString& file) {
    if (!result_) {
        return;
    }
    background_->run(
        [rig = with_head_model(recorded_by_, result_->model_for_given_rig),
         path = file.toStdString()] { return write_rig_file(path, rig); },
        [this, file](const Result<Done>& written) {
            if (!written) {
                say_failure(written.error());
                return;
            }
            rig_saved_ = true;
            say_done(tr("Saved: %1. Open the source with this rig file to steer by it.").arg(file));
        });
}

// As the command line's record: the table, and the pictures in folders beside it.
void HeadWindow::save_record(const QString& file) {
    std::vector<HeadRecorded> taken;
    for (const HeadRecorded& one : recorded_) {
        if (one.pictures.left) {
            taken.push_back(one);
        }
    }
    background_->run(
        [taken = std::move(taken), write = ports_.write_picture,
         path = std::filesystem::path(file.toStdString())]() -> Result<Done> {
            std::string table = "left,right,pan_tilt,pan_deg,tilt_deg,pan_from,tilt_from\n";
            for (std::size_t i = 0; i < taken.size(); ++i) {
                const HeadRecorded& one = taken[i];
                const std::pair<const char*, const Image*> pictures[] = {
                    {"left", one.pictures.left.get()},
                    {"right", one.pictures.right.get()},
                    {"pan_tilt", one.pictures.pan_tilt.get()}};
                for (const auto& [camera, picture] : pictures) {
                    const std::string name =
                        path.stem().string() + "_" + camera + "_" + std::to_string(i) + ".png";
                    if (const auto written = write(path.parent_path() / name, *picture); !written) {
                        return written.error();
                    }
                    table += name + ",";
                }
                table += digits(deg_from_rad(one.encoder.pan_rad)) + "," +
                         digits(deg_from_rad(one.encoder.tilt_rad)) + "," +
                         side_name(one.approach.pan) + "," + side_name(one.approach.tilt) + "\n";
            }
            return write_text_file_atomically(path, table);
        },
        [this, file](const Result<Done>& written) {
            if (!written) {
                say_failure(written.error());
                return;
            }
            record_saved_ = true;
            say_done(tr("Saved: %1. calibrate-head --views reads it, too.").arg(file));
        });
}

}  // namespace kambara::ui
