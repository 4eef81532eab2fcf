// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

class QWidget;

namespace kambara::ui {

/// Manners of sliders and number fields beside live pictures. The wheel is theirs only while they
/// have the keyboard: else it scrolls what they lie in and changes nothing. Letters, which no
/// number field can use, stay the window's keys.
class FieldManners : public QObject {
  public:
    /// Of every slider, number field and choice in `part`, now.
    static void teach(QWidget* part);

    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    using QObject::QObject;
};

}  // namespace kambara::ui
