// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/edge_chain.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/image/opencv_view.h"

namespace kambara {
namespace {

// 0 where a pixel belongs to the dark side of an edge nearby, else 255.
cv::Mat all_but_dark_sides(const cv::Mat& picture, const EdgeChainOptions& options) {
    const int across = 2 * options.reach_px + 1;
    const cv::Mat window = cv::getStructuringElement(cv::MORPH_RECT, {across, across});
    cv::Mat darkest;
    cv::Mat lightest;
    cv::erode(picture, darkest, window);
    cv::dilate(picture, lightest, window);
    const int contrast = static_cast<int>(std::lround(options.least_contrast));
    cv::Mat rest(picture.size(), CV_8U);
    for (int y = 0; y < picture.rows; ++y) {
        const std::uint8_t* level = picture.ptr<std::uint8_t>(y);
        const std::uint8_t* low = darkest.ptr<std::uint8_t>(y);
        const std::uint8_t* high = lightest.ptr<std::uint8_t>(y);
        std::uint8_t* out = rest.ptr<std::uint8_t>(y);
        for (int x = 0; x < picture.cols; ++x) {
            const bool is_dark = (high[x] - low[x] >= contrast) & (2 * level[x] < low[x] + high[x]);
            out[x] = is_dark ? 0 : 255;
        }
    }
    return rest;
}

bool touches_frame(const std::vector<cv::Point>& chain, const cv::Size& size) {
    return std::any_of(chain.begin(), chain.end(), [&](const cv::Point& p) {
        return p.x <= 0 || p.y <= 0 || p.x >= size.width - 1 || p.y >= size.height - 1;
    });
}

}  // namespace

std::vector<EdgeChain> closed_edge_chains(const Image& grey, const EdgeChainOptions& options) {
    const cv::Mat picture = opencv_view(grey);
    std::vector<std::vector<cv::Point>> borders;
    std::vector<cv::Vec4i> order;
    // The dark regions are found as holes of the rest, and so hang together along sides of pixels
    // only: two boxes that nearly touch at a slant stay apart.
    cv::findContours(all_but_dark_sides(picture, options), borders, order, cv::RETR_CCOMP,
                     cv::CHAIN_APPROX_NONE);
    std::vector<EdgeChain> chains;
    for (std::size_t i = 0; i < borders.size(); ++i) {
        const bool is_hole = order[i][3] >= 0;
        if (!is_hole || static_cast<int>(borders[i].size()) < options.least_length ||
            touches_frame(borders[i], picture.size())) {
            continue;
        }
        EdgeChain chain;
        chain.reserve(borders[i].size());
        for (const cv::Point& p : borders[i]) {
            chain.emplace_back(p.x, p.y);
        }
        chains.push_back(std::move(chain));
    }
    return chains;
}

Eigen::Vector2d centroid_of(const EdgeChain& chain) {
    const Eigen::Vector2d first = chain.front().cast<double>();
    double area = 0.0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (std::size_t i = 0; i < chain.size(); ++i) {
        const Eigen::Vector2d a = chain[i].cast<double>() - first;
        const Eigen::Vector2d b = chain[(i + 1) % chain.size()].cast<double>() - first;
        const double cross = a.x() * b.y() - a.y() * b.x();
        area += cross;
        sum += cross * (a + b) / 3.0;
    }
    return std::abs(area) > 0.0 ? Eigen::Vector2d(first + sum / area) : first;
}

}  // namespace kambara
