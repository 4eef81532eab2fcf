// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/pan_tilt_panel.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/core_text.h"
#include "ui/base/field_manners.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/devices/hand_drive.h"
#include "ui/devices/head_stick.h"
#include "ui/devices/lens_controls.h"
#include "ui/devices/pan_tilt_pad.h"

namespace kambara::ui {
namespace {

constexpr int first_speed_percent = 30;
constexpr int most_map_height_px = 130;
constexpr int note_lines = 3;  // a fault with its remedy

bool is_followed(const Snapshot& snapshot) {
    const TrackState state = steered_estimate(snapshot).state;
    return state != TrackState::idle && state != TrackState::template_set;
}

}  // namespace

PanTiltPanel::PanTiltPanel(const QList<QAction*>& actions, HandDrive* drive, QWidget* parent)
    : QWidget(parent),
      drive_(drive),
      scrolled_(new QScrollArea(this)),
      controls_(new QWidget),
      angles_(new QLabel(this)),
      note_(new QLabel(this)) {
    auto* all = new QVBoxLayout(this);
    all->setSpacing(4);
    all->setContentsMargins(6, 4, 6, 0);
    build_buttons(all, actions);
    angles_->setObjectName(QStringLiteral("headAngles"));
    note_->setObjectName(QStringLiteral("headNote"));
    note_->setWordWrap(true);
    note_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    // Kept free, so that nothing moves away under the mouse when a sentence comes or goes.
    note_->setFixedHeight(note_lines * note_->fontMetrics().lineSpacing());
    all->addWidget(angles_);
    all->addWidget(note_);
    scrolled_->setWidgetResizable(true);
    scrolled_->setFrameShape(QFrame::NoFrame);
    scrolled_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scrolled_->setFocusPolicy(Qt::NoFocus);
    scrolled_->setMinimumHeight(1);  // else low screens would have no room for the window
    auto* column = new QVBoxLayout(controls_);
    column->setSpacing(4);
    column->setContentsMargins(0, 0, 4, 4);
    build_controls(column);
    scrolled_->setWidget(controls_);
    all->addWidget(scrolled_, 1);
    FieldManners::teach(controls_);
    connect(stick_, &HeadStick::held, drive_, [this](const QPointF& deflection) {
        drive_->hold(HandDrive::Source::stick, deflection);
    });
    connect(stick_, &HeadStick::let_go, drive_,
            [this] { drive_->release(HandDrive::Source::stick); });
    connect(drive_, &HandDrive::dropped, stick_, &HeadStick::spring_back);
    connect(lens_, &LensControls::asked, this, &PanTiltPanel::asked);
}

void PanTiltPanel::build_controls(QBoxLayout* column) {
    auto* row = new QHBoxLayout;
    stick_ = new HeadStick(controls_);
    stick_->setObjectName(QStringLiteral("headStick"));
    pad_ = new PanTiltPad(controls_);
    pad_->setObjectName(QStringLiteral("panTiltPad"));
    row->addWidget(stick_);
    row->addWidget(pad_, 1);
    pad_->setMaximumHeight(most_map_height_px);
    column->addLayout(row, 1);
    lens_ = new LensControls(controls_);
    build_speed(column);
    column->addWidget(lens_);
    column->addStretch();
}

void PanTiltPanel::build_speed(QBoxLayout* column) {
    auto* row = new QHBoxLayout;
    speed_ = new QSlider(Qt::Horizontal, controls_);
    speed_->setObjectName(QStringLiteral("driveSpeed"));
    speed_->setAccessibleName(tr("Speed"));
    speed_->setRange(5, 100);
    speed_->setPageStep(10);
    speed_->setToolTip(
        tr("How fast arrow keys, stick and gamepad turn the head at most. Zoomed in they turn it "
           "more slowly by themselves."));
    speed_text_ = new QLabel(controls_);
    speed_text_->setObjectName(QStringLiteral("driveSpeedText"));
    speed_text_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    auto* label = new QLabel(tr("Speed"), controls_);
    label->setMinimumWidth(lens_->labels_px());
    row->setSpacing(6);
    row->addWidget(label);
    row->addWidget(speed_, 1);
    row->addWidget(speed_text_);
    column->addLayout(row);
    connect(speed_, &QSlider::valueChanged, this,
            [this](int value) { drive_->set_speed_share(0.01 * value); });
    speed_->setValue(first_speed_percent);
}

void PanTiltPanel::build_buttons(QBoxLayout* column, const QList<QAction*>& actions) {
    constexpr int columns = 2;
    auto* grid = new QGridLayout;
    grid->setSpacing(4);
    int place = 0;
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        grid->addWidget(button, place / columns, place % columns);
        ++place;
    }
    column->addLayout(grid);
}

QString PanTiltPanel::told(const ServoSnapshot& servo) {
    if (servo.alone) {
        return tr("Followed by the pan-tilt picture alone.");
    }
    return servo.pan_tilt_px ? tr("Followed in the pan-tilt picture, too.")
                             : tr("Not seen for sure in the pan-tilt picture.");
}

QSize PanTiltPanel::sizeHint() const {
    const QSize around = layout()->minimumSize() - QSize(0, scrolled_->minimumHeight());
    return {std::max(around.width(), controls_->sizeHint().width()),
            around.height() + controls_->sizeHint().height()};
}

QSize PanTiltPanel::minimumSizeHint() const {
    return {260, layout()->minimumSize().height()};
}

void PanTiltPanel::show_snapshot(const SnapshotPtr& snapshot) {
    const auto& head = snapshot->head;
    const bool drives = head && head->abilities.drive;
    pad_->setEnabled(head.has_value());
    pad_->show_head(head);
    stick_->allow(drives, head ? tr("This head can't be turned at a speed: use the map.")
                               : tr("There is no pan-tilt head."));
    speed_->setEnabled(drives);
    drive_->show_head(head);
    lens_->show_head(head);
    const HeadLimits limits = head ? head->limits : HeadLimits{};
    speed_text_->setText(
        tr("%1/s").arg(degrees(0.01 * speed_->value() * limits.pan_speed_rad_s, 0)));
    if (!head) {
        angles_->setText(tr("There is no pan-tilt head."));
        note_->clear();
        return;
    }
    pad_->set_limits(limits);
    const bool faulty = !head->fault.empty();
    angles_->setText(tr("pan %1   tilt %2   %3")
                         .arg(degrees(head->angles.pan_rad), degrees(head->angles.tilt_rad),
                              faulty                   ? tr("as it last said")
                              : !head->automatic       ? tr("by hand")
                              : is_followed(*snapshot) ? tr("steered to the target")
                                                       : tr("waits for a target")));
    if (faulty) {
        note_->setText(translated(head->fault));
        note_->setStyleSheet(QStringLiteral("color: %1").arg(theme::bad.name()));
    } else {
        const bool follows = !head->at_limit && snapshot->servo && snapshot->servo->on;
        note_->setText(head->at_limit ? tr("The target is beyond the head's reach.")
                       : follows      ? told(*snapshot->servo)
                                      : QString());
        note_->setStyleSheet(follows ? QString()
                                     : QStringLiteral("color: %1").arg(theme::caution.name()));
    }
    note_->setToolTip(note_->text());
}

}  // namespace kambara::ui
