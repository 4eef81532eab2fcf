// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "ui/shell/system_link.h"

class QDialogButtonBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;

namespace kambara::ui {

/// Asks for a recording: left and right pictures, the rig file.
class OpenRecordingDialog : public QDialog {
    Q_OBJECT
  public:
    explicit OpenRecordingDialog(QWidget* parent = nullptr);

    SourceRequest request() const;
    void set_request(const SourceRequest& request);
    /// Says why the last try failed.
    void show_failure(const QString& text);

  private:
    QLineEdit* add_row(const QString& label, const QString& object_name, const QString& hint,
                       const QString& filter);
    void check();

    QLineEdit* left_;
    QLineEdit* right_;
    QLineEdit* rig_;
    QDoubleSpinBox* rate_;
    QLabel* failure_;
    QDialogButtonBox* buttons_;
};

/// Files dropped on the window as a recording: one that ends in .yaml or .yml is the rig file, the
/// others are the sources, those whose names speak of the right camera on the right, else in
/// alphabetical order.
SourceRequest request_of_files(const QStringList& files);

}  // namespace kambara::ui
