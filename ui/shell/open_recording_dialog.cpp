// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/open_recording_dialog.h"

#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>
#include <algorithm>

#include "ui/base/theme.h"

namespace kambara::ui {

OpenRecordingDialog::OpenRecordingDialog(QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Open recording"));
    setObjectName(QStringLiteral("openRecordingDialog"));
    auto* form = new QFormLayout(this);
    auto* intro = new QLabel(
        tr("A video file, or pictures by a pattern such as left/*.png or left_%06d.png."), this);
    intro->setWordWrap(true);
    form->addRow(intro);
    const QString media =
        tr("Videos and pictures (*.mkv *.mp4 *.avi *.mov *.png *.jpg *.jpeg *.tif "
           "*.tiff *.bmp *.pgm *.ppm);;All files (*)");
    left_ = add_row(tr("&Left"), QStringLiteral("leftSource"), tr("left camera's pictures"), media);
    right_ = add_row(tr("&Right"), QStringLiteral("rightSource"),
                     tr("right camera's; empty: one camera, directions only"), media);
    rig_ = add_row(tr("Ri&g file"), QStringLiteral("rigFile"), tr("the calibration of both"),
                   tr("Rig files (*.yaml *.yml);;All files (*)"));
    rate_ = new QDoubleSpinBox(this);
    rate_->setObjectName(QStringLiteral("picturesRate"));
    rate_->setRange(0.1, 1000.0);
    rate_->setValue(10.0);
    rate_->setSuffix(QStringLiteral(" Hz"));
    rate_->setToolTip(tr("How fast single pictures follow each other; videos know it themselves."));
    form->addRow(tr("&Single pictures at"), rate_);
    failure_ = new QLabel(this);
    failure_->setObjectName(QStringLiteral("openFailure"));
    failure_->setWordWrap(true);
    failure_->setStyleSheet(QStringLiteral("color: %1").arg(theme::bad.name()));
    failure_->hide();
    form->addRow(failure_);
    buttons_ = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
    buttons_->button(QDialogButtonBox::Open)->setText(tr("Open"));
    buttons_->button(QDialogButtonBox::Cancel)->setText(tr("Cancel"));
    form->addRow(buttons_);
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(620);
    check();
}

QLineEdit* OpenRecordingDialog::add_row(const QString& label, const QString& object_name,
                                        const QString& hint, const QString& filter) {
    auto* edit = new QLineEdit(this);
    edit->setObjectName(object_name);
    edit->setPlaceholderText(hint);
    auto* browse = new QToolButton(this);
    browse->setText(tr("Choose\u2026"));
    auto* row = new QHBoxLayout;
    row->addWidget(edit, 1);
    row->addWidget(browse);
    auto* form = static_cast<QFormLayout*>(layout());
    form->addRow(label, row);
    static_cast<QLabel*>(form->labelForField(row))->setBuddy(edit);
    connect(edit, &QLineEdit::textChanged, this, &OpenRecordingDialog::check);
    connect(browse, &QToolButton::clicked, this, [this, edit, filter] {
        const QString folder = QFileInfo(left_->text()).absolutePath();
        const QString file =
            QFileDialog::getOpenFileName(this, tr("Choose a file"), folder, filter);
        if (!file.isEmpty()) {
            edit->setText(file);
        }
    });
    return edit;
}

void OpenRecordingDialog::check() {
    QString missing;
    if (left_->text().trimmed().isEmpty()) {
        missing = tr("Name the left camera's pictures.");
    } else if (rig_->text().trimmed().isEmpty()) {
        missing = tr("Name the rig file that belongs to the pictures.");
    }
    auto* open = buttons_->button(QDialogButtonBox::Open);
    open->setEnabled(missing.isEmpty());
    open->setToolTip(missing);
}

SourceRequest OpenRecordingDialog::request() const {
    const auto text = [](const QLineEdit* edit) { return edit->text().trimmed().toStdString(); };
    return {text(left_), text(right_), text(rig_), rate_->value()};
}

void OpenRecordingDialog::set_request(const SourceRequest& request) {
    left_->setText(QString::fromStdString(request.left));
    right_->setText(QString::fromStdString(request.right));
    rig_->setText(QString::fromStdString(request.rig));
    rate_->setValue(request.pictures_rate_hz);
}

void OpenRecordingDialog::show_failure(const QString& text) {
    failure_->setText(text);
    failure_->setVisible(!text.isEmpty());
}

SourceRequest request_of_files(const QStringList& files) {
    SourceRequest request;
    QStringList sources;
    for (const QString& file : files) {
        if (file.endsWith(QLatin1String(".yaml"), Qt::CaseInsensitive) ||
            file.endsWith(QLatin1String(".yml"), Qt::CaseInsensitive)) {
            request.rig = file.toStdString();
        } else {
            sources << file;
        }
    }
    std::sort(sources.begin(), sources.end());
    const auto speaks_of_right = [](const QString& file) {
        return QFileInfo(file).fileName().contains(QLatin1String("right"), Qt::CaseInsensitive);
    };
    std::stable_partition(sources.begin(), sources.end(),
                          [&](const QString& file) { return !speaks_of_right(file); });
    if (!sources.isEmpty()) {
        request.left = sources.front().toStdString();
    }
    if (sources.size() > 1) {
        request.right = sources.at(1).toStdString();
    }
    return request;
}

}  // namespace kambara::ui
