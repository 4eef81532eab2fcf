// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tracking/track_panel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QStandardItemModel>
#include <cmath>

#include "core/camera/position_frame.h"
#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

const QString none = QStringLiteral("\u2013");

constexpr int sigma_decimals = 2;  // near by, a tenth of a millimetre would read as none

QString with_sigma(double value_mm, double variance_mm2) {
    return QStringLiteral("%1  \u00B1 %2")
        .arg(millimetres(value_mm), millimetres(std::sqrt(variance_mm2), sigma_decimals));
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
    add_frames();
    x_ = add_row(tr("x (right)"), QStringLiteral("positionX"),
                 tr("In the frame chosen above; \u00B1 one standard deviation from image noise."));
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

void TrackPanel::add_frames() {
    frame_ = new QComboBox(this);
    frame_->setObjectName(QStringLiteral("positionFrame"));
    frame_->addItem(tr("left camera"), QStringLiteral("left"));
    frame_->addItem(tr("rig"), QStringLiteral("rig"));
    frame_->addItem(tr("rig, levelled"), QStringLiteral("level"));
    frame_->addItem(tr("vehicle"), QStringLiteral("vehicle"));
    frame_->setToolTip(
        tr("The frame in which the position is told. The last two need a rig whose "
           "mount is known: Tools > Levelling finds it."));
    auto* label = new QLabel(tr("Fra&me"), this);
    label->setBuddy(frame_);
    static_cast<QFormLayout*>(layout())->addRow(label, frame_);
    connect(frame_, qOverload<int>(&QComboBox::currentIndexChanged), this,
            &TrackPanel::choose_frame);
}

void TrackPanel::set_rig(const Rig& rig) {
    rig_ = rig;
    auto* items = static_cast<QStandardItemModel*>(frame_->model());
    for (int i = 0; i < frame_->count(); ++i) {
        const auto known = T_frame_from_left(rig, frame_->itemData(i).toString().toStdString());
        items->item(i)->setEnabled(known.ok());
        if (!known && frame_->currentIndex() == i) {
            frame_->setCurrentIndex(0);
        }
    }
    choose_frame();
}

void TrackPanel::choose_frame() {
    const QString name = frame_->currentData().toString();
    const auto T_frame = T_frame_from_left(rig_, name.toStdString());
    T_frame_from_left_ = T_frame ? *T_frame : RigidTransform{};
    const bool vehicle = name == QLatin1String("vehicle");
    auto* form = static_cast<QFormLayout*>(layout());
    const auto name_row = [form](QLabel* value, const QString& text) {
        static_cast<QLabel*>(form->labelForField(value))->setText(text);
    };
    name_row(x_, vehicle ? tr("x (forward)") : tr("x (right)"));
    name_row(y_, vehicle ? tr("y (right)") : tr("y (down)"));
    name_row(z_, vehicle ? tr("z (down)") : tr("z (ahead)"));
    if (shown_) {
        show_snapshot(shown_);
    }
}

QLabel* TrackPanel::add_row(const QString& name, const QString& object_name, const QString& help) {
    auto* value = new QLabel(this);
    value->setObjectName(object_name);
    value->setToolTip(help);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setMinimumWidth(
        value->fontMetrics().horizontalAdvance(QStringLiteral("-10,000.0 mm  \u00B1 1,000.00 mm")));
    auto* form = static_cast<QFormLayout*>(layout());
    form->addRow(name, value);
    return value;
}

void TrackPanel::clear() {
    shown_.reset();
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
    shown_ = snapshot;
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
    const Eigen::Vector3d told = T_frame_from_left_ * p;
    const Eigen::Matrix3d& R = T_frame_from_left_.R;
    const Eigen::Matrix3d told_c = R * c * R.transpose();
    x_->setText(with_sigma(told.x(), told_c(0, 0)));
    y_->setText(with_sigma(told.y(), told_c(1, 1)));
    z_->setText(with_sigma(told.z(), told_c(2, 2)));
    if (const auto& by_calibration = estimate.position->calibration_covariance_mm2) {
        const Eigen::Vector3d sigma =
            (R * *by_calibration * R.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
        calibration_->setText(QStringLiteral("\u00B1 %1 / %2 / %3")
                                  .arg(sigma.x(), 0, 'f', sigma_decimals)
                                  .arg(sigma.y(), 0, 'f', sigma_decimals)
                                  .arg(millimetres(sigma.z(), sigma_decimals)));
    } else {
        calibration_->setText(tr("not known"));
    }
    const Eigen::Vector3d along = p.normalized();
    range_->setText(with_sigma(p.norm(), along.dot(c * along)));
    residual_->setText(pixels(estimate.position->residual_px));
}

}  // namespace kambara::ui
