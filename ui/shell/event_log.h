// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/base/error.h"
#include "core/vsystem/snapshot.h"

class QTableWidget;

namespace kambara::ui {

/// What happened, newest last: time of day, kind, text. The oldest go when there are too many.
class EventLog : public QWidget {
    Q_OBJECT
  public:
    explicit EventLog(QWidget* parent = nullptr);

    void add(const Event& event);
    void add_note(const QString& text);
    void add_fault(const QString& text);
    int rows() const;
    /// Whether an event's text holds this.
    bool tells(const QString& part) const;

  private:
    void add_row(Event::Kind kind, const QString& text);
    QTableWidget* table_;
};

}  // namespace kambara::ui
