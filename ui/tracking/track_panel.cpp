// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tracking/track_panel.h"

#include <QFormLayout>
#include <QLabel>
#include <cmath>

#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

const QString none = QStringLiteral("\u2013");

QString with_sigma(double value_mm, double variance_mm2) {
    return QStringLiteral("%1  \u00B1 %2")
        .arg(millimetres(value_mm), millimetres(std::sqrt(variance_mm2)));
}

}  // namespace

TrackPanel::TrackPanel(QWidget* parent) : QWidget(parent) {
    auto* form = new QFormLayout(this);
    form->setVerticalSpacing(4);
    form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    state_ = new QLabel(this);
    state_->setObjectName(QStringLiteral("trackState"));
    QFont large = state_->font();
    large.setPointSizeF(1.4 * large.pointSizeF());
    large.setBold(true);
    state_->setFont(large);
    form->addRow(state_);
    reason_ = new QLabel(this);
    reason_->setObjectName(QStringLiteral("trackReason"));
    reason_->setWordWrap(true);
    // Two lines are always kept free, so that nothing jumps when a reason comes or goes.
    reason_->setMinimumHeight(2 * reason_->fontMetrics().lineSpacing());
    reason_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    form->addRow(reason_);
    number_ = add_row(tr("Steered target"), QStringLiteral("steeredTarget"),
                      tr("Ctrl + drag in the left picture chooses one more target; Ctrl + click on "
                         "one steers to it."));
    x_ = add_row(tr("x (right)"), QStringLiteral("positionX"),
                 tr("In the left camera's frame; \u00B1 one standard deviation from image noise."));
    y_ = add_row(tr("y (down)"), QStringLiteral("positionY"), x_->toolTip());
    z_ = add_row(tr("z (ahead)"), QStringLiteral("positionZ"), x_->toolTip());
    calibration_ =
        add_row(tr("By calibration"), QStringLiteral("calibrationSigma"),
                tr("One standard deviation of x, y, z that the calibration leaves: it does not "
                   "average out. Known where the rig file tells its covariance."));
    range_ = add_row(tr("Range"), QStringLiteral("range"), tr("Distance from the left camera."));
    quality_ = add_row(tr("Quality"), QStringLiteral("quality"),
                       tr("How like the template the target is, in the worse of both pictures."));
    residual_ = add_row(tr("Residual"), QStringLiteral("residual"),
                        tr("How far the two matches are from a common point."));
    updates_ = add_row(tr("Template updates"), QStringLiteral("templateUpdates"),
                       tr("How often a fresh template was cut since the target was chosen."));
    clear();
}

QLabel* TrackPanel::add_row(const QString& name, const QString& object_name, const QString& help) {
    auto* value = new QLabel(this);
    value->setObjectName(object_name);
    value->setToolTip(help);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setMinimumWidth(
        value->fontMetrics().horizontalAdvance(QStringLiteral("-10,000.0 mm  \u00B1 1,000.0 mm")));
    auto* form = static_cast<QFormLayout*>(layout());
    form->addRow(name, value);
    return value;
}

void TrackPanel::clear() {
    state_->setText(name_of(TrackState::idle));
    state_->setStyleSheet(QStringLiteral("color: %1").arg(theme::faint.name()));
    reason_->setText(tr("Drag a rectangle over the target in the left picture."));
    for (QLabel* label :
         {number_, x_, y_, z_, calibration_, range_, quality_, residual_, updates_}) {
        label->setText(none);
    }
}

void TrackPanel::show_snapshot(const SnapshotPtr& snapshot) {
    const TrackSnapshot* track = steered_track(*snapshot);
    if (track == nullptr) {
        clear();
        return;
    }
    const TrackEstimate& estimate = track->estimate;
    const auto count = snapshot->tracks.size();
    number_->setText(count > 1 ? tr("number %1, one of %2").arg(track->id).arg(count)
                               : tr("number %1").arg(track->id));
    state_->setText(name_of(estimate.state));
    state_->setStyleSheet(QStringLiteral("color: %1").arg(colour_of(estimate.state).name()));
    reason_->setText(estimate.state == TrackState::template_set
                         ? tr("Start tracking (F5) follows it; a new rectangle replaces it.")
                         : translated(estimate.reason));
    quality_->setText(percent(estimate.quality));
    updates_->setText(QString::number(estimate.template_updates));
    if (!estimate.position) {
        for (QLabel* label : {x_, y_, z_, calibration_, range_, residual_}) {
            label->setText(none);
        }
        return;
    }
    const Eigen::Vector3d& p = estimate.position->point_in_left_mm;
    const Eigen::Matrix3d& c = estimate.position->covariance_mm2;
    x_->setText(with_sigma(p.x(), c(0, 0)));
    y_->setText(with_sigma(p.y(), c(1, 1)));
    z_->setText(with_sigma(p.z(), c(2, 2)));
    const auto& by_calibration = estimate.position->calibration_covariance_mm2;
    calibration_->setText(by_calibration ? QStringLiteral("\u00B1 %1 / %2 / %3")
                                               .arg(std::sqrt((*by_calibration)(0, 0)), 0, 'f', 1)
                                               .arg(std::sqrt((*by_calibration)(1, 1)), 0, 'f', 1)
                                               .arg(millimetres(std::sqrt((*by_calibration)(2, 2))))
                                         : tr("not known"));
    const Eigen::Vector3d along = p.normalized();
    range_->setText(with_sigma(p.norm(), along.dot(c * along)));
    residual_->setText(pixels(estimate.position->residual_px));
}

}  // namespace kambara::ui
