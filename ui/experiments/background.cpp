// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/background.h"

#include <QMetaObject>
#include <utility>

namespace kambara::ui {

Background::Background(QObject* parent) : QObject(parent) {
    thread_ = std::jthread([this](std::stop_token stop) { loop(stop); });
}

Background::~Background() = default;

void Background::enqueue(std::function<void()> work) {
    ++under_way_;
    {
        std::lock_guard lock(mutex_);
        work_.push_back(std::move(work));
    }
    arrived_.notify_one();
}

void Background::on_window(std::function<void()> work) {
    QMetaObject::invokeMethod(
        this,
        [this, work = std::move(work)] {
            --under_way_;
            work();
        },
        Qt::QueuedConnection);
}

void Background::loop(const std::stop_token& stop) {
    while (true) {
        std::function<void()> work;
        {
            std::unique_lock lock(mutex_);
            if (!arrived_.wait(lock, stop, [&] { return !work_.empty(); }) ||
                stop.stop_requested()) {
                return;
            }
            work = std::move(work_.front());
            work_.pop_front();
        }
        work();
    }
}

}  // namespace kambara::ui
