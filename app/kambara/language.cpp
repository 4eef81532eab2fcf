// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/kambara/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

namespace kambara {

Language::Language(const QString& code) {
    if (!code.isEmpty()) {
        QLocale::setDefault(QLocale(code));
    }
    if (own_.load(QLocale(), QStringLiteral("kambara"), QStringLiteral("_"),
                  QStringLiteral(":/translations"))) {
        QCoreApplication::installTranslator(&own_);
    }
#if QT_VERSION >= QT_VERSION_CHECK(6, 0, 0)
    const QString folder = QLibraryInfo::path(QLibraryInfo::TranslationsPath);
#else
    const QString folder = QLibraryInfo::location(QLibraryInfo::TranslationsPath);
#endif
    if (qt_.load(QLocale(), QStringLiteral("qtbase"), QStringLiteral("_"), folder)) {
        QCoreApplication::installTranslator(&qt_);
    }
}

}  // namespace kambara
