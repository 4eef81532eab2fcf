// SPDX-License-Identifier: GPL-3.0-or-later
// Follows the pedestrian of the folder `crossing` from nine starts, and beside it OpenCV's KCF and
// CSRT: overlap with the true boxes (intersection over union), share of the frames whose centre is
// within 20 px, time a frame. Usage: tracker_benchmark FOLDER
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <map>
#include <opencv2/core.hpp>
#include <opencv2/tracking.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/median.h"
#include "tests/support/box_sequence.h"

namespace {

using namespace kambara;
using namespace kambara::testing_support;

using Boxes = std::vector<std::optional<Box>>;

cv::Mat picture_of(const Image& image) {
    return {image.height(), image.width(), CV_8UC3, const_cast<std::uint8_t*>(image.row(0))};
}

Boxes by_opencv(const BoxSequence& sequence, const Box& first,
                const cv::Ptr<cv::Tracker>& tracker) {
    Boxes found(sequence.colour.size());
    tracker->init(picture_of(*sequence.colour[0]),
                  cv::Rect(static_cast<int>(first.x), static_cast<int>(first.y),
                           static_cast<int>(first.width), static_cast<int>(first.height)));
    for (std::size_t i = 1; i < found.size(); ++i) {
        cv::Rect box;
        if (tracker->update(picture_of(*sequence.colour[i]), box)) {
            found[i] = Box{static_cast<double>(box.x), static_cast<double>(box.y),
                           static_cast<double>(box.width), static_cast<double>(box.height)};
        }
    }
    return found;
}

struct Results {
    std::vector<double> overlap;
    std::vector<double> near;
    std::vector<double> ms;
};

void run(Results& results, const BoxSequence& sequence, const std::function<Boxes()>& follow) {
    const auto start = std::chrono::steady_clock::now();
    const Boxes found = follow();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    const BoxScore score = score_of(sequence, found);
    results.overlap.push_back(score.overlap);
    results.near.push_back(100.0 * score.near);
    results.ms.push_back(spent.count() / static_cast<double>(found.size()));
}

double worst_of(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr,
                     "usage: tracker_benchmark FOLDER, with img/ and groundtruth_rect.txt\n");
        return 2;
    }
    cv::setNumThreads(1);
    const BoxSequence sequence = read_box_sequence(argv[1]);
    if (sequence.truth.size() < 2) {
        std::fprintf(stderr, "There are no pictures with boxes in %s.\n", argv[1]);
        return 1;
    }
    std::map<std::string, Results> all;
    for (const Box& first : nine_starts(sequence)) {
        run(all["ours"], sequence, [&] { return followed(sequence, first); });
        cv::TrackerKCF::Params kcf;
        kcf.detect_thresh = 0.1F;  // with the usual one it loses the target at once
        run(all["KCF"], sequence,
            [&] { return by_opencv(sequence, first, cv::TrackerKCF::create(kcf)); });
        run(all["CSRT"], sequence,
            [&] { return by_opencv(sequence, first, cv::TrackerCSRT::create()); });
    }
    std::printf("Medians over nine starts (the worst):\n%-6s %18s %22s %10s\n", "", "overlap",
                "within 20 px", "ms");
    for (const auto& [name, of] : all) {
        std::printf("%-6s %10.3f (%.3f) %12.1f %% (%.1f) %10.2f\n", name.c_str(),
                    median(of.overlap), worst_of(of.overlap), median(of.near), worst_of(of.near),
                    median(of.ms));
    }
    return 0;
}
