// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_verdict.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace kambara::cli {
namespace {

std::string percent(double share) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f %%", 100.0 * share);
    return text;
}

std::string milliseconds(double ms) {
    char text[32];
    std::snprintf(text, sizeof text, "%.1f ms", ms);
    return std::isfinite(ms) ? text : "an unknown time";
}

std::string label_at(const std::vector<SceneResult>& results, std::size_t method) {
    return label_of(results.front().runs[method].method);
}

std::size_t best_in(const SceneResult& result) {
    std::size_t best = 0;
    for (std::size_t i = 1; i < result.runs.size(); ++i) {
        best = robustness(result, i) > robustness(result, best) ? i : best;
    }
    return best;
}

// The method of the least error among those that are as robust as the best one.
std::optional<std::size_t> nearest_in(const SceneResult& result) {
    const double most = robustness(result, best_in(result));
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < result.runs.size(); ++i) {
        const double error = result.scores[i].range_error_pct;
        if (robustness(result, i) >= most - equal_shares && std::isfinite(error) &&
            (!nearest || error < result.scores[*nearest].range_error_pct)) {
            nearest = i;
        }
    }
    return nearest;
}

std::string how_near(const SceneResult& result, std::size_t shipped) {
    const double error = result.scores[shipped].range_error_pct;
    const auto nearest = nearest_in(result);
    const bool robust =
        robustness(result, shipped) >= robustness(result, best_in(result)) - equal_shares;
    if (!result.scene.has_truth() || !robust || !std::isfinite(error) || !nearest) {
        return "";
    }
    char text[160];
    if (error <= result.scores[*nearest].range_error_pct) {
        std::snprintf(text, sizeof text,
                      " Its range error of %.4f %% is the least of the most robust.", error);
    } else {
        std::snprintf(text, sizeof text,
                      " Its range error is %.4f %%; of the most robust, %s has the least, %.4f %%.",
                      error, label_of(result.runs[*nearest].method).c_str(),
                      result.scores[*nearest].range_error_pct);
    }
    return text;
}

std::string sentence_on(const SceneResult& result, std::size_t shipped) {
    const std::string what =
        result.scene.has_truth() ? "on target in " : "followed there and back in ";
    const double own = robustness(result, shipped);
    const std::size_t best = best_in(result);
    const std::string name = result.scene.name + ": ";
    if (robustness(result, best) <= 0.0) {
        return name + "no method follows the target.";
    }
    std::string text;
    if (own >= robustness(result, best) - equal_shares) {
        text = name + "the default is " + what + percent(own) + " of the frames; none is in more.";
    } else {
        text = name + "the default is not the best here: " + what + percent(own) +
               " of the frames, " + label_of(result.runs[best].method) + " in " +
               percent(robustness(result, best)) + ".";
    }
    if (result.scene.has_truth() && result.scores[shipped].off_target > 0.0) {
        text += " In " + percent(result.scores[shipped].off_target) +
                " it is off target without saying so.";
    }
    return text + how_near(result, shipped);
}

std::string rank_word(std::size_t rank) {
    return rank == 0 ? "the first" : "number " + std::to_string(rank + 1);
}

std::string over_all(const std::vector<SceneResult>& results, std::size_t shipped) {
    const auto order = standings(results);
    const auto place = std::find_if(order.begin(), order.end(), [&](const Standing& standing) {
        return standing.method == shipped;
    });
    const auto rank = static_cast<std::size_t>(place - order.begin());
    const bool one = results.size() == 1;
    std::string text = "The default is " + label_at(results, shipped) + ". ";
    text += one ? "Here it keeps the target in "
                : "Over the " + std::to_string(results.size()) +
                      " scenes it keeps the target in a mean of ";
    text += percent(place->robustness) + " of the frames";
    text += one ? "" : ", " + percent(place->worst) + " at worst";
    text += ", and takes " + milliseconds(place->ms) + ": " + rank_word(rank) + " of " +
            std::to_string(order.size()) + " methods.";
    const Standing& first = order.front();
    if (first.robustness <= 0.0) {
        return "No method follows the target: nothing can be said of which is best.";
    }
    if (rank == 0) {
        return text + " That speaks for it.";
    }
    const std::string other = label_at(results, first.method);
    if (first.robustness <= place->robustness + equal_shares) {
        return text + " None is more robust by half a per cent; of those equal to it, first is " +
               other + " with " + milliseconds(first.ms) + ".";
    }
    text += " First is " + other + " with " + percent(first.robustness);
    text += one ? "" : " (" + percent(first.worst) + " at worst)";
    return text + " in " + milliseconds(first.ms) +
           ". By this run alone, that would be the better default.";
}

std::string on_attenuation(const std::vector<SceneResult>& results, std::size_t shipped) {
    const auto own = disturbed_up_to(results, shipped, asked_up_to_lengths);
    if (own.frames == 0) {
        return "";
    }
    char lengths[16];
    std::snprintf(lengths, sizeof lengths, "%.0f", asked_up_to_lengths);
    std::string text = "Up to " + std::string(lengths) +
                       " attenuation lengths, with particles, steps of light and the background "
                       "swapped (" +
                       std::to_string(own.frames) + " frames), the default is on target in " +
                       percent(own.share()) + " of the frames; " + percent(asked_share) +
                       " are asked for" + (own.share() >= asked_share ? "." : ", and missed.");
    std::string beside;
    for (const MatchMethod method : {MatchMethod{Measure::sad, Transform::none, 1},
                                     MatchMethod{Measure::ncc, Transform::none, 1},
                                     MatchMethod{Measure::zncc, Transform::none, 1}}) {
        const auto index = index_of(results, method);
        if (index && *index != shipped) {
            const auto other = disturbed_up_to(results, *index, asked_up_to_lengths);
            beside +=
                (beside.empty() ? "" : ", ") + label_of(method) + " in " + percent(other.share());
        }
    }
    return text + (beside.empty() ? "" : " Beside it: " + beside + ".");
}

}  // namespace

double robustness(const SceneResult& result, std::size_t method) {
    const CompareScore& score = result.scores[method];
    return score.there_and_back.value_or(score.on_target);
}

std::vector<Standing> standings(const std::vector<SceneResult>& results) {
    std::vector<Standing> order;
    const auto scenes = static_cast<double>(results.size());
    for (std::size_t i = 0; !results.empty() && i < results.front().runs.size(); ++i) {
        Standing standing;
        standing.method = i;
        standing.worst = 1.0;
        double timed = 0.0;
        double with_truth = 0.0;
        for (const SceneResult& result : results) {
            const double share = robustness(result, i);
            standing.robustness += share / scenes;
            standing.worst = std::min(standing.worst, share);
            if (result.scene.has_truth()) {
                standing.off_target += result.scores[i].off_target;
                with_truth += 1.0;
            }
            if (std::isfinite(result.runs[i].ms_median)) {
                standing.ms += result.runs[i].ms_median;
                timed += 1.0;
            }
        }
        standing.off_target = with_truth > 0.0 ? standing.off_target / with_truth
                                               : std::numeric_limits<double>::quiet_NaN();
        standing.ms = timed > 0.0 ? standing.ms / timed : std::numeric_limits<double>::quiet_NaN();
        order.push_back(standing);
    }
    std::stable_sort(order.begin(), order.end(), [](const Standing& a, const Standing& b) {
        return a.robustness > b.robustness;
    });
    // Those equal to the best of what is left, by what else counts.
    for (auto from = order.begin(); from != order.end();) {
        const auto to = std::find_if(from, order.end(), [&](const Standing& standing) {
            return standing.robustness < from->robustness - equal_shares;
        });
        std::stable_sort(from, to, [](const Standing& a, const Standing& b) {
            const auto off_a =
                std::isfinite(a.off_target) ? std::llround(a.off_target / equal_shares) : 0;
            const auto off_b =
                std::isfinite(b.off_target) ? std::llround(b.off_target / equal_shares) : 0;
            if (off_a != off_b) {
                return off_a < off_b;
            }
            return std::isfinite(a.ms) && (!std::isfinite(b.ms) || a.ms < b.ms);
        });
        from = to;
    }
    return order;
}

std::optional<std::size_t> index_of(const std::vector<SceneResult>& results,
                                    const MatchMethod& method) {
    for (std::size_t i = 0; !results.empty() && i < results.front().runs.size(); ++i) {
        if (results.front().runs[i].method == method) {
            return i;
        }
    }
    return std::nullopt;
}

std::vector<std::string> verdict_on(const std::vector<SceneResult>& results,
                                    const MatchMethod& shipped) {
    const auto index = index_of(results, shipped);
    if (!index) {
        return {};
    }
    std::vector<std::string> sentences{over_all(results, *index)};
    for (const SceneResult& result : results) {
        sentences.push_back(sentence_on(result, *index));
    }
    if (auto text = on_attenuation(results, *index); !text.empty()) {
        sentences.push_back(std::move(text));
    }
    return sentences;
}

}  // namespace kambara::cli
