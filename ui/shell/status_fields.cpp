// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/status_fields.h"

#include <QLabel>
#include <QLocale>
#include <QStatusBar>

#include "ui/base/quantities.h"

namespace kambara::ui {

StatusFields::StatusFields(QStatusBar* bar) : QObject(bar), bar_(bar) {
    source_ = add("statusSource", tr("Where the pictures come from"), QString());
    medium_ = add("statusMedium", tr("The medium the calibration holds for"), tr("water"));
    rate_ = add("statusRate", tr("Pairs of pictures handled in a second"), hertz(1000.0));
    latency_ = add("statusLatency", tr("From a pair's arrival to its result"),
                   tr("latency %1").arg(milliseconds(1000.0)));
    lost_ =
        add("statusLost", tr("Pairs that came while the pipeline was busy, or without a partner"),
            tr("%1 lost").arg(QStringLiteral("100,000")));
}

QLabel* StatusFields::add(const char* object_name, const QString& help, const QString& widest) {
    auto* label = new QLabel(bar_);
    label->setObjectName(QLatin1String(object_name));
    label->setToolTip(help);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(widest) + 8);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    bar_->addPermanentWidget(label);
    return label;
}

void StatusFields::show_source(const QString& title, const Rig& rig) {
    source_->setText(title);
    medium_->setText(rig.medium == Medium::water ? tr("water") : tr("air"));
}

void StatusFields::show_snapshot(const Snapshot& snapshot) {
    rate_->setText(hertz(snapshot.rate_hz));
    latency_->setText(tr("latency %1").arg(milliseconds(snapshot.latency_ms)));
    lost_->setText(
        tr("%1 lost").arg(QLocale().toString(static_cast<qulonglong>(snapshot.frames_lost))));
}

}  // namespace kambara::ui
