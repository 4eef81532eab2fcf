// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/system_link.h"

#include <QMetaObject>
#include <future>
#include <utility>

namespace kambara::ui {

SystemLink::SystemLink(SystemOpener opener, QObject* parent)
    : QObject(parent), opener_(std::move(opener)) {}

SystemLink::~SystemLink() {
    opening_.end();
    worker_.end();
    if (system_) {
        (void)system_->execute(HaltHead{});  // nobody is left who would; without a head, refused
    }
    snapshots_.reset();
    events_.reset();
    system_.reset();
}

void SystemLink::enqueue(std::function<void()> work) {
    began();
    worker_.put([this, work = std::move(work)] {
        work();
        on_window([this] { finished(); });
    });
}

void SystemLink::began() {
    if (under_way_++ == 0) {
        emit busy_changed(true);
    }
}

void SystemLink::finished() {
    if (--under_way_ == 0) {
        emit busy_changed(false);
    }
}

// What is still under way when the link goes is dropped with it.
void SystemLink::on_window(std::function<void()> work) {
    QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection);
}

// The worker has its hands free meanwhile: the system before goes on, and hears what it is told, a
// halt most of all.
void SystemLink::open(const SourceRequest& request) {
    began();
    opening_.put([this, request] {
        auto system = opener_(request);
        const auto taken = std::make_shared<std::promise<void>>();
        worker_.put([this, &request, &system, taken] {
            take(request, std::move(system));
            taken->set_value();
        });
        taken->get_future().wait();
        on_window([this] { finished(); });
    });
}

void SystemLink::take(const SourceRequest& request, Result<OpenedSystem> system) {
    if (!system) {
        on_window([this, request, error = system.error()] { emit open_failed(request, error); });
        return;
    }
    snapshots_.reset();
    events_.reset();
    system_ = std::move(system->system);
    newest_.try_take();
    // Nothing of the new system comes before the window knows of it.
    on_window(
        [this, request, rig = system_->rig(), hand = system->hand, stations = system->stations] {
            hand_ = hand;
            stations_ = stations;
            emit opened(request, rig);
            enqueue([this] { watch(); });
        });
}

void SystemLink::watch() {
    const int generation = ++generation_;
    events_ = system_->observe_events([this, generation](const Event& event) {
        on_window([this, generation, event] {
            if (generation == generation_) {
                emit event_came(event);
            }
        });
    });
    snapshots_ = system_->observe([this](const SnapshotPtr& snapshot) {
        std::lock_guard lock(order_);
        put(snapshot);
    });
    // What came before anybody watched. The lock keeps it from taking a newer one's place.
    std::lock_guard lock(order_);
    put(system_->latest());
}

void SystemLink::put(const SnapshotPtr& snapshot) {
    newest_.put(snapshot);
    // One call is enough for however many snapshots come before the window sees to it.
    if (!fetch_pending_.exchange(true)) {
        on_window([this] { fetch(); });
    }
}

void SystemLink::fetch() {
    fetch_pending_ = false;
    if (const auto snapshot = newest_.try_take()) {
        emit snapshot_came(*snapshot);
    }
}

void SystemLink::send(std::vector<Command> commands) {
    enqueue([this, commands = std::move(commands)] { execute(commands); });
}

void SystemLink::send_newest(const Command& command) {
    const std::size_t kind = command.index();
    {
        std::lock_guard lock(mutex_);
        if (!newest_of_kind_.insert_or_assign(kind, command).second) {
            return;
        }
    }
    enqueue([this, kind] {
        std::vector<Command> commands;
        {
            std::lock_guard lock(mutex_);
            const auto waiting = newest_of_kind_.extract(kind);
            commands.push_back(waiting.mapped());
        }
        execute(commands);
    });
}

void SystemLink::execute(const std::vector<Command>& commands) {
    if (!system_) {
        return;
    }
    for (const Command& command : commands) {
        if (const auto reply = system_->execute(command); !reply) {
            on_window([this, error = reply.error()] { emit refused(error); });
            return;
        }
    }
}

}  // namespace kambara::ui
