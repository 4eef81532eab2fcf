// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <utility>

#include "core/base/work_thread.h"

namespace kambara::ui {

/// One thread that does slow work for a window, piece after piece. Its members are called on the
/// window's thread, and there what follows a piece of work is called. What is still under way when
/// it goes is dropped.
class Background : public QObject {
    Q_OBJECT
  public:
    explicit Background(QObject* parent = nullptr) : QObject(parent) {}

    /// Calls `work` on the thread, then `then` with what it returned on the window's.
    template <class Work, class Then>
    void run(Work work, Then then) {
        ++under_way_;
        thread_.put([this, work = std::move(work), then = std::move(then)] {
            on_window([then, result = work()] { then(result); });
        });
    }
    bool busy() const { return under_way_ > 0; }

  private:
    void on_window(std::function<void()> work);

    int under_way_ = 0;  // the window's thread alone
    WorkThread thread_;  // last, so that it ends before what it uses
};

}  // namespace kambara::ui
