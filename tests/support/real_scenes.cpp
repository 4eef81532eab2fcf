// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/real_scenes.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "core/calibration/chessboard_detector.h"
#include "hardware/media/open_media.h"

namespace kambara::testing_support {
namespace {

namespace fs = std::filesystem;

std::vector<Search> tried(const Try& one_try, int first, int end, int wanted, Random& random) {
    std::vector<Search> searches;
    for (int i = 0; i < 200 * wanted && static_cast<int>(searches.size()) < wanted; ++i) {
        if (auto search = one_try(first, end, random)) {
            searches.push_back(std::move(*search));
        }
    }
    return searches;
}

// Two different frames, the earlier first.
std::pair<std::size_t, std::size_t> two_of(int first, int end, Random& random) {
    const int a = first + random.below(end - first);
    const int b = first + random.below(end - first - 1);
    const int other = b < a ? b : b + 1;
    return {static_cast<std::size_t>(std::min(a, other)),
            static_cast<std::size_t>(std::max(a, other))};
}

Eigen::Vector2d anywhere(const Image& picture, Random& random) {
    return {random.between(0.0, picture.width() - 1.0),
            random.between(0.0, picture.height() - 1.0)};
}

// What is seen most of the time, pixel by pixel.
Image median_picture(const std::vector<ImagePtr>& pictures) {
    Image median(pictures[0]->width(), pictures[0]->height());
    std::vector<std::uint8_t> values;
    for (int y = 0; y < median.height(); ++y) {
        for (int x = 0; x < median.width(); ++x) {
            values.clear();
            for (std::size_t i = 0; i < pictures.size(); i += 1 + pictures.size() / 40) {
                values.push_back(pictures[i]->at(x, y));
            }
            const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
            std::nth_element(values.begin(), middle, values.end());
            median.at(x, y) = *middle;
        }
    }
    return median;
}

// The share of a rectangle's pixels at which a picture differs from the one at rest.
double covered(const Image& picture, const Image& at_rest, const Rectangle& r) {
    int differing = 0;
    for (int y = r.y; y < r.y + r.height; ++y) {
        for (int x = r.x; x < r.x + r.width; ++x) {
            differing += std::abs(picture.at(x, y) - at_rest.at(x, y)) > 10 ? 1 : 0;
        }
    }
    return static_cast<double>(differing) / (r.width * r.height);
}

// Templates of what is at rest, looked for where it may have been covered since: every other search
// insists on that.
SearchSet searches_at_rest(std::string name, const std::vector<ImagePtr>& pictures, int per_half,
                           std::uint64_t seed) {
    const Image at_rest = median_picture(pictures);
    const Try one_try = [&](int first, int end, Random& random) -> std::optional<Search> {
        const auto [a, b] = two_of(first, end, random);
        const Eigen::Vector2d point = anywhere(at_rest, random);
        auto search = search_about(pictures[a], point, pictures[b], point, random);
        if (!search || covered(*pictures[a], at_rest, search->templ) > 0.03 ||
            (random.below(2) == 0 && covered(*pictures[b], at_rest, search->templ) < 0.3)) {
            return std::nullopt;
        }
        return search;
    };
    return both_halves(std::move(name), one_try, static_cast<int>(pictures.size()), per_half, seed);
}

Result<SearchSet> searches_on_a_desk(std::string name, const fs::path& video, int per_half) {
    constexpr int rests_from = 160;
    const auto pictures = grey_pictures(video.string(), rests_from);
    if (!pictures) {
        return pictures.error();
    }
    return searches_at_rest(std::move(name), *pictures, per_half, 1);
}

std::vector<std::vector<double>> numbers_of_csv(const fs::path& file) {
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    std::vector<std::vector<double>> rows;
    while (std::getline(stream, line)) {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream words(line);
        rows.emplace_back(std::istream_iterator<double>(words), std::istream_iterator<double>());
    }
    return rows;
}

}  // namespace

SearchSet both_halves(std::string name, const Try& one_try, int frames, int per_half,
                      std::uint64_t seed) {
    Random first_half(seed);
    Random second_half(seed + 100);
    SearchSet set;
    set.name = std::move(name);
    set.fit = tried(one_try, 0, frames / 2, per_half, first_half);
    set.held_out = tried(one_try, frames / 2, frames, per_half, second_half);
    return set;
}

Result<std::vector<ImagePtr>> grey_pictures(const std::string& source, int start) {
    MediaOptions options;
    options.start = start;
    auto grabber = open_media(source, options);
    if (!grabber) {
        return grabber.error();
    }
    std::vector<ImagePtr> pictures;
    for (;;) {
        auto frame = (*grabber)->grab({});
        if (!frame) {
            return frame.error();
        }
        if (!*frame) {
            return pictures;
        }
        pictures.push_back(grey_from((*frame)->picture));
    }
}

Result<SearchSet> searches_on_the_mat(const fs::path& data, int per_half) {
    return searches_on_a_desk("mat", data / "hand_stereo_video" / "cam0_test.mp4", per_half);
}

Result<SearchSet> searches_on_the_mat_from_aside(const fs::path& data, int per_half) {
    return searches_on_a_desk("mat from aside", data / "hand_stereo_video" / "cam1_test.mp4",
                              per_half);
}

Result<SearchSet> searches_on_the_wall(const fs::path& data, int per_half) {
    const auto pictures = grey_pictures((data / "moving_target" / "left" / "%06d.png").string());
    if (!pictures) {
        return pictures.error();
    }
    return searches_at_rest("wall", *pictures, per_half, 2);
}

Result<SearchSet> searches_for_the_target(const fs::path& data, int per_half) {
    const fs::path folder = data / "moving_target";
    const auto left = grey_pictures((folder / "left" / "%06d.png").string());
    const auto right = grey_pictures((folder / "right" / "%06d.png").string());
    if (!left || !right) {
        return left ? right.error() : left.error();
    }
    const auto truth = numbers_of_csv(folder / "truth.csv");
    const Try one_try = [&](int first, int end, Random& random) {
        const auto [a, b] = two_of(first, end, random);
        const int from = random.below(2);  // 0: left, 1: right
        const int in = from == 1 ? 1 : random.below(2);
        const auto seen_at = [&truth](std::size_t frame, int camera) {
            const std::size_t column = camera == 0 ? 5 : 7;
            return Eigen::Vector2d(truth[frame][column], truth[frame][column + 1]);
        };
        constexpr double off_px = 4.0;  // so near the point measured that all moves alike
        const Eigen::Vector2d off{random.between(-off_px, off_px), random.between(-off_px, off_px)};
        return search_about((from == 0 ? *left : *right)[a], seen_at(a, from) + off,
                            (in == 0 ? *left : *right)[b], seen_at(b, in) + off, random);
    };
    const auto frames = std::min({left->size(), right->size(), truth.size()});
    return both_halves("target", one_try, static_cast<int>(frames), per_half, 3);
}

static std::vector<Eigen::Vector2d> places_of(const DetectedCorners& corners) {
    std::vector<Eigen::Vector2d> places;
    for (const DetectedCorner& corner : corners) {
        places.push_back(corner.px);
    }
    return places;
}

Result<SearchSet> searches_on_the_chessboard(const fs::path& data, int per_half) {
    const fs::path folder = data / "stereo_chessboard";
    const auto left = grey_pictures((folder / "left*.jpg").string());
    const auto right = grey_pictures((folder / "right*.jpg").string());
    if (!left || !right) {
        return left ? right.error() : left.error();
    }
    std::vector<std::vector<Eigen::Vector2d>> left_px;
    std::vector<std::vector<Eigen::Vector2d>> right_px;
    for (std::size_t i = 0; i < std::min(left->size(), right->size()); ++i) {
        auto in_left = detect_chessboard(*(*left)[i], {});
        auto in_right = detect_chessboard(*(*right)[i], {});
        if (!in_left || !in_right) {
            return in_left ? in_right.error() : in_left.error();
        }
        left_px.push_back(places_of(*in_left));
        right_px.push_back(places_of(*in_right));
        auto& l = left_px.back();
        auto& r = right_px.back();
        if ((l.back() - l.front()).dot(r.back() - r.front()) < 0.0) {
            std::reverse(r.begin(), r.end());
        }
    }
    const Try one_try = [&](int first, int end, Random& random) {
        const auto i = static_cast<std::size_t>(first + random.below(end - first));
        const auto corner =
            static_cast<std::size_t>(random.below(static_cast<int>(left_px[i].size())));
        constexpr double off_px = 3.0;
        const Eigen::Vector2d off{random.between(-off_px, off_px), random.between(-off_px, off_px)};
        return search_about((*left)[i], left_px[i][corner] + off, (*right)[i],
                            right_px[i][corner] + off, random);
    };
    return both_halves("chessboard", one_try, static_cast<int>(left_px.size()), per_half, 4);
}

}  // namespace kambara::testing_support
