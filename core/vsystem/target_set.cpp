// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/vsystem/target_set.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/vsystem/command.h"

namespace kambara {
namespace {

Error no_such_target(int id) {
    return {"There is no target " + std::to_string(id) + ".",
            "Choose it in the left picture first."};
}

// From the pair in which the template was chosen to the one at hand, as far as they are still
// remembered: the target has moved on while the operator looked.
void catch_up(FollowedTarget& target, const std::deque<StereoFrame>& pairs) {
    const std::int64_t now = pairs.back().left.index;
    const std::int64_t since = target.template_frame.value_or(now);
    // A template of a later pair than this one: the recording was wound back since.
    const bool gapless = since <= now && pairs.front().left.index <= since + 1;
    if (!gapless) {
        target.tracker.forget_motion();  // it may be anywhere by now
    }
    for (const StereoFrame& pair : pairs) {
        if (gapless && pair.left.index > since && pair.left.index < now) {
            target.tracker.process(pair);
        }
    }
    target.template_frame.reset();
    target.tracker.process(pairs.back());
}

}  // namespace

TargetSet::TargetSet(Rig rig, const TrackerOptions& options, int threads)
    : rig_(std::move(rig)), options_(options), workers_(threads) {}

const FollowedTarget* TargetSet::find(int id) const {
    const auto target = std::find_if(targets_.begin(), targets_.end(),
                                     [&](const FollowedTarget& t) { return t.id == id; });
    return target == targets_.end() ? nullptr : &*target;
}

FollowedTarget* TargetSet::own(int id) {
    return const_cast<FollowedTarget*>(std::as_const(*this).find(id));
}

TargetStates TargetSet::states() const {
    TargetStates states;
    for (const FollowedTarget& target : targets_) {
        states.of[target.id] = target.tracker.estimate().state;
    }
    if (steered() != nullptr) {
        states.steered = steered_;
    }
    return states;
}

Result<std::vector<FollowedTarget*>> TargetSet::chosen(std::optional<int> id) {
    std::vector<FollowedTarget*> targets;
    for (FollowedTarget& target : targets_) {
        if (!id || target.id == *id) {
            targets.push_back(&target);
        }
    }
    if (id && targets.empty()) {
        return no_such_target(*id);
    }
    return targets;
}

Result<Done> TargetSet::set_template(std::optional<int> id, const StereoFrame& pair,
                                     const Rectangle& rectangle) {
    const int wanted = id.value_or(steered_);
    if (wanted < 1 || wanted > most_targets) {
        return Error{"Targets have the numbers 1 to " + std::to_string(most_targets) +
                         ": there can't be a target " + std::to_string(wanted) + ".",
                     "Clear a target, then choose this one with its number."};
    }
    FollowedTarget* known = own(wanted);
    FollowedTarget fresh{wanted, StereoTracker(rig_, options_, transforms_), std::nullopt};
    FollowedTarget& target = known != nullptr ? *known : fresh;
    if (auto done = target.tracker.set_template(pair, rectangle); !done) {
        return done;
    }
    target.tracker.follow_vehicle(vehicle_);
    target.template_frame = pair.left.index;
    if (known == nullptr) {
        const auto place = std::find_if(targets_.begin(), targets_.end(),
                                        [&](const FollowedTarget& t) { return t.id > wanted; });
        targets_.insert(place, std::move(fresh));
    }
    if (targets_.size() == 1) {
        steered_ = wanted;
    }
    return Done{};
}

Result<Done> TargetSet::start(std::optional<int> id, const std::deque<StereoFrame>& pairs) {
    const auto targets = chosen(id);
    if (!targets) {
        return targets.error();
    }
    if (targets->empty()) {
        return Error{"There is no template to follow.", "Choose one in the left picture first."};
    }
    std::vector<FollowedTarget*> starting;
    for (FollowedTarget* target : *targets) {
        if (target->tracker.started()) {
            continue;
        }
        if (auto started = target->tracker.start(); !started) {
            return started;
        }
        starting.push_back(target);
    }
    workers_.for_each(starting.size(), [&](std::size_t i) { catch_up(*starting[i], pairs); });
    return Done{};
}

Result<Done> TargetSet::stop(std::optional<int> id) {
    const auto targets = chosen(id);
    if (!targets) {
        return targets.error();
    }
    for (FollowedTarget* target : *targets) {
        target->tracker.stop();
    }
    return Done{};
}

Result<Done> TargetSet::clear(std::optional<int> id) {
    if (id && find(*id) == nullptr) {
        return no_such_target(*id);
    }
    std::erase_if(targets_, [&](const FollowedTarget& target) { return !id || target.id == *id; });
    if (steered() == nullptr) {
        steered_ = targets_.empty() ? 1 : targets_.front().id;
    }
    return Done{};
}

Result<Done> TargetSet::update_template(std::optional<int> id) {
    const int wanted = id.value_or(steered_);
    FollowedTarget* target = own(wanted);
    return target != nullptr ? target->tracker.update_template()
                             : Result<Done>(no_such_target(wanted));
}

Result<Done> TargetSet::steer_to(int id) {
    if (find(id) == nullptr) {
        return no_such_target(id);
    }
    steered_ = id;
    return Done{};
}

void TargetSet::process(const StereoFrame& pair) {
    workers_.for_each(targets_.size(), [&](std::size_t i) { targets_[i].tracker.process(pair); });
}

void TargetSet::wound() {
    vehicle_->clear();
    for (FollowedTarget& target : targets_) {
        target.tracker.stop();
        target.tracker.forget_motion();
        target.template_frame.reset();
    }
}

void TargetSet::use_rig(const Rig& rig) {
    rig_ = rig;
    targets_.clear();
    steered_ = 1;
}

}  // namespace kambara
