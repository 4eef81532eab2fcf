// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_score.h"
#include "core/base/median.h"

#include <cmath>
#include <limits>

namespace kambara::cli {
namespace {

constexpr std::size_t least_voices = 3;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

// Number k of a sighting: left x, y, right x, y, range.
std::optional<double> number_of(const Sighting& sighting, int k) {
    if (k < 2) {
        return sighting.left_px[k];
    }
    if (k < 4) {
        return sighting.right_px ? std::optional((*sighting.right_px)[k - 2]) : std::nullopt;
    }
    return sighting.range_mm;
}

std::optional<Sighting> median_sighting(const std::vector<CompareRun>& runs, std::size_t frame) {
    std::optional<double> medians[5];
    for (int k = 0; k < 5; ++k) {
        std::vector<double> said;
        for (const CompareRun& run : runs) {
            const auto& sighting = run.seen[frame];
            if (const auto number = sighting ? number_of(*sighting, k) : std::nullopt) {
                said.push_back(*number);
            }
        }
        if (said.size() >= least_voices) {
            medians[k] = median(said);
        }
    }
    if (!medians[0]) {
        return std::nullopt;
    }
    Sighting sighting{{*medians[0], *medians[1]}, std::nullopt, medians[4]};
    if (medians[2]) {
        sighting.right_px = Eigen::Vector2d(*medians[2], *medians[3]);
    }
    return sighting;
}

bool near(const Sighting& a, const Sighting& b) {
    return (a.left_px - b.left_px).norm() <= on_target_within_px &&
           (!a.right_px || !b.right_px ||
            (*a.right_px - *b.right_px).norm() <= on_target_within_px);
}

struct Mean {
    double sum = 0.0;
    double count = 0.0;

    void add(double value) {
        sum += value;
        count += 1.0;
    }
    double value() const { return count > 0.0 ? sum / count : not_known; }
};

bool on_target_at(const SceneResult& result, std::size_t method, std::size_t frame) {
    const auto& seen = result.runs[method].seen[frame];
    const auto& truth = result.scene.truth[frame];
    return seen && truth && near(*seen, *truth);
}

void count(AttenuationBin& bin, bool on_target) {
    ++bin.frames;
    bin.on_target += on_target ? 1 : 0;
}

double share_of(double part, double whole) {
    return whole > 0.0 ? part / whole : 0.0;
}

}  // namespace

std::vector<std::optional<Sighting>> reference_of(const CompareScene& scene,
                                                  const std::vector<CompareRun>& runs) {
    if (scene.has_truth()) {
        return scene.truth;
    }
    std::vector<std::optional<Sighting>> reference;
    for (std::size_t i = 0; i < scene.truth.size(); ++i) {
        reference.push_back(median_sighting(runs, i));
    }
    return reference;
}

CompareScore score_of(const CompareScene& scene, const CompareRun& run,
                      const std::vector<std::optional<Sighting>>& reference) {
    const bool truth = scene.has_truth();
    double frames = 0.0;
    double kept = 0.0;
    double off = 0.0;
    double back = 0.0;
    double found = 0.0;
    Mean error_px;
    Mean range_error_pct;
    for (std::size_t i = 0; i < reference.size(); ++i) {
        if (truth && !reference[i]) {
            continue;
        }
        frames += 1.0;
        const auto& best_px = i < run.best_left_px.size() ? run.best_left_px[i] : std::nullopt;
        if (best_px && reference[i] &&
            (*best_px - reference[i]->left_px).norm() <= on_target_within_px) {
            found += 1.0;
        }
        const auto& seen = run.seen[i];
        if (!seen) {
            continue;
        }
        kept += 1.0;
        if (i < run.seen_back.size() && run.seen_back[i] && near(*seen, *run.seen_back[i])) {
            back += 1.0;
        }
        if (!reference[i]) {
            continue;
        }
        if (!near(*seen, *reference[i])) {
            off += 1.0;
            continue;
        }
        error_px.add((seen->left_px - reference[i]->left_px).norm());
        if (seen->range_mm && reference[i]->range_mm) {
            range_error_pct.add(100.0 * std::abs(*seen->range_mm / *reference[i]->range_mm - 1.0));
        }
    }
    CompareScore score;
    score.kept = share_of(kept, frames);
    score.on_target = share_of(error_px.count, frames);
    score.off_target = share_of(off, frames);
    score.found = share_of(found, frames);
    if (!truth) {
        score.there_and_back = share_of(back, frames);
    }
    score.error_px = error_px.value();
    score.range_error_pct = range_error_pct.value();
    return score;
}

double AttenuationBin::share() const {
    return frames > 0 ? static_cast<double>(on_target) / static_cast<double>(frames) : not_known;
}

std::vector<AttenuationBin> bins_of(const std::vector<SceneResult>& results, std::size_t method) {
    std::vector<AttenuationBin> bins;
    for (const SceneResult& result : results) {
        for (std::size_t i = 0; i < result.scene.attenuation_lengths.size(); ++i) {
            const double lengths = result.scene.attenuation_lengths[i];
            if (lengths <= 0.0) {
                continue;
            }
            const auto bin = static_cast<std::size_t>(lengths / attenuation_bin_lengths);
            while (bins.size() <= bin) {
                bins.push_back({static_cast<double>(bins.size()) * attenuation_bin_lengths, 0, 0});
            }
            count(bins[bin], on_target_at(result, method, i));
        }
    }
    return bins;
}

AttenuationBin disturbed_up_to(const std::vector<SceneResult>& results, std::size_t method,
                               double lengths) {
    AttenuationBin sum;
    for (const SceneResult& result : results) {
        const auto& of_frames = result.scene.attenuation_lengths;
        for (std::size_t i = 0; i < of_frames.size() && result.scene.disturbed; ++i) {
            if (of_frames[i] > 0.0 && of_frames[i] <= lengths) {
                count(sum, on_target_at(result, method, i));
            }
        }
    }
    return sum;
}

}  // namespace kambara::cli
