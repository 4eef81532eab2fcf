// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QLabel>

#include "tests/ui/window_page.h"
#include "ui/calibration/calibration_window.h"

namespace kambara::testing_support {

/// The calibration window as somebody has it before him who follows the screen.
class CalibrationPage {
  public:
    /// Opens it by the main window's key.
    explicit CalibrationPage(WindowPage& page);

    void choose_target(const QString& target);
    void choose_folder(const QString& folder);
    void press(const char* button);
    bool can_press(const char* button) { return part<QAbstractButton>(button).isEnabled(); }
    bool shows(const char* part_name) { return part<QWidget>(part_name).isVisible(); }
    QString text(const char* label) { return part<QLabel>(label).text(); }
    int shots();
    int shots_kept();
    void tick_shot(int row, bool on);
    void hold_key(Qt::Key key, Qt::KeyboardModifiers modifiers);
    bool until(const std::function<bool()>& is_so, int seconds) {
        return WindowPage::until(is_so, seconds);
    }
    /// A picture of the window, where KAMBARA_SCREENSHOTS names a folder.
    void take(const char* name);

    ui::CalibrationWindow& window() { return *window_; }
    template <class Part>
    Part& part(const char* object_name) {
        auto* found = window_->findChild<Part*>(QLatin1String(object_name));
        if (found == nullptr) {
            throw std::logic_error(std::string("the calibration window has no ") + object_name);
        }
        return *found;
    }

  private:
    ui::CalibrationWindow* window_;
};

}  // namespace kambara::testing_support
