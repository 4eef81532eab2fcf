// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QWidget;

namespace kambara::ui {

/// Shows the program's version and licence, and those of the libraries it runs on.
void show_about(QWidget* parent);
QString about_text();

}  // namespace kambara::ui
