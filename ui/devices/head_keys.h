// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSet>
#include <functional>

class QKeyEvent;
class QWidget;

namespace kambara::ui {

class HandDrive;

/// The arrow keys as a stick: pressed they turn the head, let go they halt it. They count in one
/// window alone, while it has the keyboard, and not where something in it has a use of its own for
/// them (a slider, a list, a text, a rectangle being placed). Whatever takes the keyboard away lets
/// them go.
class HeadKeys : public QObject {
    Q_OBJECT
  public:
    /// `in_use`: whether the part that has the keyboard wants the arrows now.
    HeadKeys(HandDrive* drive, QWidget* window, std::function<bool(QWidget*)> in_use);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    bool takes(QWidget* part) const;
    bool press(const QKeyEvent& event, QObject* watched);
    bool release(const QKeyEvent& event);
    void let_go();
    void apply();

    HandDrive* drive_;
    QWidget* window_;
    std::function<bool(QWidget*)> in_use_;
    QSet<int> pressed_;
};

}  // namespace kambara::ui
