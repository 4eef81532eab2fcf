// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/save_row.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>

namespace kambara::ui {

SaveRow::SaveRow(const QString& label, const QString& action, const QString& name,
                 const QString& filter, QWidget* parent)
    : QWidget(parent), file_(new QLineEdit(this)), save_(new QPushButton(action, this)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    auto* title = new QLabel(label, this);
    title->setBuddy(file_);
    auto* choose = new QPushButton(tr("Choose\u2026"), this);
    file_->setObjectName(name + QStringLiteral("File"));
    save_->setObjectName(name);
    row->addWidget(title);
    row->addWidget(file_, 1);
    row->addWidget(choose);
    row->addWidget(save_);
    connect(choose, &QPushButton::clicked, this, [this, label, filter] {
        const QString chosen = QFileDialog::getSaveFileName(this, label, file_->text(), filter);
        if (!chosen.isEmpty()) {
            file_->setText(chosen);
            confirmed_ = chosen;
        }
    });
    connect(save_, &QPushButton::clicked, this, &SaveRow::save);
}

void SaveRow::set_file(const QString& file) {
    file_->setText(file);
}

QString SaveRow::file() const {
    return file_->text().trimmed();
}

void SaveRow::allow(bool on, const QString& reason_not) {
    save_->setEnabled(on);
    save_->setToolTip(on ? QString() : reason_not);
}

void SaveRow::save() {
    const QString name = file();
    if (name.isEmpty()) {
        emit failed(tr("The file has no name. Write one, or choose a place."));
        return;
    }
    const QFileInfo info(name);
    if (info.isDir()) {
        emit failed(tr("%1 is a folder. Write a file's name behind it.").arg(name));
        return;
    }
    if (!QDir().mkpath(info.absolutePath())) {
        emit failed(tr("The folder %1 can't be made. Choose a place that can be written to.")
                        .arg(info.absolutePath()));
        return;
    }
    if (info.exists() && confirmed_ != name) {
        QMessageBox box(QMessageBox::Question, window()->windowTitle(),
                        tr("%1 is there already. Write over it?").arg(name), QMessageBox::NoButton,
                        this);
        box.setObjectName(QStringLiteral("overwriteQuestion"));
        QPushButton* keep = box.addButton(tr("Keep it"), QMessageBox::RejectRole);
        QPushButton* over = box.addButton(tr("Write over it"), QMessageBox::AcceptRole);
        box.setDefaultButton(keep);
        box.setEscapeButton(keep);
        box.exec();
        if (box.clickedButton() != over) {
            return;
        }
    }
    confirmed_.clear();
    emit save_asked(name);
}

}  // namespace kambara::ui
