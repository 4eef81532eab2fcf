// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/evi_camera.h"

#include <chrono>
#include <cmath>
#include <utility>

#include "core/base/digits.h"

namespace kambara::visca {
namespace {

constexpr std::int64_t patience_ns = 2'000'000'000;
constexpr std::chrono::milliseconds last_words{300};
constexpr int manual_focus = 3;
constexpr int auto_focus = 2;

// As a person would write it.
std::string degrees_text(double angle_rad) {
    return digits(std::round(100.0 * deg_from_rad(angle_rad)) / 100.0);
}

Error no_share(const char* what, double share) {
    return {std::string("The ") + what + " can't be set to " + digits(share) + ".",
            "Give a number from 0 to 1."};
}

}  // namespace

EviCamera::EviCamera(std::unique_ptr<Link> link, const Clock& clock, HeadDriver::Options options)
    : link_(std::move(link)),
      name_(link_->name()),
      driver_(*link_, queue_, clock, std::move(options)),
      thread_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
              driver_.step();
          }
          const auto until = std::chrono::steady_clock::now() + last_words;
          while (driver_.halts() && std::chrono::steady_clock::now() < until) {
              driver_.step();
          }
      }) {}

EviCamera::~EviCamera() {
    thread_.request_stop();
    link_->wake();
}

Result<Done> EviCamera::wait_until_known(std::int64_t patience) {
    const auto until = std::chrono::steady_clock::now() + std::chrono::nanoseconds(patience);
    while (!driver_.status()) {
        if (std::chrono::steady_clock::now() >= until) {
            // What went wrong first says more than that nothing came of it.
            for (const HeadNote& note : driver_.take_notes()) {
                if (note.kind == HeadNote::Kind::fault) {
                    return Error{note.text, ""};
                }
            }
            return Error{driver_.fault(), ""};
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return Done{};
}

HeadLimits EviCamera::limits() const {
    const auto model = driver_.model();
    return model ? model->limits() : HeadLimits{};
}

HeadAbilities EviCamera::abilities() const {
    const auto model = driver_.model();
    return {true, true, true, true, true, model ? model->presets : 0};
}

Result<Done> EviCamera::look(const HeadAngles& angles, bool by_hand) {
    const HeadLimits most = limits();
    // Written so that what is not a number is refused as well.
    if (!(std::abs(angles.pan_rad) <= most.pan_rad && std::abs(angles.tilt_rad) <= most.tilt_rad)) {
        return Error{"The head can't turn to pan " + degrees_text(angles.pan_rad) + ", tilt " +
                         degrees_text(angles.tilt_rad) + " degrees.",
                     "Keep within " + degrees_text(most.pan_rad) + " and " +
                         degrees_text(most.tilt_rad) + " degrees."};
    }
    queue_.put(Motion{Motion::Kind::look, angles, {}, by_hand});
    link_->wake();
    return Done{};
}

Result<Done> EviCamera::move_to(const HeadAngles& angles) {
    return look(angles, false);
}

Result<Done> EviCamera::follow(const HeadAim& aim) {
    const HeadLimits most = limits();
    if (!(std::abs(aim.angles.pan_rad) <= most.pan_rad &&
          std::abs(aim.angles.tilt_rad) <= most.tilt_rad)) {
        return look(aim.angles, false);  // which says why not
    }
    queue_.put(Motion{Motion::Kind::look, aim.angles, {}, false, aim});
    link_->wake();
    return Done{};
}

Result<Done> EviCamera::move_by_hand(const HeadAngles& angles) {
    return look(angles, true);
}

Result<Done> EviCamera::halt() {
    queue_.halt();
    link_->wake();
    return Done{};
}

Result<HeadStatus> EviCamera::status() {
    return driver_.status();
}

Result<Done> EviCamera::drive(double pan_rad_s, double tilt_rad_s) {
    if (!std::isfinite(pan_rad_s) || !std::isfinite(tilt_rad_s)) {
        return Error{"The head can't turn at such a speed.", "Give degrees a second."};
    }
    if (pan_rad_s == 0.0 && tilt_rad_s == 0.0) {
        return halt();
    }
    queue_.put(Motion{Motion::Kind::drive, {pan_rad_s, tilt_rad_s}, {}, true});
    link_->wake();
    return Done{};
}

Result<Done> EviCamera::home() {
    queue_.put(Motion{Motion::Kind::other, {}, {Op::home}, true});
    link_->wake();
    return Done{};
}

Result<Done> EviCamera::reset() {
    queue_.put(Motion{Motion::Kind::other, {}, {Op::reset}, true});
    link_->wake();
    return Done{};
}

Result<HeadKind> EviCamera::known_model() const {
    auto model = driver_.model();
    if (!model) {
        return Error{driver_.fault(), ""};
    }
    return std::move(*model);
}

Result<Done> EviCamera::tell(const Message& setting) {
    queue_.put(setting);
    link_->wake();
    return Done{};
}

Result<Done> EviCamera::zoom_to(double share) {
    const auto model = known_model();
    if (!model) {
        return model.error();
    }
    if (!(share >= 0.0 && share <= 1.0)) {
        return no_share("zoom", share);
    }
    return tell({Op::zoom_direct, {static_cast<int>(std::lround(share * model->zoom.tele))}});
}

Result<Done> EviCamera::focus_to(double share) {
    const auto model = known_model();
    if (!model) {
        return model.error();
    }
    if (!(share >= 0.0 && share <= 1.0)) {
        return no_share("focus", share);
    }
    const double position = model->focus_far + share * (model->focus_near - model->focus_far);
    queue_.put(Message{Op::focus_mode, {manual_focus}});
    return tell({Op::focus_direct, {static_cast<int>(std::lround(position))}});
}

Result<Done> EviCamera::autofocus() {
    return tell({Op::focus_mode, {auto_focus}});
}

Result<LensStatus> EviCamera::lens() {
    return driver_.lens();
}

Result<Done> EviCamera::keep_preset(int number) {
    const auto model = known_model();
    if (!model) {
        return model.error();
    }
    if (number < 0 || number >= model->presets) {
        return Error{"There is no preset " + std::to_string(number) + ".",
                     "Give a number from 0 to " + std::to_string(model->presets - 1) + "."};
    }
    return tell({Op::memory_set, {number}});
}

Result<Done> EviCamera::recall_preset(int number) {
    const auto model = known_model();
    if (!model) {
        return model.error();
    }
    if (number < 0 || number >= model->presets) {
        return Error{"There is no preset " + std::to_string(number) + ".",
                     "Give a number from 0 to " + std::to_string(model->presets - 1) + "."};
    }
    queue_.put(Motion{Motion::Kind::other, {}, {Op::memory_recall, {number}}, true});
    link_->wake();
    return Done{};
}

std::vector<HeadNote> EviCamera::take_notes() {
    return driver_.take_notes();
}

Result<std::unique_ptr<EviCamera>> open_evi_camera(const std::string& text, const Clock& clock) {
    const auto uri = parse_head_uri(text);
    if (!uri) {
        return uri.error();
    }
    HeadDriver::Options options;
    options.heads = built_in_heads();
    if (!uri->heads.empty()) {
        auto heads = read_heads_file(uri->heads);
        if (!heads) {
            return heads.error();
        }
        options.heads = std::move(*heads);
    }
    if (!uri->model.empty()) {
        options.model = find_head(options.heads, std::string_view(uri->model));
        if (!options.model) {
            std::string known;
            for (const HeadKind& head : options.heads) {
                known += (known.empty() ? "" : ", ") + head.name;
            }
            return Error{"The model of head " + uri->model + " is not known.",
                         "These are: " + known + "."};
        }
    }
    options.session.wiring = uri->wiring;
    options.session.address = uri->address;
    options.session.checks_sequence = uri->checks_sequence;
    options.session.reply_timeout_ns = std::int64_t{uri->timeout_ms} * 1'000'000;
    if (options.model) {
        options.session.dialect = options.model->dialect();
    }
    if (uri->wiring == Wiring::serial) {
        options.session.byte_ns = 10'000'000'000 / uri->baud;
    }
    auto camera = std::make_unique<EviCamera>(make_link(*uri, clock), clock, std::move(options));
    if (const auto known = camera->wait_until_known(patience_ns); !known) {
        return known.error();
    }
    return camera;
}

}  // namespace kambara::visca
