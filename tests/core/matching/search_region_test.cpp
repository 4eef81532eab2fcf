// SPDX-License-Identifier: GPL-3.0-or-later
// Every region with every measure and transform gives the scores of the full search, where it looks
// and nowhere else.
#include "core/matching/search_region.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

#include "core/matching/peak.h"

namespace kambara {
namespace {

Image textured(std::mt19937& random, int width, int height, int channels = 1) {
    Image image(width, height, channels);
    for (int y = 0; y < height; ++y) {
        for (std::size_t i = 0; i < image.row_bytes(); ++i) {
            image.row(y)[i] = static_cast<std::uint8_t>(random() % 256);
        }
    }
    return image;
}

std::vector<MatchMethod> methods() {
    std::vector<MatchMethod> all;
    for (const char* measure : {"sad", "ncc", "zncc", "hamming"}) {
        for (const char* transform :
             {"none", "gauss", "rank3", "rank5", "sdog", "census", "gradient"}) {
            if (auto method = parse_method(measure, transform)) {
                all.push_back(*method);
                method->step = 2;
                all.push_back(*method);
            }
        }
    }
    return all;
}

bool holds(const SearchRegion& region, int x, int y) {
    for (const Rectangle& r : region.positions) {
        if (x >= r.x && y >= r.y && x < r.x + r.width && y < r.y + r.height) {
            return true;
        }
    }
    return false;
}

TEST(SearchRegion, EveryMethodScoresItAsTheFullSearchDoes) {
    std::mt19937 random(1);
    const Image picture = textured(random, 90, 70);
    const Rectangle place{31, 22, 14, 13};
    // A slanting band, a window, one beyond the border, and one that lies wholly outside.
    const SearchRegion band{{{10, 12, 20, 5}, {30, 13, 1, 6}, {31, 20, 40, 5}, {-9, 60, 15, 40}}};
    const SearchRegion window = window_region({37.0, 28.0}, 9, place.width, place.height);
    const SearchRegion outside{{{200, 12, 20, 5}, {-90, 3, 40, 6}}};
    for (const MatchMethod& method : methods()) {
        SCOPED_TRACE(to_string(method.measure) + " " + to_string(method.transform));
        Matcher matcher(method);
        matcher.set_template(picture, place);
        ScoreMap full;
        scores_within(matcher, picture, full_region(picture), full);
        for (const SearchRegion& region : {band, window, outside}) {
            ScoreMap map;
            scores_within(matcher, picture, region, map);
            const Rectangle& r = full.positions;
            int searched = 0;
            for (int y = r.y; y < r.y + r.height; ++y) {
                for (int x = r.x; x < r.x + r.width; ++x) {
                    const Rectangle& m = map.positions;
                    const bool in_map = x >= m.x && y >= m.y && x < m.x + m.width &&
                                        y < m.y + m.height && map.searched(x, y);
                    ASSERT_EQ(in_map, holds(region, x, y)) << x << ", " << y;
                    if (in_map) {
                        ++searched;
                        ASSERT_EQ(map.at(x, y), full.at(x, y));
                    }
                }
            }
            EXPECT_EQ(best_peak(map, method.measure).has_value(), searched > 0);
            if (holds(region, place.x, place.y)) {
                const auto peak = best_peak(map, method.measure);
                EXPECT_EQ(peak->whole_x, place.x);
                EXPECT_EQ(peak->whole_y, place.y);
                EXPECT_NEAR(matcher.quality(peak->score), 1.0, 1e-6);
            }
        }
    }
}

TEST(SearchRegion, AWindowIsAboutTheTemplatesCentre) {
    EXPECT_EQ(window_region({50.0, 40.0}, 3, 9, 5).positions.front(), (Rectangle{43, 35, 7, 7}));
    EXPECT_EQ(top_left_for({50.5, 40.5}, 10, 4), Eigen::Vector2i(46, 39));
    EXPECT_EQ((SearchRegion{{{3, 4, 5, 6}, {1, 8, 2, 10}}}).bounds(), (Rectangle{1, 4, 7, 14}));
}

TEST(Peak, OfEqualOnesTakesTheNearestThenTheUpperThenTheLeft) {
    std::mt19937 random(2);
    Image picture = textured(random, 100, 60);
    // The same piece at four places.
    for (const auto& [x, y] : {std::pair(70, 8), std::pair(10, 40), std::pair(70, 40)}) {
        for (int v = 0; v < 9; ++v) {
            std::copy_n(picture.row(8 + v) + 10, 9, picture.row(y + v) + x);
        }
    }
    Matcher matcher({Measure::sad, Transform::none, 1});
    matcher.set_template(picture, {10, 8, 9, 9});
    ScoreMap map;
    scores_within(matcher, picture, full_region(picture), map);
    const auto place = [&](std::optional<Eigen::Vector2d> expected) {
        const auto peak = best_peak(map, Measure::sad, expected);
        return Eigen::Vector2i(peak->whole_x, peak->whole_y);
    };
    EXPECT_EQ(place(std::nullopt), Eigen::Vector2i(10, 8));
    EXPECT_EQ(place(Eigen::Vector2d(66, 39)), Eigen::Vector2i(70, 40));
    EXPECT_EQ(place(Eigen::Vector2d(40, 24)), Eigen::Vector2i(10, 8));     // as near as all others
    EXPECT_EQ(place(Eigen::Vector2d(40, 24.5)), Eigen::Vector2i(10, 40));  // the row decides first
    EXPECT_EQ(place(Eigen::Vector2d(41, 24)), Eigen::Vector2i(70, 8));
    EXPECT_EQ(second_peak(map, Measure::sad, *best_peak(map, Measure::sad), 4), 0.0);
}

TEST(Peak, TheSlopeOfThePeakIsNoSecondPeak) {
    // A broad hill, and a low one far away.
    ScoreMap map;
    map.positions = {5, 7, 60, 40};
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 60; ++x) {
            const double first = 1.0 - 0.02 * std::hypot(x - 15, y - 15);
            const double second = 0.5 - 0.05 * std::hypot(x - 48, y - 30);
            map.scores.push_back(static_cast<float>(std::max(first, second)));
        }
    }
    const auto peak = best_peak(map, Measure::zncc);
    ASSERT_EQ(peak->whole_x, 20);
    EXPECT_GT(*runner_up(map, Measure::zncc, *peak, 4), 0.85);
    EXPECT_NEAR(*second_peak(map, Measure::zncc, *peak, 4), 0.5, 1e-6);
    map.positions = {0, 0, 3, 1};
    map.scores = {0.1F, 0.9F, 0.2F};
    EXPECT_FALSE(second_peak(map, Measure::zncc, *best_peak(map, Measure::zncc), 4));
}

}  // namespace
}  // namespace kambara
