// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/session_worker.h"

#include <QMetaObject>
#include <cmath>
#include <utility>

#include "core/base/text_file.h"
#include "core/camera/rig_file.h"

namespace kambara::ui {
namespace {

constexpr int first_learnt_at = 4;  // shots; fewer tell a lens too little
constexpr int learnt_every = 4;
constexpr double at_home_rad = 0.003;

PictureSet pictures_of(const Snapshot& snapshot, const SessionSetup& setup) {
    const PictureSet all{snapshot.pictures.stereo.left.picture,
                         snapshot.pictures.stereo.right.picture,
                         snapshot.pictures.pan_tilt.picture};
    PictureSet taken;
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (setup.cameras[c]) {
            taken[c] = all[c];
        }
    }
    return taken;
}

// The pan-tilt camera's place is calibrated with its head at home.
bool head_is_away(const Snapshot& snapshot) {
    return snapshot.head &&
           (snapshot.head->moving || std::abs(snapshot.head->angles.pan_rad) > at_home_rad ||
            std::abs(snapshot.head->angles.tilt_rad) > at_home_rad);
}

}  // namespace

SessionWorker::SessionWorker(CalibrationPorts ports, QObject* parent)
    : QObject(parent), ports_(std::move(ports)) {}

SessionWorker::~SessionWorker() {
    worker_.end();
    solver_ = {};
}

// What is still under way when the worker goes is dropped with it.
void SessionWorker::on_window(std::function<void()> work) {
    QMetaObject::invokeMethod(this, std::move(work), Qt::QueuedConnection);
}

void SessionWorker::begin(const SessionSetup& setup, const std::filesystem::path& folder) {
    worker_.put([this, setup, folder] {
        take(CalibrationSession::begin(setup, {}, folder, ports_.write_picture), folder);
    });
}

void SessionWorker::resume(const std::filesystem::path& folder) {
    worker_.put(
        [this, folder] { take(CalibrationSession::resume(folder, ports_.write_picture), folder); });
}

void SessionWorker::take(Result<CalibrationSession> session, const std::filesystem::path& folder) {
    if (!session) {
        on_window([this, error = session.error()] { emit failed(error); });
        return;
    }
    solver_ = {};
    session_ = std::move(*session);
    folder_ = folder;
    ++generation_;
    learnt_at_ = static_cast<int>(session_->kept_views().size());
    on_window([this] { emit begun(); });
    tell_state();
}

void SessionWorker::watch(bool on) {
    watching_ = on;
}

void SessionWorker::offer(const SnapshotPtr& snapshot) {
    if (!watching_) {
        return;
    }
    newest_.put(snapshot);
    // One look is enough for however many pictures come before it.
    if (!look_pending_.exchange(true)) {
        worker_.put([this] { look_at_newest(); });
    }
}

void SessionWorker::look_at_newest() {
    look_pending_ = false;
    const auto snapshot = newest_.try_take();
    if (!snapshot || !session_ || !watching_) {
        return;
    }
    auto result = std::make_shared<SessionLook>();
    result->pictures = pictures_of(**snapshot, session_->setup());
    if (session_->setup().cameras[2] && head_is_away(**snapshot)) {
        result->look.why_not = "The pan-tilt head is not at home: turn it home first.";
    } else {
        auto look = by_hand_.exchange(false)
                        ? session_->capture(find_in_all(result->pictures, session_->setup().target),
                                            result->pictures)
                        : session_->look(result->pictures);
        if (!look) {
            on_window([this, error = look.error()] { emit failed(error); });
            return;
        }
        result->look = std::move(*look);
    }
    on_window([this, result] { emit looked(result); });
    if (result->look.shot) {
        tell_state();
        const auto kept = static_cast<int>(session_->kept_views().size());
        if (kept >= first_learnt_at && kept >= learnt_at_ + learnt_every && !solving_for_window_) {
            learnt_at_ = kept;
            solve_on_thread(true);
        }
    }
}

void SessionWorker::tell_state() {
    auto state = std::make_shared<SessionState>();
    state->setup = session_->setup();
    state->folder = folder_;
    state->shots = session_->shots();
    state->kept = static_cast<int>(session_->kept_views().size());
    state->can_undo = session_->can_undo();
    state->coverage = session_->coverage();
    state->next = session_->what_next();
    state->range_error = state->kept > 0 ? session_->predicted_range_error() : 0.0;
    on_window([this, state] { emit changed(state); });
}

void SessionWorker::after(const Result<Done>& done) {
    if (!done) {
        on_window([this, error = done.error()] { emit failed(error); });
        return;
    }
    tell_state();
}

void SessionWorker::set_kept(int shot, bool kept) {
    worker_.put([this, shot, kept] {
        if (session_) {
            after(kept ? session_->keep(shot) : session_->drop(shot));
        }
    });
}

void SessionWorker::undo() {
    worker_.put([this] {
        if (session_) {
            after(session_->undo());
        }
    });
}

void SessionWorker::solve() {
    solving_for_window_ = true;
    worker_.put([this] {
        if (session_) {
            solve_on_thread(false);
        }
    });
}

void SessionWorker::cancel() {
    worker_.put([this] { solver_.request_stop(); });
}

void SessionWorker::solve_on_thread(bool quietly) {
    solver_ = {};  // one that is under way is stopped and waited for
    auto outcome = std::make_shared<SessionOutcome>();
    outcome->setup = session_->setup();
    outcome->shots = session_->shots();
    outcome->coverage = session_->coverage();
    outcome->settings = settings_text(outcome->setup);
    SessionProblem problem = session_->problem();
    outcome->numbers = problem.numbers;
    problem.options.held_out = !quietly;
    solver_ = std::jthread(
        [this, quietly, outcome, problem, generation = generation_](std::stop_token stop) {
            outcome->report = problem.solve(stop, [&](double share) {
                if (!quietly) {
                    on_window([this, share] { emit progressed(share); });
                }
            });
            const bool stopped = stop.stop_requested();
            if (!quietly) {
                solving_for_window_ = false;
            }
            if (stopped) {
                if (!quietly) {
                    on_window([this] { emit cancelled(); });
                }
                return;
            }
            worker_.put([this, quietly, outcome, generation] {
                if (generation != generation_) {
                    return;  // of a session that was left
                }
                if (const auto done = session_->learn(outcome->report); !done) {
                    on_window([this, error = done.error()] { emit failed(error); });
                }
                if (!quietly) {
                    on_window([this, outcome] { emit solved(outcome); });
                }
            });
        });
}

void SessionWorker::save_rig(const SessionOutcomePtr& solved, const std::filesystem::path& path) {
    worker_.put([this, solved, path] {
        auto rig = rig_with_provenance(*solved, folder_, ports_);
        const auto done = rig ? write_rig_file(path, *rig) : Result<Done>(rig.error());
        on_window([this, done, path] {
            if (done) {
                emit saved(QString::fromStdString(path.string()));
            } else {
                emit failed(done.error());
            }
        });
    });
}

void SessionWorker::save_report(const SessionOutcomePtr& solved,
                                const std::filesystem::path& path) {
    worker_.put([this, solved, path] {
        const auto done = write_text_file_atomically(path, ports_.report_page(*solved));
        on_window([this, done, path] {
            if (done) {
                emit saved(QString::fromStdString(path.string()));
            } else {
                emit failed(done.error());
            }
        });
    });
}

}  // namespace kambara::ui
