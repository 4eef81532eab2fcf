// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/head_sequence.h"

#include <cmath>
#include <utility>

namespace kambara::ui {
namespace {

constexpr double pan_step_rad = rad_from_deg(13.0);
constexpr double tilt_step_rad = rad_from_deg(6.5);
constexpr double run_up_rad = rad_from_deg(3.0);  // well beyond any backlash
// Beyond a motor step of the EVI-D30's (0.11 degrees), within the run-up.
constexpr double there_rad = rad_from_deg(0.5);
constexpr std::int64_t settle_ms = 700;  // until a picture from after the stop is on show
constexpr std::int64_t patience_ms = 15000;

bool reaches(const HeadAngles& angles, const HeadLimits& limits) {
    return std::abs(angles.pan_rad) <= limits.pan_rad &&
           std::abs(angles.tilt_rad) <= limits.tilt_rad;
}

bool is_at(const HeadSnapshot& head, const HeadAngles& goal) {
    return !head.moving && std::abs(head.angles.pan_rad - goal.pan_rad) < there_rad &&
           std::abs(head.angles.tilt_rad - goal.tilt_rad) < there_rad;
}

}  // namespace

std::vector<HeadStep> head_steps_about(const HeadAngles& towards, const HeadLimits& limits) {
    std::vector<HeadStep> steps;
    for (const int pass : {1, -1}) {
        int number = 0;
        for (const int row : {-1, 0, 1}) {
            for (const int across : {-1, 0, 1}) {
                // To and fro, so that the next one is a neighbour.
                const int column = row == 0 ? -across : across;
                HeadStep step;
                step.goal = {towards.pan_rad + column * pan_step_rad,
                             towards.tilt_rad + row * tilt_step_rad};
                step.approach.pan = number % 2 == 0 ? pass : -pass;
                step.approach.tilt = number % 4 < 2 ? pass : -pass;
                step.from = {step.goal.pan_rad - step.approach.pan * run_up_rad,
                             step.goal.tilt_rad - step.approach.tilt * run_up_rad};
                if (reaches(step.goal, limits) && reaches(step.from, limits)) {
                    steps.push_back(step);
                }
                ++number;
            }
        }
    }
    return steps;
}

void HeadSequence::begin(std::vector<HeadStep> steps) {
    steps_ = std::move(steps);
    at_ = 0;
    phase_ = Phase::to_approach;
}

HeadSequence::Request HeadSequence::see(const HeadSnapshot& head, std::int64_t now_ms) {
    if (!going()) {
        return {};
    }
    const HeadStep& wanted = step();
    switch (phase_) {
        case Phase::to_approach:
            phase_ = Phase::approaching;
            since_ms_ = now_ms;
            return {Asks::move, wanted.from};
        case Phase::approaching:
            phase_ = is_at(head, wanted.from) ? Phase::to_arrive : Phase::approaching;
            break;
        case Phase::to_arrive:
            phase_ = Phase::arriving;
            since_ms_ = now_ms;
            return {Asks::move, wanted.goal};
        case Phase::arriving:
            if (is_at(head, wanted.goal)) {
                phase_ = Phase::settling;
                since_ms_ = now_ms;
                return {};
            }
            break;
        case Phase::settling:
            if (!is_at(head, wanted.goal)) {
                phase_ = Phase::arriving;
                return {};
            }
            if (now_ms - since_ms_ >= settle_ms) {
                phase_ = Phase::viewing;
                return {Asks::view, head.angles};
            }
            return {};
        case Phase::viewing:
            return {};
    }
    return now_ms - since_ms_ > patience_ms ? Request{Asks::give_up, head.angles} : Request{};
}

void HeadSequence::next() {
    ++at_;
    phase_ = Phase::to_approach;
}

}  // namespace kambara::ui
