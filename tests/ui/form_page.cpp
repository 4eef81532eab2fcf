// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/form_page.h"

#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QMessageBox>
#include <QRegularExpression>
#include <QTimer>
#include <QtTest>

namespace kambara::testing_support {

FormPage::FormPage(WindowPage& page, const char* action, const char* window_name) {
    WindowPage::until([&] { return page.action(action).isEnabled(); });
    const QKeySequence keys = page.action(action).shortcut();
    const int code = keys[0];
    page.key(static_cast<Qt::Key>(code & ~static_cast<int>(Qt::KeyboardModifierMask)),
             Qt::KeyboardModifiers(code & static_cast<int>(Qt::KeyboardModifierMask)));
    window_ = page.window().findChild<ui::AssistantWindow*>(QLatin1String(window_name));
    if (window_ == nullptr || !QTest::qWaitForWindowExposed(window_)) {
        throw std::runtime_error(std::string("the form does not appear: ") + window_name);
    }
}

void FormPage::press(const char* button) {
    // Near its left end: a box to tick takes no clicks beyond its text.
    auto& pressed = part<QAbstractButton>(button);
    QTest::mouseClick(&pressed, Qt::LeftButton, Qt::NoModifier, {8, pressed.height() / 2});
}

void FormPage::type(const char* field, const QString& text) {
    auto& edit = part<QWidget>(field);
    edit.setFocus();
    QTest::keyClick(&edit, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&edit, text);
}

void FormPage::choose(const char* combo, int index) {
    auto& box = part<QComboBox>(combo);
    box.setFocus();
    QTest::keyClick(&box, Qt::Key_Home);
    for (int i = 0; i < index; ++i) {
        QTest::keyClick(&box, Qt::Key_Down);
    }
}

double FormPage::number(const char* label) {
    static const QRegularExpression pattern(QStringLiteral("-?[0-9]+(\\.[0-9]+)?"));
    return pattern.match(text(label)).captured().toDouble();
}

void FormPage::answer(const char* question, const QString& button) {
    auto* timer = new QTimer(qApp);
    QObject::connect(timer, &QTimer::timeout, qApp, [timer, question, button] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (box == nullptr || box->objectName() != QLatin1String(question)) {
            return;
        }
        for (QAbstractButton* one : box->buttons()) {
            if (one->text().remove(QLatin1Char('&')) == button) {
                timer->deleteLater();
                QTest::mouseClick(one, Qt::LeftButton);
                return;
            }
        }
    });
    timer->start(50);
}

void FormPage::take(const char* name) {
    const QString folder = qEnvironmentVariable("KAMBARA_SCREENSHOTS");
    if (!folder.isEmpty()) {
        QCoreApplication::processEvents();  // what has just changed is laid out anew
        window_->grab().save(QDir(folder).filePath(QLatin1String(name) + QStringLiteral(".png")));
    }
}

}  // namespace kambara::testing_support
