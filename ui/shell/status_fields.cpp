// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/status_fields.h"

#include <QLabel>
#include <QLocale>
#include <QStatusBar>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {

StatusFields::StatusFields(QStatusBar* bar) : QObject(bar), bar_(bar) {
    gamepad_ = add("statusGamepad",
                   tr("The gamepad: left stick turns the head, triggers zoom, the right one of the "
                      "four buttons halts"),
                   QString());
    source_ = add("statusSource", tr("Where the pictures come from"), QString());
    medium_ = add("statusMedium", tr("The medium the calibration holds for"), tr("water"));
    rate_ = add("statusRate", tr("Pairs of pictures handled in a second"), hertz(1000.0));
    latency_ = add("statusLatency", tr("From a pair's arrival to its result"),
                   tr("latency %1").arg(milliseconds(1000.0)));
    show_gamepad(PadState::absent, {});
    lost_ =
        add("statusLost", tr("Pairs that came while the pipeline was busy, or without a partner"),
            tr("%1 pairs lost").arg(QStringLiteral("100,000")));
}

QLabel* StatusFields::add(const char* object_name, const QString& help, const QString& widest) {
    auto* label = new QLabel(bar_);
    label->setObjectName(QLatin1String(object_name));
    label->setToolTip(help);
    label->setContentsMargins(4, 0, 4, 0);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 8);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    bar_->addPermanentWidget(label);
    return label;
}

void StatusFields::show_gamepad(PadState state, const QString& name) {
    const auto say = [this](const QString& text, const QColor& colour) {
        gamepad_->setText(text);
        gamepad_->setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
    };
    switch (state) {
        case PadState::absent:
            say(tr("no gamepad"), theme::faint);
            break;
        case PadState::centre_first:
            say(tr("%1: let the sticks go first").arg(name), theme::caution);
            break;
        case PadState::armed:
            say(tr("%1: ready").arg(name), theme::good);
            break;
        case PadState::frozen:
            say(tr("%1: does not answer, let the sticks go").arg(name), theme::bad);
            break;
    }
}

void StatusFields::show_source(const QString& title, const Rig& rig) {
    source_->setText(title);
    medium_->setText(rig.medium == Medium::water ? tr("water") : tr("air"));
}

void StatusFields::show_snapshot(const Snapshot& snapshot) {
    rate_->setText(hertz(snapshot.rate_hz));
    latency_->setText(tr("latency %1").arg(milliseconds(snapshot.latency_ms)));
    lost_->setText(
        tr("%1 pairs lost").arg(QLocale().toString(static_cast<qulonglong>(snapshot.frames_lost))));
}

}  // namespace kambara::ui
