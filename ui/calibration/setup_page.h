// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <array>
#include <filesystem>
#include <optional>

#include "core/calibration/session/session_setup.h"
#include "core/vsystem/snapshot.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace kambara::ui {

/// What to calibrate with: target, cameras, lens, medium, a baseline by tape, the session's folder.
class SetupPage : public QWidget {
    Q_OBJECT
  public:
    explicit SetupPage(QWidget* parent = nullptr);

    void set_rig(const Rig& rig, const QString& simulated_target);
    void show_snapshot(const Snapshot& snapshot);
    void show_failure(const QString& text);
    /// Another folder than any session's so far, which is offered.
    void offer_new_folder();
    /// The chosen target as a document to print; says what became of it on the page.
    void save_pdf(const QString& file);

  signals:
    void begin_asked(const kambara::SessionSetup& setup, const QString& folder);
    void resume_asked(const QString& folder);

  private:
    void check();
    std::optional<SessionSetup> setup() const;
    void choose_folder();
    void choose_pdf();
    void choose_to_resume();

    std::array<std::optional<PictureSize>, most_cameras> sizes_;
    std::optional<Sensor> sensor_;
    QComboBox* target_;
    QPushButton* print_;
    QLabel* target_note_;
    std::array<QCheckBox*, most_cameras> cameras_{};
    QComboBox* model_;
    QComboBox* medium_;
    QCheckBox* by_tape_;
    QDoubleSpinBox* baseline_mm_;
    QDoubleSpinBox* sigma_mm_;
    QLineEdit* folder_;
    QLabel* failure_;
    QLabel* why_not_;
    QPushButton* begin_;
};

}  // namespace kambara::ui
