// SPDX-License-Identifier: GPL-3.0-or-later
// What the head calibration's window is made of, and what can be done in it when.
#include <QComboBox>
#include <QDir>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/experiments/head_window.h"
#include "ui/experiments/save_row.h"

namespace kambara::ui {
namespace {

constexpr int result_width = 380;
constexpr int least_views = HeadCalibrationOptions{}.least_views;

}  // namespace

void HeadWindow::build() {
    auto* all = new QVBoxLayout(this);
    auto* beside = new QHBoxLayout;
    beside->addWidget(views_part(), 1);
    beside->addWidget(result_part());
    all->addLayout(beside, 1);
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    save_record_ = new SaveRow(tr("Record of the &views"), tr("Save r&ecord"),
                               QStringLiteral("saveHeadRecord"), tr("Tables (*.csv)"), this);
    save_record_->set_file(folder.filePath(QStringLiteral("head_views/views.csv")));
    save_rig_ = new SaveRow(tr("Rig &file"), tr("&Save rig"), QStringLiteral("saveHeadRig"),
                            tr("Rig files (*.yaml)"), this);
    save_rig_->set_file(folder.filePath(QStringLiteral("rig_with_head.yaml")));
    all->addWidget(save_record_);
    all->addWidget(save_rig_);
    all->addWidget(foot());
    show_result();
}

QWidget* HeadWindow::views_part() {
    auto* part = new QWidget(this);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    target_ = new QComboBox(part);
    target_->setObjectName(QStringLiteral("headTarget"));
    target_->setEditable(true);
    target_->addItems({QStringLiteral("chessboard:9x6:30"), QStringLiteral("two-plane-24"),
                       QStringLiteral("charuco:5x7:40:20:DICT_6X6_250")});
    target_->setToolTip(tr("A target's short form, or its file (.yaml)"));
    auto* label = new QLabel(tr("&Target"), part);
    label->setBuddy(target_);
    row->addWidget(label);
    row->addWidget(target_, 1);
    column->addLayout(row);
    state_ = sentence_label(QStringLiteral("headState"), part);
    state_->setMinimumHeight(2 * state_->fontMetrics().lineSpacing());
    column->addWidget(state_);
    table_ = new QTableWidget(0, 6, part);
    table_->setObjectName(QStringLiteral("headViews"));
    table_->setHorizontalHeaderLabels({tr("pan"), tr("tilt"), tr("came from, pan / tilt"),
                                       tr("corners"), tr("residual"), tr("why it is of no use")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->setTabKeyNavigation(false);
    table_->setAccessibleName(tr("Recorded views"));
    empty_ = empty_label(QStringLiteral("headEmpty"), part);
    empty_->setText(
        tr("There are no views yet.\n\nStand the target about a metre before the rig, "
           "where all three cameras see it, and go through the positions: the head "
           "turns about it by itself, and each one is come to from below and from "
           "above, which tells the backlash.\n\nFor still better lever arms, move the "
           "target and go through them again. Or load a record of the command line's "
           "calibrate-head."));
    column->addWidget(table_, 1);
    column->addWidget(empty_, 1);
    auto* buttons = new QHBoxLayout;
    const auto button = [&](const QString& text, const char* name) {
        auto* made = new QPushButton(text, part);
        made->setObjectName(QLatin1String(name));
        buttons->addWidget(made);
        return made;
    };
    go_ = button(tr("&Go through the positions"), "headGo");
    go_->setCheckable(true);
    one_ = button(tr("&Record this view"), "headOne");
    load_ = button(tr("&Load a record\u2026"), "headLoad");
    clear_ = button(tr("&Clear"), "headClear");
    buttons->addStretch(1);
    solve_ = button(tr("S&olve"), "headSolve");
    column->addLayout(buttons);
    return part;
}

QWidget* HeadWindow::result_part() {
    auto* part = new QWidget(this);
    part->setFixedWidth(result_width);
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(8, 0, 0, 0);
    verdict_ = sentence_label(QStringLiteral("headVerdict"), part);
    QFont large = font();
    large.setPointSizeF(1.2 * large.pointSizeF());
    verdict_->setFont(large);
    column->addWidget(verdict_);
    auto* form = new QFormLayout;
    form->setVerticalSpacing(8);
    const auto row = [&](const QString& name, const char* object_name, const QString& help) {
        auto* value = sentence_label(QLatin1String(object_name), part);
        value->setToolTip(help);
        form->addRow(name, value);
        return value;
    };
    rms_ = row(tr("Residual"), "headRms", tr("RMS over all points, in the head's picture."));
    rms_deg_ = row(tr("as an angle"), "headRmsDeg", tr("The same, at the head's camera."));
    without_ = row(tr("without a model"), "headWithout",
                   tr("If the camera turned about its own centre: what the model is worth."));
    ahead_ = row(tr("Tilt axis ahead"), "headAhead",
                 tr("Of the pan axis; \u00B1 one standard deviation."));
    arm_ = row(tr("Camera off tilt axis"), "headArm",
               tr("The tilt axis's place in the camera's frame; \u00B1 one standard deviation."));
    skew_ = row(tr("Tilt axis skew"), "headSkew", tr("From square to the pan axis."));
    pan_backlash_ = row(tr("Backlash of pan"), "headPanBacklash",
                        tr("By how much farther the encoder goes than the axis; \u00B1 one "
                           "standard deviation."));
    tilt_backlash_ = row(tr("Backlash of tilt"), "headTiltBacklash", pan_backlash_->toolTip());
    by_rig_ = row(tr("The rig"), "headRig",
                  tr("Where its calibration took part, the deviations contain the rig's own error. "
                     "It is saved as it is, with the head's numbers that steer best beside it; "
                     "calibrate-head --refine-rig writes both as the views correct them."));
    column->addLayout(form);
    column->addStretch(1);
    return part;
}

void HeadWindow::changed() {
    const bool idle = doing_ == Doing::nothing;
    const QString why_not = hindrance();
    table_->setVisible(table_->rowCount() > 0);
    empty_->setVisible(table_->rowCount() == 0);
    target_->setEnabled(idle && recorded_.empty());
    target_->setToolTip(recorded_.empty() ? tr("A target's short form, or its file (.yaml)")
                                          : tr("Clear the views to take another target."));
    go_->setChecked(!idle);
    go_->setText(idle ? tr("&Go through the positions") : tr("&Stop"));
    go_->setEnabled(!idle || why_not.isEmpty());
    go_->setToolTip(why_not);
    one_->setEnabled(idle && why_not.isEmpty());
    one_->setToolTip(why_not.isEmpty()
                         ? tr("Where the head stands now; from which side it came is not known.")
                         : why_not);
    load_->setEnabled(idle);
    clear_->setEnabled(idle && !recorded_.empty());
    solve_->setEnabled(idle && views() >= least_views);
    solve_->setToolTip(views() >= least_views ? QString()
                                              : tr("It takes %1 views.").arg(least_views));
    const bool any_pictures =
        std::any_of(recorded_.begin(), recorded_.end(),
                    [](const HeadRecorded& one) { return one.pictures.left != nullptr; });
    save_record_->allow(idle && any_pictures, tr("There are no recorded pictures."));
}

}  // namespace kambara::ui
