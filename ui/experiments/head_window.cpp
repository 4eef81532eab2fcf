// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/head_window.h"

#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <algorithm>
#include <cmath>

#include "core/camera/rig_file.h"
#include "core/pointing/aim.h"
#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/experiments/background.h"
#include "ui/experiments/save_row.h"

namespace kambara::ui {
namespace {

constexpr std::int64_t looking_ms = 20000;
constexpr double still_rad = rad_from_deg(0.2);
constexpr std::int64_t still_ms = 1500;
constexpr double held_at_mm = 950.0;  // before the head's camera

Eigen::Vector3d middle_of(const Target& target) {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const auto corners = corners_in_target_mm(target);
    for (const Eigen::Vector3d& corner : corners) {
        middle += corner / static_cast<double>(corners.size());
    }
    return middle;
}

}  // namespace

HeadWindow::HeadWindow(const ExperimentPorts& ports, QWidget* parent)
    : AssistantWindow(QStringLiteral("headWindow"), tr("Head calibration"), parent),
      ports_(ports),
      background_(new Background(this)) {
    clock_.start();
    resize(1120, 700);
    build();
    connect_all();
    changed();
}

HeadWindow::~HeadWindow() = default;

void HeadWindow::connect_all() {
    connect(go_, &QPushButton::clicked, this, &HeadWindow::go);
    connect(one_, &QPushButton::clicked, this, [this] {
        if (newest_ && hindrance().isEmpty()) {
            record(newest_, {});
        }
    });
    connect(load_, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getOpenFileName(this, tr("Record of head views"), {},
                                                          tr("Tables (*.csv);;All files (*)"));
        if (!file.isEmpty()) {
            load(file);
        }
    });
    connect(clear_, &QPushButton::clicked, this, [this] {
        if (may_drop(tr("Clear without saving"))) {
            recorded_.clear();
            clear_result();
            rig_saved_ = record_saved_ = true;
            table_->setRowCount(0);
            changed();
        }
    });
    connect(solve_, &QPushButton::clicked, this, &HeadWindow::solve);
    connect(save_rig_, &SaveRow::save_asked, this, &HeadWindow::save_rig);
    connect(save_record_, &SaveRow::save_asked, this, &HeadWindow::save_record);
    for (SaveRow* row : {save_rig_, save_record_}) {
        connect(row, &SaveRow::failed, this, [this](const QString& text) { say_failure(text); });
    }
}

void HeadWindow::set_hand(const TargetHand& hand, bool simulated) {
    hand_ = hand;
    simulated_ = simulated;
    held_ = false;
}

void HeadWindow::set_source(const Rig& rig) {
    const bool waited = doing_ == Doing::opening && hand_;
    if (doing_ != Doing::nothing && !waited) {
        stop();
        say(tr("Another source was opened: recording ended."));
    }
    rig_ = rig;
    newest_.reset();
    if (waited) {
        doing_ = Doing::looking;
        since_ms_ = clock_.elapsed();
        hold_target();
    }
    changed();
}

// Why nothing can be recorded; empty where it can.
QString HeadWindow::hindrance() const {
    if (!newest_) {
        return tr("No source is open: open one in the main window.");
    }
    if (!rig_.right || !rig_.pan_tilt) {
        return tr(
            "The rig in use does not hold all three cameras: calibrate them first, with the "
            "head at home (Calibration > Calibrate).");
    }
    if (!newest_->head) {
        return tr(
            "This source has no pan-tilt head: a record of the command line's can be loaded.");
    }
    if (!newest_->pictures.pan_tilt.picture) {
        return tr("The head's camera delivers no pictures: a record can be loaded instead.");
    }
    return {};
}

std::optional<Target> HeadWindow::target() {
    const auto parsed = parse_target(target_->currentText().trimmed().toStdString());
    if (!parsed) {
        say_failure(parsed.error());
        return std::nullopt;
    }
    return *parsed;
}

void HeadWindow::go(bool on) {
    const auto shown = on ? target() : std::nullopt;
    if (!shown) {
        break_off();
        return;
    }
    const QString why_not = hindrance();
    if (!why_not.isEmpty()) {
        stop();
        say_failure(why_not);
        return;
    }
    ++run_;
    const std::string name = to_string(*shown);
    if (simulated_ && hand_.target != name) {
        if (newest_ && !newest_->tracks.empty() && !may_replace_source()) {
            stop();
            return;
        }
        doing_ = Doing::opening;
        say(tr("The simulated rig is being opened with this target\u2026"));
        changed();
        emit simulated_target_asked(QString::fromStdString(name));
        return;
    }
    doing_ = Doing::looking;
    since_ms_ = clock_.elapsed();
    hold_target();
    changed();
}

// A simulated target is held where the head's camera looks at home, facing the rig.
void HeadWindow::hold_target() {
    const auto held = parse_target(hand_.target);
    if (!hand_ || !held || !rig_.pan_tilt) {
        return;
    }
    const Eigen::Vector3d place_in_rig =
        rig_.pan_tilt->T_camera_from_rig.inverse() * Eigen::Vector3d(0.0, 0.0, held_at_mm);
    RigidTransform T_left_from_target = rig_.left.T_camera_from_rig;
    T_left_from_target.R = T_left_from_target.R * rig_.pan_tilt->T_camera_from_rig.R.transpose();
    T_left_from_target.t_mm =
        rig_.left.T_camera_from_rig * place_in_rig - T_left_from_target.R * middle_of(*held);
    hand_.hold(T_left_from_target, false);
    held_ = true;
}

// On its way to a position the head is halted as well.
void HeadWindow::break_off() {
    if (doing_ == Doing::going && sequence_.going() && asked_) {
        emit command_asked(HaltHead{});
    }
    stop();
}

void HeadWindow::stop() {
    ++run_;
    doing_ = Doing::nothing;
    detecting_ = false;
    sequence_.end();
    asked_.reset();
    seen_at_.reset();
    changed();
}

void HeadWindow::show_snapshot(const SnapshotPtr& snapshot) {
    const bool first = newest_ == nullptr;
    newest_ = snapshot;
    const QString why_not = hindrance();
    QString text = why_not;
    if (why_not.isEmpty()) {
        const HeadSnapshot& head = *snapshot->head;
        text = tr("The head looks at pan %1, tilt %2.")
                   .arg(degrees(head.angles.pan_rad, 2), degrees(head.angles.tilt_rad, 2));
        if (doing_ == Doing::going && sequence_.going()) {
            text += QLatin1Char(' ') +
                    tr("Position %1 of %2.").arg(sequence_.number() + 1).arg(sequence_.count());
        }
    }
    if (state_->text() != text) {
        state_->setText(text);
    }
    if (first) {
        changed();
    }
    if (doing_ == Doing::looking) {
        look_for_target(snapshot);
    } else if (doing_ == Doing::going) {
        go_on(snapshot);
    }
}

void HeadWindow::look_for_target(const SnapshotPtr& snapshot) {
    const auto shown = target();
    const StereoFrame& pair = snapshot->pictures.stereo;
    if (detecting_ || !shown || !hindrance().isEmpty() || !pair.right.picture) {
        return;
    }
    detecting_ = true;
    if (!seen_at_) {
        say(tr("Looking for the target in the left and the right picture\u2026"));
    }
    background_->run(
        [rig = rig_, shown = *shown, left = pair.left.picture,
         right = pair.right.picture]() -> Result<HeadAngles> {
            const auto T = target_in_rig(rig, shown, *left, *right);
            if (!T) {
                return T.error();
            }
            return angles_towards(rig, rig.left.T_camera_from_rig * (*T * middle_of(shown)));
        },
        [this, run = run_](const Result<HeadAngles>& towards) {
            if (run != run_ || doing_ != Doing::looking) {
                return;
            }
            detecting_ = false;
            if (!newest_->head) {
                return;
            }
            if (!towards) {
                if (clock_.elapsed() - since_ms_ > looking_ms) {
                    stop();
                    say_failure(towards.error());
                }
                return;
            }
            // A target that is still being moved is somewhere else in the next pictures.
            if (!seen_at_ || std::abs(seen_at_->pan_rad - towards->pan_rad) > still_rad ||
                std::abs(seen_at_->tilt_rad - towards->tilt_rad) > still_rad) {
                seen_at_ = *towards;
                since_ms_ = clock_.elapsed();
            }
            if (clock_.elapsed() - since_ms_ < still_ms) {
                say(tr("The target is seen. Hold it still\u2026"));
                return;
            }
            auto steps = head_steps_about(*towards, newest_->head->limits);
            if (steps.size() < 8) {
                stop();
                say_failure(
                    tr("The target stands too far to the side for the head to turn about "
                       "it. Put it nearer to the middle."));
                return;
            }
            sequence_.begin(std::move(steps));
            doing_ = Doing::going;
            say(tr("The head goes to %1 positions. Keep the target still; F12 stops the head.")
                    .arg(sequence_.count()));
        });
}

// Somebody else's command to the head ends the round: two hands on it do no good.
bool HeadWindow::moved_by_other(const HeadSnapshot& head) {
    if (!asked_) {
        return false;
    }
    if (!taken_) {
        taken_ = head.commanded == asked_ && !head.automatic;
        return false;
    }
    return head.automatic || head.commanded != asked_;
}

void HeadWindow::go_on(const SnapshotPtr& snapshot) {
    if (!hindrance().isEmpty()) {
        stop();
        return;
    }
    const HeadSnapshot& head = *snapshot->head;
    if (moved_by_other(head)) {
        stop();
        say(
            tr("The head was stopped or moved by other means: the round ended. What was recorded "
               "is kept."));
        return;
    }
    const HeadSequence::Request request = sequence_.see(head, clock_.elapsed());
    switch (request.asks) {
        case HeadSequence::Asks::nothing:
            break;
        case HeadSequence::Asks::move:
            asked_ = request.angles;
            taken_ = false;
            emit command_asked(MoveHead{request.angles});
            break;
        case HeadSequence::Asks::view:
            record(snapshot, sequence_.step().approach);
            break;
        case HeadSequence::Asks::give_up:
            say_failure(tr("The head did not get to pan %1, tilt %2 within 15 seconds. Check its "
                           "line and that nothing blocks it, then go on.")
                            .arg(degrees(asked_->pan_rad), degrees(asked_->tilt_rad)));
            stop();
            break;
    }
}

int HeadWindow::views() const {
    return static_cast<int>(std::count_if(recorded_.begin(), recorded_.end(),
                                          [](const auto& one) { return one.view.has_value(); }));
}

QString HeadWindow::unsaved() const {
    if (result_ && !rig_saved_) {
        return tr("The head's model that was found has not been saved.");
    }
    return !recorded_.empty() && !record_saved_ && !(result_ && rig_saved_)
               ? tr("The recorded views have not been saved.")
               : QString();
}

void HeadWindow::leave() {
    break_off();
    if (held_ && hand_) {
        hand_.let_go();
        held_ = false;
    }
    say({});
}

}  // namespace kambara::ui
