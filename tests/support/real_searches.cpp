// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/real_searches.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/matching/matcher.h"
#include "core/matching/peak.h"
#include "core/matching/texture.h"
#include "tests/support/real_scenes.h"

namespace kambara::testing_support {
namespace {

constexpr int border_px = 4;  // what every transform's neighbourhood fits into
constexpr int radii_px[] = {12, 24, 48, 96};
constexpr double farthest_start = 1.1;  // radii from the truth, in x and in y
constexpr double right_within_px = 2.0;

bool well_inside(const Rectangle& r, const Image& picture) {
    return Rectangle{r.x - border_px, r.y - border_px, r.width + 2 * border_px,
                     r.height + 2 * border_px}
        .inside(picture.width(), picture.height());
}

}  // namespace

std::optional<Search> search_about(const ImagePtr& from, const Eigen::Vector2d& point_px,
                                   const ImagePtr& in, const Eigen::Vector2d& truth_px,
                                   Random& random) {
    const int half = 5 + random.below(16);
    const int side = 2 * half + 1;
    const int radius = radii_px[random.below(4)];
    const double reach = farthest_start * radius;
    const Eigen::Vector2d start_off{random.between(-reach, reach), random.between(-reach, reach)};
    const Eigen::Vector2i corner = point_px.array().round().cast<int>() - half;
    Search search;
    search.from = from;
    search.in = in;
    search.templ = {corner.x(), corner.y(), side, side};
    search.truth_px = corner.cast<double>() + truth_px - point_px;
    const Eigen::Vector2i whole = search.truth_px.array().round().cast<int>();
    const Eigen::Vector2i start = (search.truth_px + start_off).array().round().cast<int>();
    search.positions = {start.x() - radius, start.y() - radius, 2 * radius + 1, 2 * radius + 1};
    if (!well_inside(search.templ, *from) ||
        !well_inside({whole.x(), whole.y(), side, side}, *in) ||
        !check_template(*from, search.templ)) {
        return std::nullopt;
    }
    return search;
}

Result<std::vector<SearchSet>> real_searches(const std::filesystem::path& data, int per_half) {
    std::vector<SearchSet> sets;
    for (const auto& scene : real_scenes) {
        auto set = scene(data, per_half);
        if (!set) {
            return set.error();
        }
        sets.push_back(std::move(*set));
    }
    return sets;
}

std::vector<MatchSample> samples_of(const MatchMethod& method,
                                    const std::vector<Search>& searches) {
    Matcher matcher(method);
    ScoreMap map;
    std::vector<MatchSample> samples;
    for (const Search& search : searches) {
        const Rectangle& where = search.positions;
        const Eigen::Vector2d middle(where.centre_x_px(), where.centre_y_px());
        matcher.set_template(*search.from, search.templ);
        matcher.scores(*search.in, where, map);
        if (const auto peak = best_peak(map, method.measure, middle)) {
            const Eigen::Vector2d off = Eigen::Vector2d(peak->x, peak->y) - search.truth_px;
            samples.push_back({match_evidence(matcher, map, *peak), off.norm() <= right_within_px});
        }
    }
    return samples;
}

}  // namespace kambara::testing_support
