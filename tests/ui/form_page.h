// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QLabel>

#include "tests/ui/window_page.h"
#include "ui/experiments/assistant_window.h"

namespace kambara::testing_support {

/// One of the Tools menu's forms, as its operator has it before them.
class FormPage {
  public:
    /// Opens it by its key in the main window.
    FormPage(WindowPage& page, const char* action, const char* window_name);

    /// With the mouse.
    void press(const char* button);
    /// By keyboard: the field is given the focus and what it holds is replaced.
    void type(const char* field, const QString& text);
    void choose(const char* combo, int index);
    bool can_press(const char* button) { return part<QAbstractButton>(button).isEnabled(); }
    bool shows(const char* part_name) { return part<QWidget>(part_name).isVisible(); }
    QString text(const char* label) { return part<QLabel>(label).text(); }
    QString said() { return text("said"); }
    /// The first number in a label, as it stands there.
    double number(const char* label);
    /// Presses a button of the question that is about to appear, once it does.
    static void answer(const char* question, const QString& button);
    /// A picture of the window, where KAMBARA_SCREENSHOTS names a folder.
    void take(const char* name);

    ui::AssistantWindow& window() { return *window_; }
    template <class Part>
    Part& part(const char* object_name) {
        auto* found = window_->findChild<Part*>(QLatin1String(object_name));
        if (found == nullptr) {
            throw std::logic_error(std::string("the form has no ") + object_name);
        }
        return *found;
    }

  private:
    ui::AssistantWindow* window_;
};

}  // namespace kambara::testing_support
