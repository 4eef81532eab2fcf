// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRect>
#include <QVector>

class QMainWindow;

namespace kambara::ui {

/// Keeps a window's place, size and docks in the settings.
void save_layout(const QMainWindow& window);
/// A size that suits the screen, in its middle.
void give_default_size(QMainWindow& window);
/// Puts what was kept back, moved onto a screen that is there.
void load_layout(QMainWindow& window);

/// The window's frame moved and shrunk so that it lies wholly on the screen it overlaps most (the
/// first if none).
QRect onto_screens(const QRect& window, const QVector<QRect>& screens);

}  // namespace kambara::ui
