// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/matcher.h"

#include <algorithm>
#include <cmath>

namespace kambara {
namespace {

bool counts(const Image* mask, int x, int y) {
    return mask == nullptr || mask->at(x, y) != 0;
}

// Half the bits: what unrelated pictures differ by.
double unlike_bits(const Image& templ, const Image* mask, int step, bool binary) {
    double pixels = 0.0;
    for (int y = 0; y < templ.height(); y += step) {
        for (int x = 0; x < templ.width(); x += step) {
            pixels += counts(mask, x, y) ? 1.0 : 0.0;
        }
    }
    const double bits = binary ? 1.0 : 24.0;  // census has no neighbour at its own place
    return 0.5 * bits * pixels;
}

// The differences from a flat patch of the template's mean.
double unlike_levels(const Image& templ, const Image* mask, int step) {
    double total = 0.0;
    for (int channel = 0; channel < templ.channels(); ++channel) {
        double sum = 0.0;
        double pixels = 0.0;
        for (int pass = 0; pass < 2; ++pass) {
            const double mean = pass == 0 ? 0.0 : sum / std::max(pixels, 1.0);
            for (int y = 0; y < templ.height(); y += step) {
                for (int x = 0; x < templ.width(); x += step) {
                    if (counts(mask, x, y)) {
                        const double value = templ.at(x, y, channel);
                        sum += pass == 0 ? value : 0.0;
                        pixels += pass == 0 ? 1.0 : 0.0;
                        total += pass == 0 ? 0.0 : std::abs(value - mean);
                    }
                }
            }
        }
    }
    return total;
}

}  // namespace

Matcher::Matcher(const MatchMethod& method, const Kernels& kernels)
    : method_(method), rows_(&kernels.transforms), correlator_(kernels) {}

void Matcher::set_template(const Image& picture, const Rectangle& rectangle, const Image* mask) {
    transform_region(picture, rectangle, method_.transform, template_, *rows_);
    width_ = rectangle.width;
    height_ = rectangle.height;
    correlator_.set_template(method_.measure, template_, mask, method_.step);
    unlike_ = 1.0;
    if (method_.measure == Measure::hamming) {
        unlike_ = unlike_bits(template_, mask, method_.step, is_binary(method_.transform));
    } else if (method_.measure == Measure::sad) {
        unlike_ = unlike_levels(template_, mask, method_.step);
    }
}

void Matcher::scores(const Image& picture, const Rectangle& positions, ScoreMap& map,
                     TransformCache* cache) {
    if (method_.transform == Transform::none) {
        // Positions of the whole template, however few of its pixels count.
        const int right = std::min(positions.x + positions.width, picture.width() - width_ + 1);
        const int bottom = std::min(positions.y + positions.height, picture.height() - height_ + 1);
        correlator_.scores(
            picture, {positions.x, positions.y, right - positions.x, bottom - positions.y}, map);
        return;
    }
    const Rectangle all = transformable(picture, method_.transform);
    const int left = std::max(positions.x, all.x);
    const int top = std::max(positions.y, all.y);
    const int right = std::min(positions.x + positions.width, all.x + all.width - width_ + 1);
    const int bottom = std::min(positions.y + positions.height, all.y + all.height - height_ + 1);
    if (right <= left || bottom <= top) {
        map = {};
        return;
    }
    const Rectangle region{left, top, right - left + width_ - 1, bottom - top + height_ - 1};
    const Image* kept =
        cache != nullptr ? cache->transformed(picture, method_.transform, region) : nullptr;
    if (kept != nullptr) {
        correlator_.scores(*kept, {left, top, right - left, bottom - top}, map);
        return;
    }
    transform_region(picture, region, method_.transform, region_, *rows_);
    correlator_.scores(region_, {0, 0, right - left, bottom - top}, map);
    map.positions = {left, top, right - left, bottom - top};
}

double Matcher::quality(double score) const {
    if (!is_cost(method_.measure)) {
        return std::clamp(score, 0.0, 1.0);
    }
    return unlike_ > 0.0 ? std::clamp(1.0 - score / unlike_, 0.0, 1.0) : 0.0;
}

}  // namespace kambara
