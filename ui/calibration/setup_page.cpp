// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/setup_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStandardPaths>
#include <QVBoxLayout>

#include "core/base/text_file.h"
#include "core/calibration/target_pdf.h"
#include "ui/base/core_text.h"
#include "ui/base/theme.h"
#include "ui/calibration/guide_view.h"

namespace kambara::ui {
namespace {

constexpr int form_width = 760;

QLabel* explained(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setWordWrap(true);
    return label;
}

QDoubleSpinBox* length_box(double value_mm, double lowest, double highest, QWidget* parent) {
    auto* box = new QDoubleSpinBox(parent);
    box->setRange(lowest, highest);
    box->setDecimals(2);
    box->setSuffix(QStringLiteral("\u202Fmm"));
    box->setValue(value_mm);
    return box;
}

}  // namespace

SetupPage::SetupPage(QWidget* parent) : QWidget(parent) {
    auto* page = new QVBoxLayout(this);
    page->addWidget(explained(
        tr("<h2>Calibrate the cameras</h2>You show the target to all cameras, about twelve times. "
           "The next page draws in blue where to hold it; the pictures are taken by themselves "
           "while it is held still."),
        this));
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    target_ = new QComboBox(this);
    target_->setObjectName(QStringLiteral("calibrationTarget"));
    target_->setEditable(true);
    target_->addItems({QStringLiteral("two-plane-24"), QStringLiteral("chessboard:9x6:30"),
                       QStringLiteral("charuco:5x7:40:20:DICT_6X6_250")});
    target_->setToolTip(tr("A target's short form, or its file (.yaml)"));
    target_note_ = explained({}, this);
    target_note_->setObjectName(QStringLiteral("targetNote"));
    print_ = new QPushButton(tr("&Print\u2026"), this);
    print_->setObjectName(QStringLiteral("printTarget"));
    auto* target_row = new QHBoxLayout;
    target_row->addWidget(target_, 1);
    target_row->addWidget(print_);
    auto* target_label = new QLabel(tr("&Target"), this);
    target_label->setBuddy(target_);
    form->addRow(target_label, target_row);
    form->addRow(QString(), target_note_);
    auto* cameras = new QHBoxLayout;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        cameras_[c] = new QCheckBox(camera_title(c), this);
        cameras_[c]->setObjectName(QStringLiteral("camera%1").arg(c));
        cameras_[c]->setEnabled(false);
        cameras->addWidget(cameras_[c]);
        connect(cameras_[c], &QCheckBox::toggled, this, &SetupPage::check);
    }
    cameras->addStretch(1);
    form->addRow(tr("Cameras"), cameras);
    model_ = new QComboBox(this);
    model_->addItems({tr("Brown (most lenses)"), tr("Tsai (as in 1999)")});
    form->addRow(tr("&Lens model"), model_);
    medium_ = new QComboBox(this);
    medium_->addItems({tr("Air"), tr("Water")});
    medium_->setToolTip(tr("What the cameras look through while they are calibrated"));
    form->addRow(tr("&Medium"), medium_);
    auto* tape = new QHBoxLayout;
    by_tape_ = new QCheckBox(tr("Measured by tape:"), this);
    baseline_mm_ = length_box(450.0, 1.0, 1e5, this);
    sigma_mm_ = length_box(0.5, 0.01, 100.0, this);
    tape->addWidget(by_tape_);
    tape->addWidget(baseline_mm_);
    tape->addWidget(new QLabel(QStringLiteral("\u00B1"), this));
    tape->addWidget(sigma_mm_);
    tape->addStretch(1);
    form->addRow(tr("Baseline"), tape);
    auto* place = new QHBoxLayout;
    folder_ = new QLineEdit(this);
    folder_->setObjectName(QStringLiteral("sessionFolder"));
    auto* browse = new QPushButton(tr("Choose\u2026"), this);
    place->addWidget(folder_, 1);
    place->addWidget(browse);
    auto* place_label = new QLabel(tr("&Folder"), this);
    place_label->setBuddy(folder_);
    form->addRow(place_label, place);
    page->addLayout(form);
    failure_ = explained({}, this);
    failure_->setObjectName(QStringLiteral("setupFailure"));
    failure_->setMargin(6);
    failure_->setStyleSheet(
        QStringLiteral("background: %1; color: black").arg(theme::caution.name()));
    failure_->hide();
    page->addWidget(failure_);
    page->addStretch(1);
    auto* buttons = new QHBoxLayout;
    auto* resume = new QPushButton(tr("&Resume a session\u2026"), this);
    resume->setObjectName(QStringLiteral("resumeSession"));
    begin_ = new QPushButton(tr("&Begin"), this);
    begin_->setObjectName(QStringLiteral("beginSession"));
    begin_->setDefault(true);
    buttons->addWidget(resume);
    why_not_ = new QLabel(this);
    why_not_->setObjectName(QStringLiteral("whyNotBegin"));
    buttons->addStretch(1);
    buttons->addWidget(why_not_);
    buttons->addWidget(begin_);
    page->addLayout(buttons);
    setMaximumWidth(form_width);

    connect(target_, &QComboBox::currentTextChanged, this, &SetupPage::check);
    connect(folder_, &QLineEdit::textChanged, this, &SetupPage::check);
    connect(by_tape_, &QCheckBox::toggled, this, &SetupPage::check);
    connect(print_, &QPushButton::clicked, this, &SetupPage::choose_pdf);
    connect(browse, &QPushButton::clicked, this, &SetupPage::choose_folder);
    connect(resume, &QPushButton::clicked, this, &SetupPage::choose_to_resume);
    connect(begin_, &QPushButton::clicked, this, [this] {
        failure_->hide();
        if (const auto chosen = setup()) {
            emit begin_asked(*chosen, folder_->text());
        }
    });
    offer_new_folder();
    check();
}

void SetupPage::offer_new_folder() {
    const QDir program(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation));
    folder_->setText(program.filePath(
        QStringLiteral("calibrations/%1")
            .arg(QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH.mm.ss")))));
}

void SetupPage::set_rig(const Rig& rig, const QString& simulated_target) {
    sensor_.reset();
    if (const auto* tsai = std::get_if<TsaiLens>(&rig.left.lens)) {
        sensor_ = tsai->sensor;
    }
    model_->setEnabled(sensor_.has_value());
    model_->setCurrentIndex(sensor_ ? 1 : 0);
    model_->setToolTip(sensor_ ? tr("Tsai's model takes the sensor of the rig in use")
                               : tr("Tsai's model needs the sensor's numbers, which the rig in use "
                                    "does not have."));
    medium_->setCurrentIndex(rig.medium == Medium::air ? 0 : 1);
    if (!simulated_target.isEmpty()) {
        target_->setCurrentText(simulated_target);
    }
    sizes_ = {};
    check();
}

void SetupPage::show_snapshot(const Snapshot& snapshot) {
    const std::array<ImagePtr, most_cameras> pictures{snapshot.pictures.stereo.left.picture,
                                                      snapshot.pictures.stereo.right.picture,
                                                      snapshot.pictures.pan_tilt.picture};
    bool news = false;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (pictures[c] == nullptr) {
            continue;
        }
        const PictureSize size{pictures[c]->width(), pictures[c]->height()};
        if (sizes_[c] != size) {
            if (!sizes_[c]) {
                cameras_[c]->setChecked(c < 2);
            }
            sizes_[c] = size;
            news = true;
        }
    }
    if (news) {
        check();
    }
}

std::optional<SessionSetup> SetupPage::setup() const {
    const auto target = parse_target(target_->currentText().trimmed().toStdString());
    if (!target || !sizes_[0]) {
        return std::nullopt;
    }
    SessionSetup chosen;
    chosen.target = *target;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (sizes_[c] && (c == 0 || cameras_[c]->isChecked())) {
            chosen.cameras[c] = sizes_[c];
        }
    }
    if (model_->currentIndex() == 1 && sensor_) {
        chosen.model = LensModel::tsai;
        chosen.sensor = *sensor_;
    }
    chosen.medium = medium_->currentIndex() == 0 ? Medium::air : Medium::water;
    if (by_tape_->isChecked() && chosen.cameras[1]) {
        chosen.baseline = KnownBaseline{baseline_mm_->value(), sigma_mm_->value()};
    }
    return chosen;
}

void SetupPage::check() {
    for (std::size_t c = 0; c < most_cameras; ++c) {
        cameras_[c]->setText(sizes_[c] ? tr("%1 (%2 \u00D7 %3 px)")
                                             .arg(camera_title(c))
                                             .arg(sizes_[c]->width_px)
                                             .arg(sizes_[c]->height_px)
                                       : camera_title(c));
        cameras_[c]->setEnabled(sizes_[c].has_value() && c > 0);
        cameras_[c]->setToolTip(!sizes_[c] ? tr("It gives no pictures.")
                                : c == 0   ? tr("The left camera always takes part.")
                                : c == 2   ? tr("With its head at home")
                                           : QString());
    }
    baseline_mm_->setEnabled(by_tape_->isChecked());
    sigma_mm_->setEnabled(by_tape_->isChecked());
    const auto target = parse_target(target_->currentText().trimmed().toStdString());
    QString reason;
    if (!target) {
        reason = translated(target.error());
        target_note_->setText(reason);
    } else if (std::holds_alternative<PointTarget>(*target)) {
        reason = tr("A list of points can't be found in pictures: choose another target.");
        target_note_->setText(reason);
    } else {
        target_note_->setText(tr("%1 corners").arg(corners_in_target_mm(*target).size()));
        if (!sizes_[0]) {
            reason = tr("No picture has come yet: open a source, or play the recording.");
        } else if (folder_->text().trimmed().isEmpty()) {
            reason = tr("Name a folder for the session.");
        }
    }
    print_->setEnabled(static_cast<bool>(target));
    print_->setToolTip(target
                           ? tr("Saves the target as a PDF file at its true size, a page a plane")
                           : translated(target.error()));
    begin_->setEnabled(reason.isEmpty());
    why_not_->setText(target ? reason : QString());  // what is wrong with a target stands beside it
    begin_->setToolTip(reason.isEmpty() ? tr("Begins a session in a new folder") : reason);
}

void SetupPage::show_failure(const QString& text) {
    failure_->setText(text);
    failure_->setVisible(!text.isEmpty());
}

void SetupPage::save_pdf(const QString& file) {
    failure_->hide();
    const auto target = parse_target(target_->currentText().trimmed().toStdString());
    const auto pdf = target ? target_pdf(*target) : Result<TargetPdf>(target.error());
    if (!pdf) {
        show_failure(translated(pdf.error()));
        return;
    }
    const auto written = write_text_file_atomically(file.toStdString(), pdf->bytes);
    if (!written) {
        show_failure(translated(written.error()));
        return;
    }
    target_note_->setText(
        tr("Saved as %1: paper %2, pages: %3. Print it at 100\u202F% and measure the "
           "ruler on it.")
            .arg(file, QString::fromStdString(pdf->paper.name))
            .arg(pdf->places.size()));
}

void SetupPage::choose_pdf() {
    const QDir documents(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString chosen = QFileDialog::getSaveFileName(
        this, tr("Save the target to print"), documents.filePath(QStringLiteral("target.pdf")),
        tr("PDF files (*.pdf)"));
    if (!chosen.isEmpty()) {
        save_pdf(chosen);
    }
}

void SetupPage::choose_folder() {
    const QString chosen =
        QFileDialog::getExistingDirectory(this, tr("A folder for the session"), folder_->text());
    if (!chosen.isEmpty()) {
        folder_->setText(chosen);
    }
}

void SetupPage::choose_to_resume() {
    const QString chosen = QFileDialog::getExistingDirectory(
        this, tr("The session to resume"), QDir(folder_->text()).filePath(QStringLiteral("..")));
    if (!chosen.isEmpty()) {
        failure_->hide();
        emit resume_asked(chosen);
    }
}

}  // namespace kambara::ui
