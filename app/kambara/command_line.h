// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QStringList>

#include "ui/shell/main_window.h"

namespace kambara {

/// What the window is started with.
class CommandLine {
    Q_DECLARE_TR_FUNCTIONS(kambara::CommandLine)

  public:
    /// Reads `arguments`, the program's name first; for --help, --version and what can't be
    /// understood it prints and ends the program (exit code 0, or 2 for wrong usage).
    static ui::WindowOptions read(const QStringList& arguments);
    /// The language asked for, found before everything else so that even --help is in it.
    static QString language(const QStringList& arguments);
    /// The real head asked for; empty where none is.
    static QString pan_tilt(const QStringList& arguments);
};

}  // namespace kambara
