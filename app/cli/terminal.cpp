// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>

namespace kambara::cli {
namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

void on_interrupt(int) {
    interrupt_seen = 1;
}

constexpr std::int64_t least_interval_ns = 100'000'000;
constexpr int bar_width = 30;

}  // namespace

bool error_is_terminal() {
    return isatty(STDERR_FILENO) == 1;
}
bool output_is_terminal() {
    return isatty(STDOUT_FILENO) == 1;
}

void catch_interrupt() {
    std::signal(SIGINT, on_interrupt);
    std::signal(SIGTERM, on_interrupt);
}

bool interrupted() {
    return interrupt_seen != 0;
}

ProgressLine::ProgressLine() = default;

ProgressLine::~ProgressLine() {
    if (shown_) {
        std::fputs("\r\033[K", stderr);
    }
}

void ProgressLine::show(double share, const std::string& text) {
    const int full = static_cast<int>(std::clamp(share, 0.0, 1.0) * bar_width);
    show("[" + std::string(static_cast<std::size_t>(full), '#') +
         std::string(static_cast<std::size_t>(bar_width - full), ' ') + "] " + text);
}

void ProgressLine::show(const std::string& text) {
    const std::int64_t now_ns = std::chrono::duration_cast<std::chrono::nanoseconds>(
                                    std::chrono::steady_clock::now().time_since_epoch())
                                    .count();
    if (!error_is_terminal() || (shown_ && now_ns - last_ns_ < least_interval_ns)) {
        return;
    }
    last_ns_ = now_ns;
    shown_ = true;
    std::fprintf(stderr, "\r\033[K%s", text.c_str());
    std::fflush(stderr);
}

}  // namespace kambara::cli
