// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/target_line.h"

#include <QCoreApplication>
#include <QLabel>

#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

struct TargetLine {
    Q_DECLARE_TR_FUNCTIONS(kambara::ui::TargetLine)

  public:
    static QString sentence(const TrackEstimate& estimate) {
        if (estimate.state == TrackState::idle) {
            return tr(
                "No target is tracked: drag a rectangle over it in the main window's left "
                "picture.");
        }
        if (estimate.state == TrackState::template_set) {
            return tr(
                "The target is chosen but not followed: start tracking (F5) in the main "
                "window.");
        }
        QString text = name_of(estimate.state);
        if (estimate.position) {
            text += QStringLiteral(", ") +
                    tr("%1 away").arg(millimetres(estimate.position->point_in_left_mm.norm(), 0));
        }
        if (!estimate.reason.empty()) {
            text += QStringLiteral(": ") + translated(estimate.reason);
        }
        return text;
    }
};

}  // namespace

bool show_target(QLabel& label, const Snapshot& snapshot) {
    const TrackEstimate estimate = steered_estimate(snapshot);
    const QString text = TargetLine::sentence(estimate);
    if (label.text() != text) {
        label.setText(text);
        label.setStyleSheet(QStringLiteral("color: %1").arg(colour_of(estimate.state).name()));
    }
    return estimate.state == TrackState::tracking && estimate.position.has_value();
}

}  // namespace kambara::ui
