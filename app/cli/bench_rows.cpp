// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/bench_rows.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <utility>

#include "core/matching/matcher.h"
#include "core/matching/peak.h"

namespace kambara::cli {
namespace {

constexpr int window_px = 41;       // positions across and down
constexpr int band_rows = 5;        // of the epipolar search
constexpr int band_rows_1999 = 61;  // what 1999's time for it amounts to
constexpr int sparse_step = 2;

// A picture with texture at all scales, and a template cut from it.
struct Scene {
    Image picture;
    Image templ;
    Rectangle place;
    cv::Mat picture_mat;
    cv::Mat template_mat;
    cv::Mat result;

    Scene(int width, int height, int channels, int template_width, int template_height) {
        std::mt19937 random(1);
        picture = Image(width, height, channels);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                for (int c = 0; c < channels; ++c) {
                    const int coarse = (x / 9 * 37 + y / 7 * 51 + c * 20) % 120;
                    picture.at(x, y, c) =
                        static_cast<std::uint8_t>(20 + coarse + static_cast<int>(random() % 100));
                }
            }
        }
        place = {width / 3, height / 3, template_width, template_height};
        const int kind = channels == 1 ? CV_8UC1 : CV_8UC3;
        picture_mat = cv::Mat(height, width, kind, picture.row(0));
        template_mat = picture_mat(cv::Rect(place.x, place.y, place.width, place.height)).clone();
        templ = Image(template_width, template_height, channels);
        for (int y = 0; y < template_height; ++y) {
            std::copy_n(template_mat.ptr(y), templ.row_bytes(), templ.row(y));
        }
    }
};

// Our side of a search: a matcher that knows its template, and a map that is used again.
struct Search {
    Matcher matcher;
    ScoreMap map;
    Rectangle positions;

    Search(const Scene& scene, const MatchMethod& method, const Rectangle& where)
        : matcher(method), positions(where) {
        matcher.set_template(scene.picture, scene.place);
    }
    void run(const Image& picture) {
        matcher.scores(picture, positions, map);
        const auto peak = best_peak(map, matcher.method().measure);
        sink = peak ? peak->x : 0.0;
    }
    volatile double sink = 0.0;
};

int method_of(Measure measure) {
    switch (measure) {
        case Measure::ncc:
            return cv::TM_CCORR_NORMED;
        case Measure::zncc:
            return cv::TM_CCOEFF_NORMED;
        default:
            return cv::TM_SQDIFF;
    }
}

void match_with_opencv(Scene& scene, const cv::Mat& picture, const cv::Mat& templ, int method) {
    cv::matchTemplate(picture, templ, scene.result, method);
    double least = 0.0;
    double most = 0.0;
    cv::Point at_least;
    cv::Point at_most;
    cv::minMaxLoc(scene.result, &least, &most, &at_least, &at_most);
}

BenchRow search_row(std::string name, int width, int height, int channels, int w, int h,
                    const MatchMethod& method, const Rectangle& positions) {
    auto scene = std::make_shared<Scene>(width, height, channels, w, h);
    auto search = std::make_shared<Search>(*scene, method, positions);
    BenchRow row;
    row.name = std::move(name);
    row.width_px = width;
    row.height_px = height;
    row.template_width_px = w;
    row.template_height_px = h;
    row.ours = [scene, search] { search->run(scene->picture); };
    const Rectangle all{0, 0, width - w + 1, height - h + 1};
    const int x1 = std::min(positions.x + positions.width, all.width);
    const int y1 = std::min(positions.y + positions.height, all.height);
    const cv::Rect part(positions.x, positions.y, x1 - positions.x + w - 1,
                        y1 - positions.y + h - 1);
    const int by = method_of(method.measure);
    row.opencv = [scene, part, by] {
        match_with_opencv(*scene, scene->picture_mat(part), scene->template_mat, by);
    };
    return row;
}

BenchRow full_row(const std::string& name, int width, int height, int channels, int w, int h,
                  const MatchMethod& method) {
    return search_row(name, width, height, channels, w, h, method, {0, 0, width, height});
}

// The rank transform by OpenCV's calls: a comparison and a sum for each neighbour.
void rank_with_opencv(const cv::Mat& grey, cv::Mat& rank, cv::Mat& darker) {
    const cv::Mat centre = grey(cv::Rect(1, 1, grey.cols - 2, grey.rows - 2));
    rank.create(centre.size(), CV_8UC1);
    rank.setTo(0);
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 3; ++x) {
            if (x != 1 || y != 1) {
                cv::compare(grey(cv::Rect(x, y, centre.cols, centre.rows)), centre, darker,
                            cv::CMP_LT);
                cv::subtract(rank, darker, rank, cv::noArray(), CV_8UC1);
                cv::bitwise_and(darker, 1, darker);
                cv::add(rank, darker, rank);
            }
        }
    }
}

BenchRow rank_row() {
    BenchRow row = full_row("Rank 3 x 3 + NORC, grey", 320, 240, 1, 14, 18,
                            {Measure::ncc, Transform::rank3, 1});
    auto scene = std::make_shared<Scene>(320, 240, 1, 14, 18);
    auto darker = std::make_shared<cv::Mat>();
    auto rank = std::make_shared<cv::Mat>();
    auto templ = std::make_shared<cv::Mat>();
    cv::Mat of_template;
    const cv::Mat around = scene->picture_mat(cv::Rect(
        scene->place.x - 1, scene->place.y - 1, scene->place.width + 2, scene->place.height + 2));
    rank_with_opencv(around, *templ, of_template);
    row.opencv = [scene, darker, rank, templ] {
        rank_with_opencv(scene->picture_mat, *rank, *darker);
        match_with_opencv(*scene, *rank, *templ, cv::TM_CCORR_NORMED);
    };
    row.bar_avx512 = 18.0;
    row.bar_avx2 = 5.0;
    return row;
}

void signs_with_opencv(const cv::Mat& grey, cv::Mat& less, cv::Mat& more, cv::Mat& signs) {
    cv::GaussianBlur(grey, less, cv::Size(5, 5), 0.8);
    cv::GaussianBlur(grey, more, cv::Size(9, 9), 1.6);
    cv::compare(less, more, signs, cv::CMP_GT);
}

BenchRow signs_row(const std::string& name, Measure measure, int w, int h) {
    BenchRow row = full_row(name, 320, 240, 1, w, h, {measure, Transform::sdog, 1});
    auto scene = std::make_shared<Scene>(320, 240, 1, w, h);
    struct Work {
        cv::Mat less, more, signs, templ;
    };
    auto work = std::make_shared<Work>();
    signs_with_opencv(scene->picture_mat, work->less, work->more, work->signs);
    work->templ = work->signs(cv::Rect(scene->place.x, scene->place.y, scene->place.width,
                                       scene->place.height))
                      .clone();
    row.opencv = [scene, work] {
        signs_with_opencv(scene->picture_mat, work->less, work->more, work->signs);
        match_with_opencv(*scene, work->signs, work->templ, cv::TM_CCORR);
    };
    return row;
}

// A window in the left picture, then a band of rows in the right one.
BenchRow stereo_row(const std::string& name, int width, int height, int channels, int w, int h,
                    Measure measure) {
    auto scene = std::make_shared<Scene>(width, height, channels, w, h);
    const Rectangle window{scene->place.x - window_px / 2, scene->place.y - window_px / 2,
                           window_px, window_px};
    const Rectangle band{0, scene->place.y - band_rows / 2, width - w + 1, band_rows};
    const MatchMethod method{measure, Transform::none, 1};
    auto left = std::make_shared<Search>(*scene, method, window);
    auto right = std::make_shared<Search>(*scene, method, band);
    BenchRow row;
    row.name = name;
    row.width_px = width;
    row.height_px = height;
    row.template_width_px = w;
    row.template_height_px = h;
    row.ours = [scene, left, right] {
        left->run(scene->picture);
        right->run(scene->picture);
    };
    const int by = method_of(measure);
    const auto part = [&](const Rectangle& r) {
        return cv::Rect(r.x, r.y, r.width + w - 1, r.height + h - 1);
    };
    row.opencv = [scene, by, a = part(window), b = part(band)] {
        match_with_opencv(*scene, scene->picture_mat(a), scene->template_mat, by);
        match_with_opencv(*scene, scene->picture_mat(b), scene->template_mat, by);
    };
    return row;
}

BenchRow with(BenchRow row, std::optional<double> hz_1999, std::optional<double> avx512,
              std::optional<double> avx2) {
    row.rate_1999_hz = hz_1999;
    row.bar_avx512 = avx512;
    row.bar_avx2 = avx2;
    return row;
}

std::string upper(Measure measure) {
    return measure == Measure::ncc ? "NCC" : (measure == Measure::zncc ? "ZNCC" : "SAD");
}

void add_rows_of_1999(std::vector<BenchRow>& rows) {
    const MatchMethod sad{Measure::sad, Transform::none, 1};
    const MatchMethod sparse{Measure::sad, Transform::none, sparse_step};
    const Rectangle window{106 - window_px / 2, 80 - window_px / 2, window_px, window_px};
    const Rectangle band{0, 80 - band_rows_1999 / 2, 320, band_rows_1999};
    rows.push_back(with(full_row("SOAD, colour", 320, 240, 3, 14, 18, sad), 0.14, 24.0, 12.0));
    rows.push_back(with(search_row("SOAD window, colour", 320, 240, 3, 14, 18, sad, window), 9.09,
                        std::nullopt, std::nullopt));
    rows.push_back(
        with(search_row("SOAD window sparse, colour", 320, 240, 3, 14, 18, sparse, window), 20.0,
             std::nullopt, std::nullopt));
    rows.push_back(with(search_row("SOAD epipole, colour", 320, 240, 3, 14, 18, sad, band), 0.52,
                        std::nullopt, std::nullopt));
    rows.push_back(
        with(search_row("SOAD epipole sparse, colour", 320, 240, 3, 14, 18, sparse, band), 5.88,
             std::nullopt, std::nullopt));
    rows.push_back(
        with(full_row("NORC, grey", 320, 240, 1, 14, 18, {Measure::ncc}), 0.22, 18.0, 6.0));
    rows.push_back(with(signs_row("SDoG + NORC, grey", Measure::ncc, 14, 18), 0.16, std::nullopt,
                        std::nullopt));
    BenchRow rank = rank_row();
    rank.rate_1999_hz = 0.20;
    rows.push_back(std::move(rank));
    for (BenchRow& row : rows) {
        row.most_us = 1000.0;  // 1000 Hz
    }
}

// Any measure with any template should not be slower than OpenCV's.
void add_any_template(std::vector<BenchRow>& rows) {
    for (const int size : {9, 12, 17, 23, 45, 60, 91}) {
        for (const Measure measure : {Measure::ncc, Measure::zncc, Measure::sad}) {
            const bool small = measure != Measure::sad || size <= 60;
            rows.push_back(
                with(full_row(upper(measure) + ", grey", 320, 240, 1, size, size, {measure}),
                     std::nullopt, 1.0, small ? std::optional(1.0) : std::nullopt));
        }
    }
    for (const int size : {7, 31, 60, 127}) {
        for (const Measure measure : {Measure::ncc, Measure::zncc, Measure::sad}) {
            const bool small = measure != Measure::sad || size <= 60;
            rows.push_back(
                with(full_row(upper(measure) + ", colour", 320, 240, 3, size, size, {measure}),
                     std::nullopt, small ? std::optional(1.0) : std::nullopt,
                     small ? std::optional(1.0) : std::nullopt));
        }
        rows.push_back(with(signs_row("SDoG + Hamming, grey", Measure::hamming, size, size),
                            std::nullopt, 1.0, 1.0));
    }
}

}  // namespace

std::vector<BenchRow> bench_rows() {
    std::vector<BenchRow> rows;
    add_rows_of_1999(rows);
    rows.push_back(with(full_row("ZNCC, grey", 320, 240, 1, 14, 18, {Measure::zncc}), std::nullopt,
                        15.0, 5.0));
    rows.push_back(
        with(full_row("SAD, grey", 320, 240, 1, 14, 18, {Measure::sad}), std::nullopt, 24.0, 12.0));
    rows.push_back(
        with(signs_row("SDoG + Hamming, grey", Measure::hamming, 14, 18), std::nullopt, 30.0, 8.0));
    rows.push_back(with(stereo_row("stereo step, SAD, colour", 320, 240, 3, 14, 18, Measure::sad),
                        std::nullopt, 24.0, 14.0));
    rows.push_back(with(stereo_row("stereo step, ZNCC, grey", 320, 240, 1, 14, 18, Measure::zncc),
                        std::nullopt, 12.0, 5.5));
    for (const Measure measure : {Measure::sad, Measure::zncc}) {
        rows.push_back(stereo_row("stereo step, " + upper(measure) + ", colour", 1920, 1080, 3, 31,
                                  31, measure));
        rows.back().most_us = 1000.0;
    }
    for (const auto& [width, height] :
         {std::pair(320, 240), std::pair(640, 480), std::pair(1920, 1080)}) {
        for (const int size : {7, 31, 63, 127}) {
            const std::optional<double> avx512 = size == 31 ? 6.0 : (size > 31 ? 2.5 : 1.0);
            const double avx2 = size >= 31 ? 2.0 : 1.0;
            for (const Measure measure : {Measure::ncc, Measure::zncc}) {
                rows.push_back(with(
                    full_row(upper(measure) + ", grey", width, height, 1, size, size, {measure}),
                    std::nullopt, avx512, avx2));
            }
            const bool large = size > 100;
            rows.push_back(with(full_row("SAD, grey", width, height, 1, size, size, {Measure::sad}),
                                std::nullopt, large ? std::nullopt : std::optional(1.0),
                                size > 60 ? std::nullopt : std::optional(1.0)));
        }
    }
    add_any_template(rows);
    return rows;
}

}  // namespace kambara::cli
