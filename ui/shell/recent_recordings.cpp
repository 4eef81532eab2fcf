// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/recent_recordings.h"

#include <QFileInfo>
#include <QSettings>

namespace kambara::ui {
namespace {

const QString list_key = QStringLiteral("recent_recordings");

}  // namespace

QVector<SourceRequest> RecentRecordings::load() {
    QVector<SourceRequest> requests;
    QSettings settings;
    const int count = settings.beginReadArray(list_key);
    for (int i = 0; i < count && i < most; ++i) {
        settings.setArrayIndex(i);
        const auto text = [&](const char* key) {
            return settings.value(QLatin1String(key)).toString().toStdString();
        };
        requests.push_back({text("left"), text("right"), text("rig"),
                            settings.value(QStringLiteral("pictures_rate_hz"), 10.0).toDouble()});
    }
    settings.endArray();
    return requests;
}

void RecentRecordings::remember(const SourceRequest& request) {
    QVector<SourceRequest> requests = load();
    requests.removeAll(request);
    requests.push_front(request);
    if (requests.size() > most) {
        requests.resize(most);
    }
    QSettings settings;
    settings.beginWriteArray(list_key, static_cast<int>(requests.size()));
    for (int i = 0; i < static_cast<int>(requests.size()); ++i) {
        settings.setArrayIndex(i);
        settings.setValue(QStringLiteral("left"), QString::fromStdString(requests[i].left));
        settings.setValue(QStringLiteral("right"), QString::fromStdString(requests[i].right));
        settings.setValue(QStringLiteral("rig"), QString::fromStdString(requests[i].rig));
        settings.setValue(QStringLiteral("pictures_rate_hz"), requests[i].pictures_rate_hz);
    }
    settings.endArray();
}

QString RecentRecordings::title(const SourceRequest& request) {
    const QFileInfo left(QString::fromStdString(request.left));
    const QString folder = QFileInfo(left.absolutePath()).fileName();
    return request.right.empty()
               ? QStringLiteral("%1/%2").arg(folder, left.fileName())
               : QStringLiteral("%1/%2 + %3")
                     .arg(folder, left.fileName(),
                          QFileInfo(QString::fromStdString(request.right)).fileName());
}

}  // namespace kambara::ui
