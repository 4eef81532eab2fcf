// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QMenuBar;
class QWidget;

namespace kambara::ui {

/// Every key of the menus' actions with what it does, menu by menu, as rich text.
QString keys_text(const QMenuBar& menus);
/// Shows it beside the window, which goes on taking keys.
void show_keys(const QMenuBar& menus, QWidget* parent);

}  // namespace kambara::ui
