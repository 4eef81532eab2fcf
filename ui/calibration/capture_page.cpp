// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/capture_page.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "core/calibration/session/candidate_poses.h"
#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/calibration/coverage_plot.h"
#include "ui/calibration/guide_view.h"
#include "ui/calibration/hold_pad.h"

namespace kambara::ui {
namespace {

constexpr int side_width = 340;
constexpr int least_shots = 3;
constexpr qint64 long_without_target_ms = 15000;
constexpr qint64 shot_told_ms = 1500;
constexpr qint64 failure_told_ms = 10'000;
constexpr qint64 helper_tries_again_ms = 5000;

}  // namespace

CapturePage::CapturePage(QWidget* parent) : QWidget(parent) {
    auto* page = new QHBoxLayout(this);
    auto* left = new QVBoxLayout;
    banner_ = new QLabel(this);
    banner_->setObjectName(QStringLiteral("captureBanner"));
    banner_->setWordWrap(true);
    banner_->setMargin(8);
    banner_->setMinimumHeight(3 * fontMetrics().height());
    QFont large = font();
    large.setPointSizeF(1.3 * large.pointSizeF());
    banner_->setFont(large);
    left->addWidget(banner_);
    auto* pair = new QHBoxLayout;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        views_[c] = new GuideView(c, camera_title(c), this);
        views_[c]->setObjectName(QStringLiteral("guideView%1").arg(c));
        pair->addWidget(views_[c], 1);
    }
    left->addLayout(pair, 1);
    page->addLayout(left, 1);
    auto* side = new QWidget(this);
    side->setFixedWidth(side_width);
    build_side(side);
    page->addWidget(side);
}

void CapturePage::build_side(QWidget* side) {
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    progress_text_ = new QLabel(side);
    progress_text_->setObjectName(QStringLiteral("captureProgress"));
    progress_text_->setWordWrap(true);
    progress_ = new QProgressBar(side);
    progress_->setRange(0, enough_shots);
    progress_->setTextVisible(false);
    coverage_ = new CoveragePlot(side);
    coverage_->setObjectName(QStringLiteral("coveragePlot"));
    shots_ = new QListWidget(side);
    shots_->setObjectName(QStringLiteral("shotList"));
    shots_->setToolTip(tr("Without its tick a shot is dropped: it takes no part, but is not lost"));
    auto* shot_buttons = new QHBoxLayout;
    const auto button = [&](const QString& text, const QString& tip, const char* name) {
        auto* made = new QPushButton(text, side);
        made->setToolTip(tip);
        made->setObjectName(QLatin1String(name));
        return made;
    };
    undo_ = button(tr("&Undo"), QString(), "undoDecision");
    capture_ =
        button(tr("&Take now"), tr("Takes a shot without waiting for stillness"), "captureNow");
    pause_ = button(tr("&Pause"), tr("Takes no more shots until pressed again"), "pauseCapture");
    pause_->setCheckable(true);
    for (QPushButton* one : {undo_, capture_, pause_}) {
        shot_buttons->addWidget(one);
    }
    auto* hand = new QGroupBox(tr("Simulated target"), side);
    auto* in_hand = new QVBoxLayout(hand);
    helper_ = new QCheckBox(tr("A helper follows the outline"), hand);
    helper_->setObjectName(QStringLiteral("helperFollows"));
    helper_->setChecked(true);
    helper_->setToolTip(tr("Off: hold the target yourself"));
    pad_ = new HoldPad(hand);
    in_hand->addWidget(helper_);
    in_hand->addWidget(pad_);
    hand_box_ = hand;
    hand_box_->hide();
    solving_bar_ = new QProgressBar(side);
    solving_bar_->setObjectName(QStringLiteral("solvingBar"));
    solving_bar_->setRange(0, 100);
    solving_bar_->hide();
    solve_ = button(tr("&Calibrate"), QString(), "solve");
    leave_ = button(tr("&Leave"), tr("Back to the choices; everything taken is kept in the folder"),
                    "leaveSession");
    auto* last = new QHBoxLayout;
    last->addWidget(leave_);
    last->addStretch(1);
    last->addWidget(solve_);
    for (QWidget* one : std::initializer_list<QWidget*>{progress_text_, progress_, coverage_}) {
        column->addWidget(one);
    }
    column->addWidget(new QLabel(tr("Shots"), side));
    column->addWidget(shots_, 1);
    column->addLayout(shot_buttons);
    column->addWidget(hand_box_);
    column->addWidget(solving_bar_);
    column->addLayout(last);
    connect(undo_, &QPushButton::clicked, this, &CapturePage::undo_asked);
    connect(capture_, &QPushButton::clicked, this, &CapturePage::capture_asked);
    connect(pause_, &QPushButton::toggled, this, &CapturePage::paused);
    connect(leave_, &QPushButton::clicked, this, &CapturePage::leave_asked);
    connect(solve_, &QPushButton::clicked, this,
            [this] { solving_ ? emit cancel_asked() : emit solve_asked(); });
    connect(shots_, &QListWidget::itemChanged, this, [this](QListWidgetItem* item) {
        emit kept_changed(item->data(Qt::UserRole).toInt(), item->checkState() == Qt::Checked);
    });
    connect(helper_, &QCheckBox::toggled, this, [this](bool on) {
        if (on) {
            follow_again();
        }
    });
    connect(pad_, &HoldPad::held_at, this, [this](const RigidTransform& T_left_from_target) {
        helper_->setChecked(false);
        if (hand_) {
            hand_.hold(T_left_from_target, false);
        }
    });
}

void CapturePage::set_hand(const TargetHand& hand) {
    hand_ = hand;
    hand_box_->setVisible(static_cast<bool>(hand_));
}

void CapturePage::begin(const SessionSetup& setup) {
    state_.reset();
    helper_went_for_ = -1;
    helper_->setChecked(true);
    pause_->setChecked(false);
    for (std::size_t c = 0; c < most_cameras; ++c) {
        views_[c]->clear();
        views_[c]->setVisible(setup.cameras[c].has_value());
    }
    coverage_->show_coverage({});
    since_found_.start();
    since_told_.invalidate();
    show_solving(false, 0.0);
    say(tr("Waiting for pictures\u2026"), theme::faint);
}

void CapturePage::say(const QString& text, const QColor& colour) {
    banner_->setText(text);
    banner_->setStyleSheet(QStringLiteral("background: %1; color: black").arg(colour.name()));
}

void CapturePage::show_state(const SessionStatePtr& state) {
    state_ = state;
    for (GuideView* view : views_) {
        view->show_state(*state);
    }
    coverage_->show_coverage(state->coverage);
    progress_->setValue(std::min(state->kept, enough_shots));
    const QString off = percent(state->range_error, 3);
    progress_text_->setText(
        state->kept == 0 ? tr("No shot yet; about %1 are enough.").arg(enough_shots)
        : state->kept < enough_shots
            ? tr("%1 of about %2 shots. Ranges would be off by %3 (one deviation).")
                  .arg(state->kept)
                  .arg(enough_shots)
                  .arg(off)
            : tr("%1 shots, which is enough. Ranges would be off by %2 (one deviation).")
                  .arg(state->kept)
                  .arg(off));
    fill_shots();
    fill_buttons();
    if (hand_ && helper_->isChecked() && state->kept != helper_went_for_ &&
        state->kept < enough_shots) {
        follow_again();
    }
}

void CapturePage::follow_again() {
    if (!hand_ || !state_ || !state_->next || !helper_->isChecked()) {
        return;
    }
    helper_went_for_ = state_->kept;
    hand_.hold(state_->next->T_left_from_target, true);
    // From there the user takes over.
    pad_->set_pose(state_->next->T_left_from_target,
                   middle_of(corners_in_target_mm(state_->setup.target)));
    since_hold_.start();
}

void CapturePage::show_look(const SessionLookPtr& look) {
    for (GuideView* view : views_) {
        view->show_look(*look);
    }
    const Look& seen = look->look;
    const bool any_found =
        std::any_of(seen.seen.sights.begin(), seen.seen.sights.end(),
                    [](const CameraSight& sight) { return !sight.corners.empty(); });
    if (any_found) {
        since_found_.start();
    }
    if (seen.shot) {
        since_told_.start();
        told_for_ms_ = shot_told_ms;
        say(state_ && state_->kept >= enough_shots
                ? tr("Shot %1 taken. That is enough: press Calibrate.").arg(*seen.shot)
                : tr("Shot %1 taken. Now to the next outline.").arg(*seen.shot),
            theme::good);
        return;
    }
    if (since_told_.isValid() && since_told_.elapsed() < told_for_ms_) {
        return;  // long enough to be read
    }
    const bool enough = state_ && state_->kept >= enough_shots;
    if (!enough && helper_->isChecked() && since_hold_.isValid() &&
        since_hold_.elapsed() > helper_tries_again_ms) {
        follow_again();
    }
    if (enough) {
        say(tr("Enough shots: press Calibrate. More make it a little better."), theme::good);
    } else if (since_found_.elapsed() > long_without_target_ms) {
        say(tr("No target found for a long time. Is it the one that was chosen? Hold it so that it "
               "fills a third of every picture, evenly lit."),
            theme::caution);
    } else if (state_ && !state_->next) {
        say(tr("There is no place where all cameras see the whole target: take a smaller one, or "
               "fewer cameras."),
            theme::caution);
    } else {
        say(tr("Bring the target to the blue outline in every picture and hold it still. %1")
                .arg(translated(seen.why_not)),
            theme::accent);
    }
}

void CapturePage::show_failure(const QString& text) {
    say(text, theme::bad);
    since_told_.start();
    told_for_ms_ = failure_told_ms;
}

void CapturePage::show_solving(bool under_way, double share) {
    solving_ = under_way;
    solving_bar_->setVisible(under_way);
    solving_bar_->setValue(static_cast<int>(100.0 * share));
    fill_buttons();
}

void CapturePage::fill_shots() {
    const QSignalBlocker quiet(shots_);
    shots_->clear();
    for (const Shot& shot : state_->shots) {
        int corners = 0;
        for (const CameraSight& sight : shot.seen.sights) {
            corners += static_cast<int>(sight.corners.size());
        }
        auto* item =
            new QListWidgetItem(tr("Shot %1: %2 corners").arg(shot.number).arg(corners), shots_);
        item->setData(Qt::UserRole, shot.number);
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        item->setCheckState(shot.kept ? Qt::Checked : Qt::Unchecked);
    }
    shots_->scrollToBottom();
}

void CapturePage::fill_buttons() {
    const bool can_undo = state_ && state_->can_undo;
    undo_->setEnabled(can_undo);
    undo_->setToolTip(can_undo ? tr("Takes the last dropping or keeping back")
                               : tr("No shot was dropped or kept by hand yet."));
    const bool can_solve = state_ && state_->kept >= least_shots;
    solve_->setText(solving_ ? tr("&Cancel") : tr("&Calibrate"));
    solve_->setEnabled(solving_ || can_solve);
    solve_->setToolTip(solving_    ? tr("Stops the calculation; the shots are kept")
                       : can_solve ? tr("Calculates the cameras from the shots kept")
                                   : tr("At least %1 shots are needed.").arg(least_shots));
    capture_->setEnabled(!solving_);
    leave_->setEnabled(!solving_);
}

}  // namespace kambara::ui
