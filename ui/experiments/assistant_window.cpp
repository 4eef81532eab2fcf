// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/assistant_window.h"

#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>

#include "ui/base/core_text.h"
#include "ui/base/theme.h"

namespace kambara::ui {

QLabel* sentence_label(const QString& object_name, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(object_name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QLabel* empty_label(const QString& object_name, QWidget* parent) {
    QLabel* label = sentence_label(object_name, parent);
    label->setAlignment(Qt::AlignCenter);
    label->setMargin(30);
    label->setStyleSheet(
        QStringLiteral("background: %1; color: %2").arg(theme::panel.name(), theme::faint.name()));
    return label;
}

AssistantWindow::AssistantWindow(const QString& object_name, const QString& title, QWidget* parent)
    : QWidget(parent, Qt::Window),
      foot_(new QWidget(this)),
      said_(sentence_label(QStringLiteral("said"), foot_)) {
    setObjectName(object_name);
    setWindowTitle(title);
    // Kept free, so that nothing jumps when a sentence comes or goes.
    said_->setMinimumHeight(2 * said_->fontMetrics().lineSpacing());
    said_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    auto* close_button = new QPushButton(tr("Close"), foot_);
    close_button->setObjectName(QStringLiteral("closeForm"));
    close_button->setToolTip(tr("Closes this form; the target is followed on.  [Ctrl+W]"));
    connect(close_button, &QPushButton::clicked, this, &QWidget::close);
    auto* row = new QHBoxLayout(foot_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(said_, 1);
    row->addWidget(close_button, 0, Qt::AlignBottom);
}

void AssistantWindow::say(const QString& text, const QColor& colour) {
    said_->setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
    said_->setText(text);
}

void AssistantWindow::say(const QString& text) {
    say(text, theme::text);
}

void AssistantWindow::say_done(const QString& text) {
    say(text, theme::good);
}

void AssistantWindow::say_failure(const QString& text) {
    say(text, theme::bad);
}

void AssistantWindow::say_failure(const Error& error) {
    say_failure(translated(error));
}

bool AssistantWindow::may_close() {
    return may_drop(tr("Close without saving"));
}

bool AssistantWindow::may_drop(const QString& button) {
    // What is still being typed counts: a field that loses the keyboard takes it over.
    if (QWidget* typed = focusWidget()) {
        typed->clearFocus();
    }
    const QString lost = unsaved();
    if (lost.isEmpty()) {
        return true;
    }
    return ask("unsavedQuestion", lost, button);
}

bool AssistantWindow::may_replace_source() {
    return ask("replaceQuestion",
               tr("The simulated rig is opened anew for this. What runs now ends, and its targets "
                  "are forgotten."),
               tr("Open the simulated rig"));
}

bool AssistantWindow::ask(const char* object_name, const QString& text, const QString& button) {
    QMessageBox box(QMessageBox::Warning, windowTitle(), text, QMessageBox::NoButton, this);
    box.setObjectName(QLatin1String(object_name));
    QPushButton* stay = box.addButton(tr("Keep it"), QMessageBox::RejectRole);
    QPushButton* go_on = box.addButton(button, QMessageBox::DestructiveRole);
    box.setDefaultButton(stay);
    box.setEscapeButton(stay);
    box.exec();
    return box.clickedButton() == go_on;
}

void AssistantWindow::close_unasked() {
    asked_ = true;
    close();
    asked_ = false;
}

void AssistantWindow::closeEvent(QCloseEvent* event) {
    if (!asked_ && !may_close()) {
        event->ignore();
        return;
    }
    leave();
    QWidget::closeEvent(event);
}

}  // namespace kambara::ui
