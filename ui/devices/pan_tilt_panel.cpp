// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/pan_tilt_panel.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/devices/pan_tilt_pad.h"

namespace kambara::ui {

PanTiltPanel::PanTiltPanel(const QList<QAction*>& actions, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setSpacing(4);
    pad_ = new PanTiltPad(this);
    pad_->setObjectName(QStringLiteral("panTiltPad"));
    column->addWidget(pad_, 1);
    angles_ = new QLabel(this);
    angles_->setObjectName(QStringLiteral("headAngles"));
    angles_->setWordWrap(true);
    column->addWidget(angles_);
    note_ = new QLabel(this);
    note_->setObjectName(QStringLiteral("headNote"));
    note_->setWordWrap(true);
    column->addWidget(note_);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    for (QAction* action : actions) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        row->addWidget(button);
    }
    column->addLayout(row);
}

void PanTiltPanel::show_snapshot(const SnapshotPtr& snapshot) {
    const auto& head = snapshot->head;
    pad_->setEnabled(head.has_value());
    pad_->show_head(head);
    if (!head) {
        angles_->setText(tr("There is no pan-tilt head."));
        note_->clear();
        return;
    }
    angles_->setText(tr("pan %1   tilt %2   %3")
                         .arg(degrees(head->angles.pan_rad), degrees(head->angles.tilt_rad),
                              head->automatic ? tr("steered to the target") : tr("by hand")));
    if (!head->fault.empty()) {
        note_->setText(translated(head->fault));
        note_->setStyleSheet(QStringLiteral("color: %1").arg(theme::bad.name()));
    } else {
        note_->setText(head->at_limit ? tr("The target is beyond the head's reach.") : QString());
        note_->setStyleSheet(QStringLiteral("color: %1").arg(theme::caution.name()));
    }
}

}  // namespace kambara::ui
