// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/field_manners.h"

#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QKeyEvent>
#include <QScrollBar>

namespace kambara::ui {

void FieldManners::teach(QWidget* part) {
    auto* manners = new FieldManners(part);
    for (QWidget* field : part->findChildren<QWidget*>()) {
        const bool slider = qobject_cast<QAbstractSlider*>(field) != nullptr &&
                            qobject_cast<QScrollBar*>(field) == nullptr;
        if (slider || qobject_cast<QAbstractSpinBox*>(field) != nullptr ||
            qobject_cast<QComboBox*>(field) != nullptr) {
            // Not by the wheel, as number fields would have it.
            field->setFocusPolicy(Qt::StrongFocus);
            field->installEventFilter(manners);
        }
    }
}

bool FieldManners::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Wheel && !static_cast<QWidget*>(watched)->hasFocus()) {
        event->ignore();  // goes to what the field lies in
        return true;
    }
    if (event->type() == QEvent::ShortcutOverride) {
        const QString text = static_cast<QKeyEvent*>(event)->text();
        if (!text.isEmpty() && text.front().isLetter()) {
            event->ignore();
            return true;
        }
    }
    return false;
}

}  // namespace kambara::ui
