// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/zoom_window.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/experiments/background.h"
#include "ui/experiments/save_row.h"

namespace kambara::ui {
namespace {

constexpr int steps = 24;  // of a lens of 12 times: a ninth larger from one to the next
constexpr double there_share = 0.004;
constexpr std::int64_t settle_ms = 700;  // until a picture from after the motion is on show
constexpr std::int64_t patience_ms = 15000;
constexpr double still_rad = rad_from_deg(0.2);
constexpr double widest_share = ZoomCalibrationOptions{}.widest_share;

const QString none = QStringLiteral("\u2013");

QString number(double value, int decimals) {
    return QLocale().toString(value, 'f', decimals);
}

}  // namespace

ZoomWindow::ZoomWindow(const ExperimentPorts& ports, QWidget* parent)
    : AssistantWindow(QStringLiteral("zoomWindow"), tr("Zoom calibration"), parent),
      ports_(ports),
      background_(new Background(this)) {
    clock_.start();
    resize(820, 680);
    build();
    connect(go_, &QPushButton::clicked, this, &ZoomWindow::go);
    connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), this,
            &ZoomWindow::show_lens_of_kind);
    for (QDoubleSpinBox* field : {widest_, sensor_}) {
        connect(field, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
                &ZoomWindow::changed);
    }
    connect(save_, &SaveRow::save_asked, this, &ZoomWindow::save);
    connect(save_, &SaveRow::failed, this, [this](const QString& text) { say_failure(text); });
    changed();
}

ZoomWindow::~ZoomWindow() = default;

void ZoomWindow::set_source(const Rig& rig) {
    if (doing_ != Doing::nothing) {
        say(tr("Another source was opened: it ended."));
    }
    // The head that was being zoomed is gone.
    ++run_;
    doing_ = Doing::nothing;
    rig_ = rig;
    newest_.reset();
    changed();
}

// Why nothing can be measured; empty where it can.
QString ZoomWindow::hindrance() const {
    if (!newest_) {
        return tr("No source is open: open one in the main window.");
    }
    if (!rig_.pan_tilt) {
        return tr(
            "The rig in use holds no pan-tilt camera: calibrate it first, at its widest "
            "(Calibration > Calibrate).");
    }
    if (!newest_->head || !newest_->head->abilities.zoom) {
        return tr("This source has no head that zooms.");
    }
    if (!newest_->head->lens) {
        return tr("The head has not told its zoom yet.");
    }
    if (!newest_->pictures.pan_tilt.picture) {
        return tr("The head's camera delivers no pictures.");
    }
    return {};
}

void ZoomWindow::go(bool on) {
    const QString why_not = hindrance();
    if (!on || !why_not.isEmpty()) {
        stop();
        if (on) {
            say_failure(why_not);
        }
        return;
    }
    if (!may_drop(tr("Measure anew")) || !hindrance().isEmpty()) {
        changed();  // or the head went while the question was open
        return;
    }
    ++run_;
    taken_.clear();
    places_.clear();
    saved_ = true;
    const HeadSnapshot& head = *newest_->head;
    zoomed_before_ = head.lens->zoom_share;
    // Steering would turn the head meanwhile.
    emit command_asked(HaltHead{});
    stood_at_ = head.angles;
    doing_ = Doing::zooming;
    say(tr("The lens goes from wide to tele. Keep the head and what it looks at still."));
    zoom_on();
    show_rows();
    changed();
}

void ZoomWindow::zoom_on() {
    picture_.reset();
    since_ms_ = clock_.elapsed();
    emit command_asked(ZoomHead{static_cast<double>(taken_.size()) / steps});
}

void ZoomWindow::stop() {
    if (doing_ == Doing::zooming) {
        emit command_asked(ZoomHead{zoomed_before_});
    }
    ++run_;
    doing_ = Doing::nothing;
    changed();
}

void ZoomWindow::show_snapshot(const SnapshotPtr& snapshot) {
    newest_ = snapshot;
    QString text = hindrance();
    if (text.isEmpty()) {
        text = tr("The lens is at zoom %1.").arg(number(snapshot->head->lens->zoom_share, 3));
        if (doing_ == Doing::zooming) {
            text += QLatin1Char(' ') + tr("Place %1 of %2.").arg(taken_.size() + 1).arg(steps + 1);
        }
    }
    if (state_->text() != text) {
        state_->setText(text);
        changed();
    }
    if (doing_ == Doing::zooming) {
        go_on();
    }
}

void ZoomWindow::go_on() {
    const QString why_not = hindrance();
    if (!why_not.isEmpty()) {
        stop();
        say_failure(why_not);
        return;
    }
    const HeadSnapshot& head = *newest_->head;
    if (taken_.empty()) {
        // It was halted a moment ago, and may have been turning.
        stood_at_ = head.angles;
    } else if (head.automatic || std::abs(head.angles.pan_rad - stood_at_.pan_rad) > still_rad ||
               std::abs(head.angles.tilt_rad - stood_at_.tilt_rad) > still_rad) {
        stop();
        say_failure(tr("The head was turned meanwhile. Keep it still, and begin again."));
        return;
    }
    const double asked = static_cast<double>(taken_.size()) / steps;
    const bool there = !head.moving && std::abs(head.lens->zoom_share - asked) < there_share;
    const Frame& frame = newest_->pictures.pan_tilt;
    if (there && !picture_) {
        picture_ = frame.index;
        since_ms_ = clock_.elapsed();
    } else if (!there) {
        picture_.reset();
    }
    const std::int64_t waited_ms = clock_.elapsed() - since_ms_;
    if (picture_ && waited_ms >= settle_ms && frame.index != *picture_ && frame.valid) {
        take();
    } else if (waited_ms > patience_ms) {
        stop();
        say_failure(there ? tr("No new picture came for 15 seconds. Check the head's camera.")
                          : tr("The lens did not get to zoom %1 within 15 seconds. Check the "
                               "head's line, then begin again.")
                                .arg(number(asked, 3)));
    }
}

void ZoomWindow::take() {
    const LensStatus& lens = *newest_->head->lens;
    // The first place is the camera's own calibration: the lens rests on its stop there.
    const double share = lens.zoom_share < widest_share && taken_.empty() ? 0.0 : lens.zoom_share;
    taken_.push_back({{share, grey_from(newest_->pictures.pan_tilt.picture)},
                      lens.horizontal_view_rad > 0.0 ? lens.magnification() : 0.0});
    show_rows();
    if (taken_.size() <= steps) {
        zoom_on();
    } else {
        measure();
    }
}

void ZoomWindow::measure() {
    doing_ = Doing::measuring;
    emit command_asked(ZoomHead{zoomed_before_});
    changed();
    say(tr("Measuring\u2026"));
    std::vector<ZoomView> views;
    for (const Taken& one : taken_) {
        views.push_back(one.view);
    }
    background_->run([camera = *rig_.pan_tilt,
                      views = std::move(views)] { return calibrate_zoom(camera, views); },
                     [this, run = run_](const Result<std::vector<ZoomPlace>>& places) {
                         if (run != run_) {
                             return;
                         }
                         doing_ = Doing::nothing;
                         if (!places) {
                             say_failure(places.error());
                         } else {
                             places_ = *places;
                             saved_ = false;
                             say({});
                         }
                         show_rows();
                         changed();
                     });
}

void ZoomWindow::show_rows() {
    table_->setRowCount(static_cast<int>(taken_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const Taken& one = taken_[static_cast<std::size_t>(row)];
        const bool measured = static_cast<std::size_t>(row) < places_.size();
        const ZoomPlace place = measured ? places_[static_cast<std::size_t>(row)] : ZoomPlace{};
        const bool by_step = measured && place.points > 0;
        const QString cells[] = {
            number(one.view.zoom_share, 3),
            measured ? number(place.magnification, 4) : none,
            by_step ? number(place.magnification_sigma, 4) : none,
            one.told_magnification > 0.0 ? number(one.told_magnification, 4) : none,
            by_step ? QString::number(place.points) : none,
            by_step ? pixels(place.rms_px, 3) : none};
        int column = 0;
        for (const QString& cell : cells) {
            auto* item = new QTableWidgetItem(cell);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
            table_->setItem(row, column++, item);
        }
    }
    table_->scrollToBottom();
    show_verdict();
}

void ZoomWindow::show_verdict() {
    double worst = -1.0;
    for (std::size_t i = 0; i < places_.size() && i < taken_.size(); ++i) {
        if (taken_[i].told_magnification > 0.0) {
            worst = std::max(
                worst, std::abs(taken_[i].told_magnification / places_[i].magnification - 1.0));
        }
    }
    verdict_->setText(places_.empty() ? QString()
                      : worst < 0.0
                          ? tr("The lens enlarges up to %1 times. The head did not know.")
                                .arg(number(places_.back().magnification, 3))
                          : tr("The lens enlarges up to %1 times. What the head's table says is "
                               "off by %2 at most.")
                                .arg(number(places_.back().magnification, 3), percent(worst, 2)));
}

void ZoomWindow::save(const QString& file) {
    std::vector<std::pair<double, double>> curve;
    for (const ZoomPlace& place : places_) {
        curve.emplace_back(place.zoom_share, place.magnification);
    }
    const auto written = ports_.write_heads(
        file.toStdString(),
        {kind_->currentText().toStdString(), widest_->value(), sensor_->value()}, curve);
    if (!written) {
        say_failure(written.error());
        return;
    }
    saved_ = true;
    say_done(tr("Saved: %1. Name it in the head's address to use it: heads=%1").arg(file));
}

QString ZoomWindow::unsaved() const {
    return places_.empty() || saved_ ? QString()
                                     : tr("The zoom's curve that was measured has not been saved.");
}

void ZoomWindow::leave() {
    stop();
    say({});
}

}  // namespace kambara::ui
