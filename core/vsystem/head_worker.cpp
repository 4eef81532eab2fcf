// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/head_worker.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "core/pointing/aim.h"

namespace kambara {
namespace {

constexpr std::chrono::milliseconds poll_interval{20};
constexpr std::int64_t kept_ns = 1'000'000'000;
constexpr auto renewal_ns = static_cast<std::int64_t>(1e9 * drive_renewal_s);

// A preset is one of several of its kind; focusing by itself replaces focusing by hand.
bool same_kind(const HeadWorker::Setting& a, const HeadWorker::Setting& b) {
    const auto focuses = [](const HeadWorker::Setting& one) {
        return std::holds_alternative<FocusHead>(one) || std::holds_alternative<AutofocusHead>(one);
    };
    if (const auto* keep = std::get_if<KeepPreset>(&a)) {
        return b == HeadWorker::Setting(*keep);
    }
    return a.index() == b.index() || (focuses(a) && focuses(b));
}

}  // namespace

HeadWorker::HeadWorker(std::shared_ptr<PanTiltCamera> head, Threading threading, const Clock& clock)
    : head_(std::move(head)), threading_(threading), clock_(clock), limits_(head_->limits()) {
    poll();  // so that the first reading is one
    thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

// Nobody is left who would say any more that it is to go on turning.
HeadWorker::~HeadWorker() {
    thread_.request_stop();
    thread_.join();
    if (driven_ || halt_waits_) {
        stop_moving();
    }
}

void HeadWorker::use_backlash(const HeadAngles& backlash) {
    std::lock_guard lock(mutex_);
    axes_ = HeadAxes(backlash);
    if (!past_.empty()) {
        axes_.see(status_.angles);
    }
}

HeadAngles HeadWorker::encoders_for(const HeadAngles& axes) {
    if (threading_ == Threading::inline_calls) {
        poll();
    }
    std::lock_guard lock(mutex_);
    return within_limits(axes_.encoders_for(axes), limits_);
}

HeadAngles HeadWorker::axes_at(const HeadAngles& encoders) {
    std::lock_guard lock(mutex_);
    return axes_.at(encoders);
}

bool HeadWorker::astray(const HeadAngles& axes) {
    std::lock_guard lock(mutex_);
    return axes_.astray(axes);
}

void HeadWorker::command(const HeadAngles& angles, bool by_hand) {
    put(Look{angles, by_hand});
}

void HeadWorker::follow(const HeadAim& aim) {
    put(Look{aim.angles, false, aim});
}

void HeadWorker::turn(const Turn& turn) {
    put(turn);
}

// Told the same again, only its time is made longer: the line to the head is slow.
void HeadWorker::drive(const HeadAngles& speed_rad_s) {
    {
        std::lock_guard lock(mutex_);
        drive_until_ns_ = clock_.now_ns() + renewal_ns;
        if (driven_ == speed_rad_s && move_fault_.empty()) {
            return;
        }
    }
    put(Drive{speed_rad_s});
}

void HeadWorker::end_drive() {
    bool driven = false;
    {
        std::lock_guard lock(mutex_);
        driven = driven_.has_value();
    }
    if (driven) {
        halt();
    }
}

void HeadWorker::put(const Wish& wish) {
    const auto* drive = std::get_if<Drive>(&wish);
    {
        std::lock_guard lock(mutex_);
        driven_ = drive != nullptr ? std::optional(drive->speed_rad_s) : std::nullopt;
        if (threading_ == Threading::own_thread) {
            waiting_ = wish;
        }
    }
    if (threading_ == Threading::inline_calls) {
        move(wish);
    }
    commanded_.notify_one();
}

void HeadWorker::set(const Setting& setting) {
    if (threading_ == Threading::inline_calls) {
        change(setting);
        return;
    }
    {
        std::lock_guard lock(mutex_);
        std::erase_if(settings_, [&](const Setting& one) { return same_kind(one, setting); });
        settings_.push_back(setting);
    }
    commanded_.notify_one();
}

void HeadWorker::halt() {
    {
        std::lock_guard lock(mutex_);
        driven_.reset();
        waiting_.reset();
        halt_waits_ = threading_ == Threading::own_thread;
    }
    if (threading_ == Threading::inline_calls) {
        stop_moving();
        return;
    }
    commanded_.notify_one();
}

HeadWorker::Reading HeadWorker::reading() {
    if (threading_ == Threading::inline_calls) {
        poll();
    }
    std::lock_guard lock(mutex_);
    return {status_, axes_.at(status_.angles), status_fault_.empty() ? move_fault_ : status_fault_,
            lens_, abilities_};
}

std::vector<HeadNote> HeadWorker::take_notes() {
    std::vector<HeadNote> notes = head_->take_notes();
    std::lock_guard lock(mutex_);
    std::move(notes_.begin(), notes_.end(), std::back_inserter(notes));
    notes_.clear();
    return notes;
}

bool HeadWorker::move_failed() const {
    std::lock_guard lock(mutex_);
    return !move_fault_.empty();
}

double HeadWorker::magnification() const {
    std::lock_guard lock(mutex_);
    return lens_ ? lens_->magnification() : 1.0;
}

void HeadWorker::run(const std::stop_token& stop) {
    const bool on_its_own = threading_ == Threading::own_thread;
    while (!stop.stop_requested()) {
        std::optional<Wish> wish;
        std::deque<Setting> settings;
        bool halt = false;
        {
            std::unique_lock lock(mutex_);
            if (!on_its_own) {
                commanded_.wait(lock, stop, [&] { return driven_.has_value(); });
            }
            commanded_.wait_for(lock, stop, poll_interval, [&] {
                return waiting_.has_value() || halt_waits_ || !settings_.empty();
            });
            halt = std::exchange(halt_waits_, false);
            wish = std::exchange(waiting_, std::nullopt);
            settings.swap(settings_);
        }
        if (drive_is_over()) {
            halt = true;
            if (wish && std::holds_alternative<Drive>(*wish)) {
                wish.reset();  // it waited for too long
            }
        }
        if (halt) {
            stop_moving();
        }
        if (wish) {
            move(*wish);
        }
        for (const Setting& setting : settings) {
            change(setting);
        }
        if (on_its_own) {
            poll();
        }
    }
}

// Whoever held the key or the stick is gone.
bool HeadWorker::drive_is_over() {
    std::lock_guard lock(mutex_);
    if (!driven_ || clock_.now_ns() < drive_until_ns_) {
        return false;
    }
    driven_.reset();
    notes_.push_back({HeadNote::Kind::warning,
                      "The head was halted: nobody said any more that it is to go on turning."});
    return true;
}

void HeadWorker::move(const Wish& wish) {
    const auto moved = carry_out(wish);
    std::lock_guard lock(mutex_);
    move_fault_ = moved ? std::string() : moved.error().text();
}

Result<Done> HeadWorker::carry_out(const Wish& wish) {
    if (const auto* look = std::get_if<Look>(&wish)) {
        return look->aim       ? head_->follow(*look->aim)
               : look->by_hand ? head_->move_by_hand(look->angles)
                               : head_->move_to(look->angles);
    }
    if (const auto* drive = std::get_if<Drive>(&wish)) {
        return head_->drive(drive->speed_rad_s.pan_rad, drive->speed_rad_s.tilt_rad);
    }
    struct Visitor {
        PanTiltCamera& head;
        Result<Done> operator()(const HomeHead&) { return head.home(); }
        Result<Done> operator()(const ResetHead&) { return head.reset(); }
        Result<Done> operator()(const RecallPreset& c) { return head.recall_preset(c.number); }
    };
    return std::visit(Visitor{*head_}, std::get<Turn>(wish));
}

void HeadWorker::change(const Setting& setting) {
    struct Visitor {
        PanTiltCamera& head;
        Result<Done> operator()(const ZoomHead& c) { return head.zoom_to(c.share); }
        Result<Done> operator()(const FocusHead& c) { return head.focus_to(c.share); }
        Result<Done> operator()(const AutofocusHead&) { return head.autofocus(); }
        Result<Done> operator()(const KeepPreset& c) { return head.keep_preset(c.number); }
    };
    if (const auto changed = std::visit(Visitor{*head_}, setting); !changed) {
        std::lock_guard lock(mutex_);
        notes_.push_back({HeadNote::Kind::fault, changed.error().text()});
    }
}

void HeadWorker::stop_moving() {
    const auto halted = head_->halt();
    std::lock_guard lock(mutex_);
    move_fault_ = halted ? std::string() : halted.error().text();
}

void HeadWorker::poll() {
    const auto status = head_->status();
    const auto lens = head_->lens();
    const HeadAbilities abilities = head_->abilities();
    const std::int64_t now_ns = clock_.now_ns();
    std::lock_guard lock(mutex_);
    status_fault_ = status ? std::string() : status.error().text();
    if (status) {
        status_ = *status;
        axes_.see(status->angles);
        past_.push_back({now_ns, axes_.at(status->angles)});
        while (past_.front().time_ns < now_ns - kept_ns) {
            past_.pop_front();
        }
    }
    lens_ = lens ? std::optional(*lens) : std::nullopt;
    abilities_ = abilities;
}

std::optional<HeadAngles> HeadWorker::axes_when(std::int64_t time_ns) {
    if (threading_ == Threading::inline_calls) {
        poll();
    }
    std::lock_guard lock(mutex_);
    if (!status_fault_.empty() || past_.empty()) {
        return std::nullopt;
    }
    if (threading_ == Threading::inline_calls || time_ns >= past_.back().time_ns) {
        return past_.back().axes;
    }
    for (std::size_t i = past_.size() - 1; i > 0; --i) {
        const Past& a = past_[i - 1];
        const Past& b = past_[i];
        if (time_ns >= a.time_ns) {
            const double share =
                static_cast<double>(time_ns - a.time_ns) /
                static_cast<double>(std::max<std::int64_t>(1, b.time_ns - a.time_ns));
            return HeadAngles{a.axes.pan_rad + share * (b.axes.pan_rad - a.axes.pan_rad),
                              a.axes.tilt_rad + share * (b.axes.tilt_rad - a.axes.tilt_rad)};
        }
    }
    return past_.front().axes;
}

}  // namespace kambara
