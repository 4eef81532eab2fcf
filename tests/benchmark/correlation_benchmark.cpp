// SPDX-License-Identifier: GPL-3.0-or-later
// The correlation engine beside OpenCV's matchTemplate, single thread: medians of 11 interleaved
// repetitions. KAMBARA_KERNELS chooses a lesser vector unit.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/matching/correlator.h"

namespace kambara {
namespace {

constexpr int repetitions = 11;

double microseconds(const std::function<void()>& work, int times) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i) {
        work();
    }
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start)
               .count() /
           times;
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + repetitions / 2, values.end());
    return values[repetitions / 2];
}

// Both in turn, so that what else the machine does meets both.
void compare(const std::string& name, const std::function<void()>& ours,
             const std::function<void()>& theirs) {
    const auto often = [](const std::function<void()>& work) {
        return std::max(1, static_cast<int>(2000.0 / (microseconds(work, 1) + 1.0)));
    };
    ours();
    theirs();
    const int our_times = often(ours);
    const int their_times = often(theirs);
    std::vector<double> of_ours;
    std::vector<double> of_theirs;
    for (int i = 0; i < repetitions; ++i) {
        of_ours.push_back(microseconds(ours, our_times));
        of_theirs.push_back(microseconds(theirs, their_times));
    }
    const double a = median(of_ours);
    const double b = median(of_theirs);
    std::printf("%-44s %10.1f %10.1f %8.1f x\n", name.c_str(), a, b, b / a);
}

// Noise over a smooth pattern: the times do not depend on it, but the peaks are real ones.
Image textured(int width, int height, int channels) {
    std::mt19937 random(1);
    Image image(width, height, channels);
    for (int y = 0; y < height; ++y) {
        for (std::size_t i = 0; i < image.row_bytes(); ++i) {
            image.row(y)[i] = static_cast<std::uint8_t>(random() % 200 + 20);
        }
    }
    return image;
}

Image cut(const Image& image, int x, int y, int width, int height) {
    Image piece(width, height, image.channels());
    for (int v = 0; v < height; ++v) {
        std::copy_n(image.row(y + v) + x * image.channels(), piece.row_bytes(), piece.row(v));
    }
    return piece;
}

cv::Mat view_of(const Image& image) {
    return {image.height(), image.width(), image.channels() == 1 ? CV_8UC1 : CV_8UC3,
            const_cast<std::uint8_t*>(image.row(0))};
}

void full(Measure measure, int method, int width, int height, int w, int h, int channels) {
    const Image picture = textured(width, height, channels);
    const Image templ = cut(picture, width / 3, height / 3, w, h);
    Correlator correlator;
    correlator.set_template(measure, templ);
    ScoreMap map;
    cv::Mat result;
    const std::string name = to_string(measure) + (channels == 3 ? " colour " : " ") +
                             std::to_string(w) + " x " + std::to_string(h) + " in " +
                             std::to_string(width) + " x " + std::to_string(height);
    compare(
        name, [&] { correlator.scores(picture, {0, 0, width, height}, map); },
        [&] { cv::matchTemplate(view_of(picture), view_of(templ), result, method); });
}

}  // namespace
}  // namespace kambara

int main() {
    using namespace kambara;
    cv::setNumThreads(1);
    std::printf("Kernels: %s. Medians of %d, microseconds a search.\n", best_kernels().name.c_str(),
                repetitions);
    std::printf("%-44s %10s %10s %10s\n", "", "ours", "OpenCV", "ratio");
    full(Measure::ncc, cv::TM_CCORR_NORMED, 320, 240, 14, 18, 1);
    full(Measure::zncc, cv::TM_CCOEFF_NORMED, 320, 240, 14, 18, 1);
    full(Measure::sad, cv::TM_SQDIFF, 320, 240, 14, 18, 1);
    full(Measure::sad, cv::TM_SQDIFF, 320, 240, 14, 18, 3);
    for (const auto& [width, height] : {std::pair(320, 240), std::pair(640, 480),
                                        std::pair(1920, 1080)}) {
        for (const int size : {7, 31, 63, 127}) {
            full(Measure::ncc, cv::TM_CCORR_NORMED, width, height, size, size, 1);
            full(Measure::zncc, cv::TM_CCOEFF_NORMED, width, height, size, size, 1);
            full(Measure::sad, cv::TM_SQDIFF, width, height, size, size, 1);
        }
    }
    return 0;
}
