// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/calibration_page.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QLineEdit>
#include <QListWidget>
#include <QtTest>

namespace kambara::testing_support {

CalibrationPage::CalibrationPage(WindowPage& page) {
    WindowPage::until([&] { return page.action("calibrate").isEnabled(); });
    page.key(Qt::Key_K, Qt::ControlModifier);
    window_ = page.window().findChild<ui::CalibrationWindow*>();
    if (window_ == nullptr || !QTest::qWaitForWindowExposed(window_)) {
        throw std::runtime_error("the calibration window does not appear");
    }
}

void CalibrationPage::choose_target(const QString& target) {
    part<QComboBox>("calibrationTarget").setCurrentText(target);
}

void CalibrationPage::choose_folder(const QString& folder) {
    part<QLineEdit>("sessionFolder").setText(folder);
}

void CalibrationPage::press(const char* button) {
    // Near its left end: a box to tick takes no clicks beyond its text.
    auto& pressed = part<QAbstractButton>(button);
    QTest::mouseClick(&pressed, Qt::LeftButton, Qt::NoModifier, {8, pressed.height() / 2});
}

int CalibrationPage::shots() {
    return part<QListWidget>("shotList").count();
}

int CalibrationPage::shots_kept() {
    const auto& list = part<QListWidget>("shotList");
    int kept = 0;
    for (int i = 0; i < list.count(); ++i) {
        kept += list.item(i)->checkState() == Qt::Checked ? 1 : 0;
    }
    return kept;
}

void CalibrationPage::tick_shot(int row, bool on) {
    part<QListWidget>("shotList").item(row)->setCheckState(on ? Qt::Checked : Qt::Unchecked);
}

void CalibrationPage::hold_key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(&part<QWidget>("holdPad"), key, modifiers);
}

void CalibrationPage::take(const char* name) {
    const QString folder = qEnvironmentVariable("KAMBARA_SCREENSHOTS");
    if (!folder.isEmpty()) {
        QCoreApplication::processEvents();  // what has just changed is laid out anew
        window_->grab().save(QDir(folder).filePath(QLatin1String(name) + QStringLiteral(".png")));
    }
}

}  // namespace kambara::testing_support
