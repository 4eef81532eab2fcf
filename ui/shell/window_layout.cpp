// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/window_layout.h"

#include <QDockWidget>
#include <QGuiApplication>
#include <QMainWindow>
#include <QScreen>
#include <QSettings>
#include <algorithm>

namespace kambara::ui {
namespace {

constexpr int version = 1;  // of the set of docks
const QString geometry_key = QStringLiteral("window/geometry");
const QString docks_key = QStringLiteral("window/docks");

QVector<QRect> screens() {
    QVector<QRect> areas;
    for (const QScreen* screen : QGuiApplication::screens()) {
        areas << screen->availableGeometry();
    }
    return areas;
}

}  // namespace

QRect onto_screens(const QRect& window, const QVector<QRect>& screens) {
    if (screens.isEmpty()) {
        return window;
    }
    const auto overlap = [&](const QRect& screen) {
        const QRect common = screen.intersected(window);
        return common.isEmpty() ? 0LL : 1LL * common.width() * common.height();
    };
    const QRect screen =
        *std::max_element(screens.begin(), screens.end(),
                          [&](const QRect& a, const QRect& b) { return overlap(a) < overlap(b); });
    QRect place = window;
    place.setSize(window.size().boundedTo(screen.size()));
    place.moveLeft(std::clamp(place.left(), screen.left(), screen.right() - place.width() + 1));
    place.moveTop(std::clamp(place.top(), screen.top(), screen.bottom() - place.height() + 1));
    return place;
}

void save_layout(const QMainWindow& window) {
    QSettings settings;
    settings.setValue(geometry_key, window.saveGeometry());
    settings.setValue(docks_key, window.saveState(version));
}

void give_default_size(QMainWindow& window) {
    const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
    const QSize size = QSize(1600, 950).boundedTo(screen.size());
    window.setGeometry(QRect(screen.center() - QPoint(size.width() / 2, size.height() / 2), size));
}

void load_layout(QMainWindow& window) {
    QSettings settings;
    const QByteArray geometry = settings.value(geometry_key).toByteArray();
    if (!geometry.isEmpty()) {
        window.restoreGeometry(geometry);
    }
    window.restoreState(settings.value(docks_key).toByteArray(), version);
    if (!window.isMaximized() && !window.isFullScreen()) {
        window.setGeometry(onto_screens(window.geometry(), screens()));
    }
    for (auto* dock : window.findChildren<QDockWidget*>()) {
        if (dock->isFloating()) {
            dock->setGeometry(onto_screens(dock->geometry(), screens()));
        }
    }
}

}  // namespace kambara::ui
