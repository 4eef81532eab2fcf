// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QVector>

#include "ui/shell/system_link.h"

namespace kambara::ui {

/// The recordings opened lately, newest first, kept in the settings.
class RecentRecordings {
  public:
    static constexpr int most = 8;

    static QVector<SourceRequest> load();
    static void remember(const SourceRequest& request);
    static QString title(const SourceRequest& request);
};

}  // namespace kambara::ui
