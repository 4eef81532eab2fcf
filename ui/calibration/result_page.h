// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "ui/calibration/session_worker.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QTabWidget;

namespace kambara::ui {

/// What the calibration came to: the verdict and why, numbers, residuals, range errors; and where
/// to save it.
class ResultPage : public QWidget {
    Q_OBJECT
  public:
    explicit ResultPage(QWidget* parent = nullptr);

    void show_outcome(const SessionOutcomePtr& outcome, const QString& folder);
    void show_saved(const QString& file);
    void show_failure(const QString& text);

  signals:
    void save_rig_asked(const QString& file);
    void save_report_asked(const QString& file);
    void back_asked();

  private:
    void fill_numbers(const SessionOutcome& outcome);
    void say(const QString& text, const QColor& colour);

    QLabel* verdict_;
    QLabel* reasons_;
    QTabWidget* tabs_;
    QTableWidget* numbers_;
    QLineEdit* rig_file_;
    QLineEdit* report_file_;
    QPushButton* save_rig_;
    QPushButton* save_report_;
    QLabel* said_;
};

}  // namespace kambara::ui
