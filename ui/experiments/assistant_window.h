// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/base/error.h"
#include "core/camera/rig.h"
#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

class QLabel;

namespace kambara::ui {

/// A form beside the main window that works on what the vision system tells of the tracked target.
/// It needs nothing but snapshots; whoever opens it hands them and the rig in use over. Nothing
/// unsaved is lost by closing without a question.
class AssistantWindow : public QWidget {
    Q_OBJECT
  public:
    AssistantWindow(const QString& object_name, const QString& title, QWidget* parent);

    /// The source that is open now, and the rig that measures in it.
    virtual void set_source(const Rig& rig) = 0;
    virtual void show_snapshot(const SnapshotPtr& snapshot) = 0;

    /// What would be lost by closing, as a sentence; empty where nothing would.
    virtual QString unsaved() const = 0;
    /// Asks where something would be lost; true where the window may go.
    bool may_close();
    /// Closes without asking: that has been done.
    void close_unasked();

  signals:
    void command_asked(const kambara::Command& command);

  protected:
    /// Likewise, for another way of losing it, which the button names.
    bool may_drop(const QString& button);
    /// Asks before another source takes the running one's place; true where it may.
    bool may_replace_source();
    /// Where the form says what happened, and its Close button: every form ends with it.
    QWidget* foot() { return foot_; }
    void say(const QString& text);
    void say_done(const QString& text);
    void say_failure(const QString& text);
    void say_failure(const Error& error);
    void closeEvent(QCloseEvent* event) override;
    /// The window has been closed: what it had begun stops.
    virtual void leave() {}

  private:
    bool ask(const char* object_name, const QString& text, const QString& button);
    void say(const QString& text, const QColor& colour);

    QWidget* foot_;
    QLabel* said_;
    bool asked_ = false;
};

/// A label that may be as long as its text: in several lines, selectable.
QLabel* sentence_label(const QString& object_name, QWidget* parent);
/// One that stands where a table will be, and says what fills it.
QLabel* empty_label(const QString& object_name, QWidget* parent);

}  // namespace kambara::ui
