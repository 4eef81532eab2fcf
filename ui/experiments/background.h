// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

namespace kambara::ui {

/// One thread that does slow work for a window, piece after piece. Its members are called on the
/// window's thread, and there what follows a piece of work is called. What is still under way when
/// it goes is dropped.
class Background : public QObject {
    Q_OBJECT
  public:
    explicit Background(QObject* parent = nullptr);
    ~Background() override;

    /// Calls `work` on the thread, then `then` with what it returned on the window's.
    template <class Work, class Then>
    void run(Work work, Then then) {
        enqueue([this, work = std::move(work), then = std::move(then)] {
            on_window([then, result = work()] { then(result); });
        });
    }
    bool busy() const { return under_way_ > 0; }

  private:
    void enqueue(std::function<void()> work);
    void on_window(std::function<void()> work);
    void loop(const std::stop_token& stop);

    int under_way_ = 0;  // the window's thread alone
    std::mutex mutex_;
    std::condition_variable_any arrived_;
    std::deque<std::function<void()>> work_;
    std::jthread thread_;
};

}  // namespace kambara::ui
