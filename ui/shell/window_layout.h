// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QVector>

class QMainWindow;

namespace kambara::ui {

/// Keeps a window's place, size and docks in the settings.
void save_layout(const QMainWindow& window);
/// Puts them back, moved onto a screen that is there. Without settings the window gets a size that
/// suits its screen.
void load_layout(QMainWindow& window);

/// The window's frame moved and shrunk so that it lies wholly on the screen it overlaps most (the
/// first if none).
QRect onto_screens(const QRect& window, const QVector<QRect>& screens);

}  // namespace kambara::ui
