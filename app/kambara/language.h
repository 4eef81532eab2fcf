// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

namespace kambara {

/// The window's language: its texts, Qt's own, and how numbers are written. Holds the translators;
/// lives as long as the application. English, where there is no translation.
class Language {
  public:
    /// `code` such as de or en_GB; empty: the system's.
    explicit Language(const QString& code);

  private:
    QTranslator own_;
    QTranslator qt_;
};

}  // namespace kambara
