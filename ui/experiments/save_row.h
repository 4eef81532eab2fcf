// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLineEdit;
class QPushButton;

namespace kambara::ui {

/// A file's name, a button that looks for a place, and one that saves. A file that is there already
/// is written over only after a question.
class SaveRow : public QWidget {
    Q_OBJECT
  public:
    /// `name`: of the button, and with File behind it of the name's field. `filter` as QFileDialog
    /// takes it.
    SaveRow(const QString& label, const QString& action, const QString& name, const QString& filter,
            QWidget* parent = nullptr);

    void set_file(const QString& file);
    QString file() const;
    void allow(bool on, const QString& reason_not = {});

  signals:
    /// The name has no blanks about it, is not empty, and its folder is there.
    void save_asked(const QString& file);
    void failed(const QString& sentence);

  private:
    void save();

    QLineEdit* file_;
    QPushButton* save_;
    QString confirmed_;  // by the dialog that looked for a place
};

}  // namespace kambara::ui
