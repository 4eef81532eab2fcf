// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/keys_dialog.h"

#include <QAction>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace kambara::ui {
namespace {

QString plain(QString text) {
    return text.remove(QLatin1Char('&')).remove(QChar(0x2026)).toHtmlEscaped();
}

// An action that can't be done now has its key all the same: its own help, not why not.
QString row(const QAction& action) {
    return QStringLiteral("<tr><td><b>%1</b></td><td>%2</td><td>%3</td></tr>")
        .arg(action.shortcut().toString(QKeySequence::NativeText).toHtmlEscaped(),
             plain(action.text()), action.property("help").toString().toHtmlEscaped());
}

}  // namespace

QString keys_text(const QMenuBar& menus) {
    QString text;
    for (const QAction* title : menus.actions()) {
        QString rows;
        for (const QAction* action : title->menu()->actions()) {
            if (!action->shortcut().isEmpty()) {
                rows += row(*action);
            }
        }
        if (!rows.isEmpty()) {
            text += QStringLiteral("<h4>%1</h4><table cellpadding='3'>%2</table>")
                        .arg(plain(title->text()), rows);
        }
    }
    return text;
}

void show_keys(const QMenuBar& menus, QWidget* parent) {
    if (auto* shown = parent->findChild<QDialog*>(QStringLiteral("keysDialog"))) {
        shown->raise();
        shown->activateWindow();
        return;
    }
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(QStringLiteral("keysDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(QCoreApplication::translate("kambara::ui::Keys", "Keys"));
    dialog->resize(760, 720);
    auto* column = new QVBoxLayout(dialog);
    auto* text = new QTextBrowser(dialog);
    text->setHtml(keys_text(menus));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
    QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    column->addWidget(text);
    column->addWidget(buttons);
    dialog->show();
}

}  // namespace kambara::ui
