// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/levelling_window.h"

#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "core/base/angles.h"
#include "core/camera/rig_file.h"
#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/experiments/background.h"
#include "ui/experiments/movement_view.h"
#include "ui/experiments/save_row.h"
#include "ui/experiments/target_line.h"

namespace kambara::ui {
namespace {

constexpr int form_width = 380;
constexpr std::size_t most_points = 20000;  // eleven minutes at 30 pairs a second
constexpr double much_turn_rad = rad_from_deg(1.0);
constexpr double much_sigma_rad = rad_from_deg(0.3);
const QString none = QStringLiteral("\u2013");

QString with_sigma(double rad, const std::optional<double>& sigma_rad) {
    return sigma_rad ? QStringLiteral("%1  \u00B1 %2").arg(degrees(rad, 3), degrees(*sigma_rad, 3))
                     : degrees(rad, 3);
}

}  // namespace

LevellingWindow::LevellingWindow(QWidget* parent)
    : AssistantWindow(QStringLiteral("levellingWindow"), tr("Levelling"), parent),
      background_(new Background(this)) {
    resize(1080, 640);
    build();
    changed();
    clear();
}

LevellingWindow::~LevellingWindow() = default;

void LevellingWindow::build() {
    auto* all = new QVBoxLayout(this);
    auto* beside = new QHBoxLayout;
    auto* left = new QWidget(this);
    left->setFixedWidth(form_width);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    way_ = new QComboBox(this);
    way_->setObjectName(QStringLiteral("levelBy"));
    way_->addItems({tr("A vertical movement"), tr("An upright wall")});
    auto* way_label = new QLabel(tr("&Level by"), this);
    way_label->setBuddy(way_);
    form->addRow(way_label, way_);
    roll_deg_ = new QDoubleSpinBox(this);
    roll_deg_->setObjectName(QStringLiteral("wallRoll"));
    roll_deg_->setRange(-60.0, 60.0);
    roll_deg_->setDecimals(2);
    roll_deg_->setSuffix(QStringLiteral("\u202F\u00B0"));
    roll_deg_->setToolTip(
        tr("A wall says nothing of roll. 0 where the rig hangs level from side "
           "to side."));
    roll_label_ = new QLabel(tr("Roll, &known"), this);
    roll_label_->setBuddy(roll_deg_);
    form->addRow(roll_label_, roll_deg_);
    column->addLayout(form);
    how_ = sentence_label(QStringLiteral("levelHow"), this);
    column->addWidget(how_);
    target_ = sentence_label(QStringLiteral("levelTarget"), this);
    target_->setMinimumHeight(2 * target_->fontMetrics().lineSpacing());
    column->addWidget(target_);
    auto* buttons = new QHBoxLayout;
    record_ = new QPushButton(tr("&Record"), this);
    record_->setObjectName(QStringLiteral("levelRecord"));
    record_->setCheckable(true);
    clear_ = new QPushButton(tr("&Clear"), this);
    clear_->setObjectName(QStringLiteral("levelClear"));
    buttons->addWidget(record_, 1);
    buttons->addWidget(clear_, 1);
    column->addLayout(buttons);
    auto* numbers = new QFormLayout;
    const auto row = [&](const QString& name, const char* object_name, const QString& help) {
        auto* value = new QLabel(this);
        value->setObjectName(QLatin1String(object_name));
        value->setToolTip(help);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        numbers->addRow(name, value);
        return value;
    };
    count_ = row(tr("Positions"), "levelCount", tr("Recorded while the target was tracked."));
    extent_ = row(tr("Extent"), "levelExtent",
                  tr("The movement's length, or the wall's height as far as measured."));
    straightness_ = row(tr("Straightness"), "levelStraightness",
                        tr("RMS of the positions' distances from the line or the plane."));
    left_out_ = row(tr("Left out"), "levelLeftOut", tr("Positions that lie far off the others."));
    pitch_ = row(tr("Pitch"), "levelPitch",
                 tr("By how much the rig looks down; \u00B1 one standard deviation."));
    roll_ = row(tr("Roll"), "levelRoll",
                tr("By how much the rig's right side hangs down; \u00B1 one standard deviation."));
    QFont large = font();
    large.setPointSizeF(1.3 * large.pointSizeF());
    for (QLabel* label : {pitch_, roll_}) {
        label->setFont(large);
    }
    column->addLayout(numbers);
    warning_ = sentence_label(QStringLiteral("levelWarning"), this);
    warning_->setStyleSheet(QStringLiteral("color: %1").arg(theme::caution.name()));
    column->addWidget(warning_);
    column->addStretch(1);
    view_ = new MovementView(this);
    view_->setObjectName(QStringLiteral("movementView"));
    beside->addWidget(left);
    beside->addWidget(view_, 1);
    all->addLayout(beside, 1);
    save_ = new SaveRow(tr("Rig &file"), tr("&Use this"), QStringLiteral("levelSave"),
                        tr("Rig files (*.yaml)"), this);
    save_->set_file(QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
                        .filePath(QStringLiteral("rig_levelled.yaml")));
    all->addWidget(save_);
    all->addWidget(foot());
    connect(way_, qOverload<int>(&QComboBox::currentIndexChanged), this, &LevellingWindow::changed);
    connect(roll_deg_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &LevellingWindow::changed);
    connect(record_, &QPushButton::toggled, this, &LevellingWindow::record);
    connect(clear_, &QPushButton::clicked, this, &LevellingWindow::clear);
    connect(save_, &SaveRow::save_asked, this, &LevellingWindow::save);
    connect(save_, &SaveRow::failed, this, [this](const QString& text) { say_failure(text); });
}

bool LevellingWindow::by_wall() const {
    return way_->currentIndex() == 1;
}

void LevellingWindow::set_source(const Rig& rig) {
    if (recording_) {
        record_->setChecked(false);
        say(tr("Another source was opened: the recording ended."));
    }
    rig_ = rig;
    last_frame_ = -1;
    roll_deg_->setValue(deg_from_rad(rig.mount.value_or(Mount{}).roll_rad));
    target_->clear();
}

void LevellingWindow::changed() {
    roll_deg_->setVisible(by_wall());
    roll_label_->setVisible(by_wall());
    how_->setText(
        by_wall() ? tr("Stand the rig before a flat, upright wall. Choose a target on it and "
                       "record; then move the vehicle or the target so that it goes all over the "
                       "wall, up and down as well as to the sides.")
                  : tr("Track a target, record, then move it or the vehicle straight up and down, "
                       "as on a plumb line, half a metre or more, and nothing else."));
    view_->set_hint(
        tr("The recorded positions appear here, seen from the front and from the "
           "side."));
    saved_ = false;
    solve();
}

void LevellingWindow::record(bool on) {
    if (on && points_in_left_mm_.empty()) {
        measured_by_ = rig_;
    } else if (on && rig_to_text(measured_by_) != rig_to_text(rig_)) {
        record_->setChecked(false);
        say_failure(tr("The recorded positions come from another rig. Clear them first."));
        return;
    }
    recording_ = on;
    record_->setText(on ? tr("&Stop") : tr("&Record"));
    if (!on) {
        solve();
    } else {
        saved_ = false;
        say({});
    }
}

void LevellingWindow::clear() {
    points_in_left_mm_.clear();
    measured_by_ = rig_;
    levelling_.reset();
    saved_ = false;
    solve();
}

void LevellingWindow::show_snapshot(const SnapshotPtr& snapshot) {
    show_target(*target_, *snapshot);
    const TrackEstimate estimate = steered_estimate(*snapshot);
    if (!recording_ || snapshot->frame == last_frame_ || !estimate.position ||
        estimate.state != TrackState::tracking) {
        return;
    }
    last_frame_ = snapshot->frame;
    points_in_left_mm_.push_back(estimate.position->point_in_left_mm);
    if (points_in_left_mm_.size() >= most_points) {
        record_->setChecked(false);
        say(tr("The recording is full and has ended. Clear it to record anew."));
        return;
    }
    solve();
}

// A fit that is under way is followed by another one when more has come meanwhile.
void LevellingWindow::solve() {
    stale_ = background_->busy();
    if (stale_) {
        return;
    }
    const RigidTransform T_rig_from_left = measured_by_.left.T_camera_from_rig.inverse();
    background_->run(
        [points = points_in_left_mm_, T_rig_from_left, wall = by_wall(),
         roll_rad = rad_from_deg(roll_deg_->value())] {
            std::vector<Eigen::Vector3d> in_rig;
            in_rig.reserve(points.size());
            for (const Eigen::Vector3d& point : points) {
                in_rig.push_back(T_rig_from_left * point);
            }
            auto levelling = wall ? level_from_wall(in_rig, roll_rad) : level_from_vertical(in_rig);
            const Movement movement = movement_of(in_rig);
            return Found{std::move(in_rig), wall, movement, std::move(levelling)};
        },
        [this](const Found& found) {
            show_found(found);
            if (std::exchange(stale_, false)) {
                solve();
            }
        });
}

QString LevellingWindow::warnings(const Found& found) const {
    QStringList sentences;
    if (found.points_in_rig_mm.empty()) {
        return {};
    }
    if (!found.levelling) {
        return translated(found.levelling.error());
    }
    const Levelling& levelling = *found.levelling;
    if (levelling.extent_mm < short_movement_mm) {
        sentences << tr("The movement is short: %1. Go on to %2 or more, since errors that hang "
                        "together turn a short line by much.")
                         .arg(millimetres(levelling.extent_mm, 0),
                              millimetres(short_movement_mm, 0));
    }
    const double turn_rad = largest_turn_by_bending_rad(levelling.rms_mm, levelling.extent_mm);
    if (turn_rad > much_turn_rad) {
        sentences << (found.wall ? tr("The positions are far from a plane: if that is a bend, it "
                                      "may have turned it by up to %1.")
                                       .arg(degrees(turn_rad))
                                 : tr("The movement is crooked: a bend of that size may have "
                                      "turned it by up to %1. Move straight up and down.")
                                       .arg(degrees(turn_rad)));
    }
    const Mount& mount = levelling.mount;
    if (std::max(mount.pitch_sigma_rad.value_or(0.0), mount.roll_sigma_rad.value_or(0.0)) >
        much_sigma_rad) {
        sentences << tr("The angle is not known well yet: record more positions over more height.");
    }
    return sentences.join(QStringLiteral("\n"));
}

void LevellingWindow::show_found(const Found& found) {
    levelling_ = found.levelling ? std::optional(*found.levelling) : std::nullopt;
    found_by_wall_ = found.wall;
    count_->setText(QLocale().toString(static_cast<qulonglong>(found.points_in_rig_mm.size())));
    const bool any = found.points_in_rig_mm.size() > 1;
    extent_->setText(
        any ? millimetres(levelling_ ? levelling_->extent_mm : found.movement.extent_mm, 0) : none);
    const double rms_mm = levelling_   ? levelling_->rms_mm
                          : found.wall ? found.movement.off_plane_rms_mm
                                       : found.movement.off_line_rms_mm;
    straightness_->setText(any ? tr("%1 RMS").arg(millimetres(rms_mm, 2)) : none);
    left_out_->setText(levelling_ ? QString::number(levelling_->points_left_out) : none);
    const Mount mount = levelling_ ? levelling_->mount : Mount{};
    pitch_->setText(levelling_ ? with_sigma(mount.pitch_rad, mount.pitch_sigma_rad) : none);
    roll_->setText(!levelling_  ? none
                   : found.wall ? tr("%1, as given").arg(degrees(mount.roll_rad, 3))
                                : with_sigma(mount.roll_rad, mount.roll_sigma_rad));
    warning_->setText(warnings(found));
    std::optional<Eigen::Vector3d> direction;
    if (levelling_) {
        direction = R_level_from_rig(levelling_->mount).row(1).transpose();
    }
    view_->show_points(found.points_in_rig_mm, direction);
    clear_->setEnabled(any && !recording_);
    save_->allow(levelling_ && !recording_, recording_ ? tr("Stop the recording first.")
                                                       : tr("There is no angle to save yet."));
}

QString LevellingWindow::unsaved() const {
    if (recording_) {
        return tr("The recording that is under way would be lost.");
    }
    // A movement without an angle can't be saved: there is nothing to lose but a try.
    return levelling_ && !saved_ ? tr("The angle that was found has not been saved.") : QString();
}

void LevellingWindow::save(const QString& file) {
    if (!levelling_) {
        return;
    }
    const Rig rig = with_mount(measured_by_, *levelling_, found_by_wall_);
    background_->run([rig, path = file.toStdString()] { return write_rig_file(path, rig); },
                     [this, rig, file](const Result<Done>& written) {
                         if (!written) {
                             say_failure(written.error());
                             return;
                         }
                         saved_ = true;
                         const bool in_use = rig_to_text(measured_by_) == rig_to_text(rig_);
                         measured_by_ = rig;
                         if (in_use) {
                             rig_ = rig;
                             emit mount_found(rig);
                         }
                         say_done(in_use ? tr("Saved: %1. The Target panel can tell positions in "
                                              "the levelled rig's and the vehicle's frame now.")
                                               .arg(file)
                                         : tr("Saved: %1").arg(file));
                     });
}

void LevellingWindow::leave() {
    record_->setChecked(false);
    clear();
    say({});
}

}  // namespace kambara::ui
