// SPDX-License-Identifier: GPL-3.0-or-later
// window_benchmark [SECONDS]: the whole window on a 60 Hz stereo recording of 640 x 480, played in
// real time with every part open, first as it is, then with a painter that is slowed on purpose.
// Prints how long the window's event loop was busy at a stretch, the pipeline's rate and the
// memory, beside the bounds; exit code 1 when one is missed.
#include <unistd.h>

#include <QApplication>
#include <QEventLoop>
#include <QLocale>
#include <QTimer>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "tests/ui/recorded_rig.h"
#include "tests/ui/window_page.h"
#include "ui/base/theme.h"
#include "ui/scene3d/gl_probe.h"

namespace {

using namespace kambara;
using testing_support::RecordedRig;
using testing_support::WindowPage;

constexpr double rate_hz = 60.0;
constexpr std::int64_t warm_up_frames = 300;
constexpr int slow_painting_ms = 25;
constexpr double most_p99_ms = 16.0;
constexpr double most_worst_ms = 50.0;
constexpr double most_growth = 0.05;
constexpr double least_rate_share = 0.99;

// A thread that asks the event loop, again and again, how long it takes to answer.
class ResponseProbe {
  public:
    ResponseProbe() : thread_([this](const std::stop_token& stop) { run(stop); }) {}

    std::vector<double> answers_ms() {
        thread_.request_stop();
        // The last question is answered while this waits.
        while (!ended_) {
            QApplication::processEvents();
        }
        return answers_ms_;
    }

  private:
    void run(const std::stop_token& stop) {
        using Steady = std::chrono::steady_clock;
        while (!stop.stop_requested()) {
            const auto asked = Steady::now();
            std::atomic<bool> answered = false;
            QMetaObject::invokeMethod(
                qApp,
                [&] {
                    const double answer_ms =
                        std::chrono::duration<double, std::milli>(Steady::now() - asked).count();
                    // Those who would have asked meanwhile have waited as well.
                    for (double wait = answer_ms; wait > 0.0; wait -= 1.0) {
                        answers_ms_.push_back(wait);
                    }
                    answered = true;
                    answered.notify_one();
                },
                Qt::QueuedConnection);
            answered.wait(false);
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        ended_ = true;
    }

    std::vector<double> answers_ms_;  // the window's thread alone, until the end
    std::atomic<bool> ended_ = false;
    std::jthread thread_;
};

// As the program does; QTest's waiting sleeps between its looks.
void run_event_loop(int seconds) {
    QEventLoop loop;
    QTimer::singleShot(std::chrono::seconds(seconds), &loop, &QEventLoop::quit);
    loop.exec();
}

double resident_mb() {
    std::ifstream stat("/proc/self/statm");
    long total = 0;
    long resident = 0;
    stat >> total >> resident;
    return static_cast<double>(resident) * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1048576.0;
}

void require(bool so, const char* what) {
    if (!so) {
        throw std::runtime_error(what);
    }
}

bool check(const char* what, double value, const char* unit, double bound, bool at_most) {
    const bool kept = at_most ? value <= bound : value >= bound;
    std::printf("  %-34s %8.2f %-3s  (%s %.2f)  %s\n", what, value, unit,
                at_most ? "at most" : "at least", bound, kept ? "kept" : "MISSED");
    return kept;
}

bool measure(const RecordedRig& recorded, const std::string& profile, int seconds, int delay_ms) {
    ui::WindowOptions options = WindowPage::simulated();
    options.first = recorded.request();
    WindowPage page(options, profile);
    require(page.until_picture(), "no picture comes");
    page.drag(page.target());
    require(page.until_state(TrackState::tracking), "the target is not tracked");
    page.left().set_painting_delay_ms(delay_ms);
    page.right().set_painting_delay_ms(delay_ms);
    page.action("play").trigger();
    require(page.until([&] { return page.shown().frame > warm_up_frames; }),
            "the recording stands");

    const double memory_mb = resident_mb();
    const std::int64_t first = page.shown().frame;
    const auto begun = std::chrono::steady_clock::now();
    ResponseProbe probe;
    run_event_loop(seconds);
    std::vector<double> answers = probe.answers_ms();
    const double taken_s =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
    const Snapshot last = page.shown();
    const double growth = resident_mb() / memory_mb - 1.0;

    std::sort(answers.begin(), answers.end());
    const auto share = [&](double part) {
        return answers[static_cast<std::size_t>(part * static_cast<double>(answers.size() - 1))];
    };
    std::printf("%s, %d s, %zu questions to the event loop, 3-D view %s\n",
                delay_ms > 0 ? "Painter slowed" : "As it is", seconds, answers.size(),
                page.scene().works() ? "on" : "off");
    bool kept = true;
    if (delay_ms == 0) {
        std::printf("  %-34s %8.2f ms\n", "event gap, median", share(0.5));
        kept &= check("event gap, 99th percentile", share(0.99), "ms", most_p99_ms, true);
        kept &= check("event gap, worst", answers.back(), "ms", most_worst_ms, true);
        kept &= check("memory, growth", 100.0 * growth, "%", 100.0 * most_growth, true);
        std::printf("  %-34s %8.2f MB\n", "memory", memory_mb);
    } else {
        std::printf("  %-34s %8d ms\n", "painting slowed by", delay_ms);
        std::printf("  %-34s %8.2f ms\n", "event gap, 99th percentile", share(0.99));
    }
    const double rate = static_cast<double>(last.frame - first) / taken_s;
    kept &= check("pairs handled", rate, "Hz", least_rate_share * rate_hz, false);
    kept &= check("pairs lost", static_cast<double>(last.frames_lost), "", 0.0, true);
    kept &= check("tracked at the end", last.tracks.front().estimate.state == TrackState::tracking,
                  "", 1.0, false);
    return kept;
}

}  // namespace

int main(int argc, char** argv) {
    const int seconds = argc > 1 ? std::atoi(argv[1]) : 60;
    if (seconds < 1) {
        std::fputs("usage: window_benchmark [SECONDS]\n", stderr);
        return 2;
    }
    ui::prepare_for_gl();
    QLocale::setDefault(QLocale::c());
    QApplication application(argc, argv);
    ui::apply_theme(application);
    try {
        const std::string profile = "default?rate=60";
        std::printf("Recording %d s of the simulated rig ...\n", seconds + 10);
        std::fflush(stdout);
        const RecordedRig recorded = RecordedRig::as_videos(
            *simulated_profile(profile), static_cast<int>((seconds + 10) * rate_hz));
        bool kept = measure(recorded, profile, seconds, 0);
        kept &= measure(recorded, profile, std::max(1, seconds / 4), slow_painting_ms);
        return kept ? 0 : 1;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "window_benchmark: %s\n", error.what());
        return 1;
    }
}
