// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/background.h"

#include <QMetaObject>
#include <utility>

namespace kambara::ui {

void Background::on_window(std::function<void()> work) {
    QMetaObject::invokeMethod(
        this,
        [this, work = std::move(work)] {
            --under_way_;
            work();
        },
        Qt::QueuedConnection);
}

}  // namespace kambara::ui
