// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/base/theme.h"

#include <QApplication>
#include <QPalette>
#include <QStyleFactory>

namespace kambara::ui {

QColor colour_of(TrackState state) {
    switch (state) {
        case TrackState::tracking:
            return theme::good;
        case TrackState::doubtful:
            return theme::caution;
        case TrackState::lost:
            return theme::bad;
        case TrackState::template_set:
            return theme::accent;
        case TrackState::idle:
            break;
    }
    return theme::faint;
}

void apply_theme(QApplication& application) {
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QPalette palette;
    palette.setColor(QPalette::Window, theme::ground);
    palette.setColor(QPalette::Base, theme::panel);
    palette.setColor(QPalette::AlternateBase, theme::ground);
    palette.setColor(QPalette::Button, theme::panel);
    palette.setColor(QPalette::ToolTipBase, theme::panel);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                            QPalette::ToolTipText, QPalette::BrightText}) {
        palette.setColor(role, theme::text);
        palette.setColor(QPalette::Disabled, role, QColor(0x7d, 0x85, 0x90));
    }
    palette.setColor(QPalette::PlaceholderText, theme::faint);
    palette.setColor(QPalette::Highlight, theme::accent);
    palette.setColor(QPalette::HighlightedText, Qt::black);
    palette.setColor(QPalette::Link, theme::accent);
    palette.setColor(QPalette::Light, theme::line);
    palette.setColor(QPalette::Mid, theme::line);
    palette.setColor(QPalette::Dark, QColor(0x12, 0x14, 0x18));
    palette.setColor(QPalette::Shadow, Qt::black);
    QApplication::setPalette(palette);
    // What is switched on must be seen to be on.
    application.setStyleSheet(
        QStringLiteral("QToolButton { padding: 3px 8px; border: 1px solid %1; border-radius: 3px;"
                       " background: %2; color: %3 }"
                       "QToolButton:hover { border-color: %4 }"
                       "QToolButton:pressed { background: %1 }"
                       "QToolButton:checked { background: %4; color: black }"
                       "QToolBar { spacing: 3px; padding: 2px 4px; border: none }"
                       // Fusion's arrow is dark on dark.
                       "QToolButton#qt_toolbar_ext_button { padding: 3px 1px; min-width: 14px;"
                       " background: %3 }"
                       "QToolButton:disabled { color: #7d8590 }"
                       "QToolTip { background: %2; color: %3; border: 1px solid %1 }")
            .arg(theme::line.name(), theme::panel.name(), theme::text.name(),
                 theme::accent.name()));
}

}  // namespace kambara::ui
