// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/coverage.h"

#include <algorithm>
#include <cmath>

namespace kambara::testing_support {

CoverageCanvas::CoverageCanvas(int width, int height, double level)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width * height), level),
      steps_(static_cast<std::size_t>((width + 2) * height), 0.0) {}

// A piece of a side within one row of pixels: what lies to its right is covered by dy, what it
// crosses by the share that lies to its right.
void CoverageCanvas::add_in_row(int y, double x0, double x1, double dy) {
    double* row = steps_.data() + static_cast<std::size_t>(y * (width_ + 2));
    x0 = std::clamp(x0, 0.0, static_cast<double>(width_));
    x1 = std::clamp(x1, 0.0, static_cast<double>(width_));
    if (x0 > x1) {
        std::swap(x0, x1);
    }
    const int first = static_cast<int>(x0);
    const int last = static_cast<int>(x1);
    for (int x = first; x <= last; ++x) {
        const double left = std::max<double>(x0, x);
        const double right = std::min<double>(x1, x + 1);
        const double part = x1 > x0 ? dy * (right - left) / (x1 - x0) : dy;
        const double covered = x + 1 - 0.5 * (left + right);
        row[x] += part * covered;
        row[x + 1] += part * (1.0 - covered);
    }
}

void CoverageCanvas::add_side(Eigen::Vector2d a, Eigen::Vector2d b) {
    double sign = 1.0;
    if (a.y() > b.y()) {
        std::swap(a, b);
        sign = -1.0;
    }
    const double slope = b.y() > a.y() ? (b.x() - a.x()) / (b.y() - a.y()) : 0.0;
    const int first = std::max(0, static_cast<int>(std::floor(a.y())));
    const int last = std::min(height_ - 1, static_cast<int>(std::floor(b.y())));
    for (int y = first; y <= last; ++y) {
        const double top = std::max<double>(a.y(), y);
        const double bottom = std::min<double>(b.y(), y + 1);
        if (bottom > top) {
            add_in_row(y, a.x() + slope * (top - a.y()), a.x() + slope * (bottom - a.y()),
                       sign * (bottom - top));
        }
    }
}

void CoverageCanvas::paint(const std::vector<Piece>& pieces) {
    std::vector<double> sum(pixels_.size(), 0.0);
    std::vector<double> weighed(pixels_.size(), 0.0);
    const Eigen::Vector2d half(0.5, 0.5);
    for (const Piece& piece : pieces) {
        double low = height_;
        double high = 0.0;
        double area = 0.0;
        for (std::size_t i = 0; i < piece.outline.size(); ++i) {
            const Eigen::Vector2d a = piece.outline[i] + half;
            const Eigen::Vector2d b = piece.outline[(i + 1) % piece.outline.size()] + half;
            add_side(a, b);
            area += a.x() * b.y() - a.y() * b.x();
            low = std::min(low, a.y());
            high = std::max(high, a.y());
        }
        // Clockwise on the screen, the left sides run upwards.
        const double sign = area > 0.0 ? -1.0 : 1.0;
        for (int y = std::max(0, static_cast<int>(low) - 1);
             y < std::min(height_, static_cast<int>(high) + 2); ++y) {
            double* steps = steps_.data() + static_cast<std::size_t>(y * (width_ + 2));
            double covered = 0.0;
            for (int x = 0; x < width_; ++x) {
                covered += steps[x];
                const auto i = static_cast<std::size_t>(y * width_ + x);
                sum[i] += sign * covered;
                weighed[i] += sign * covered * piece.level;
            }
            std::fill(steps, steps + width_ + 2, 0.0);
        }
    }
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
        pixels_[i] = (1.0 - sum[i]) * pixels_[i] + weighed[i];
    }
}

void CoverageCanvas::blur(double sigma_px) {
    const int reach = static_cast<int>(std::ceil(4.0 * sigma_px));
    std::vector<double> kernel;
    double total = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        kernel.push_back(std::exp(-0.5 * i * i / (sigma_px * sigma_px)));
        total += kernel.back();
    }
    const auto pass = [&](int dx, int dy) {
        std::vector<double> out(pixels_.size(), 0.0);
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                double value = 0.0;
                for (int i = -reach; i <= reach; ++i) {
                    const int sx = std::clamp(x + i * dx, 0, width_ - 1);
                    const int sy = std::clamp(y + i * dy, 0, height_ - 1);
                    value += kernel[static_cast<std::size_t>(i + reach)] * at(sx, sy);
                }
                out[static_cast<std::size_t>(y * width_ + x)] = value / total;
            }
        }
        pixels_ = std::move(out);
    };
    pass(1, 0);
    pass(0, 1);
}

}  // namespace kambara::testing_support
