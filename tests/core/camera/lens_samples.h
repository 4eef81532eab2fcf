// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <random>
#include <vector>

#include "core/camera/lens.h"

namespace kambara {

/// Lenses of every kind as real cameras of 640 x 480 have them: barrel and pincushion, narrow and
/// wide, Tsai and Brown with five and eight terms. The same ones every time.
inline std::vector<Lens> lens_samples(int of_each_kind) {
    std::mt19937 random(20);
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    std::vector<Lens> lenses;
    for (int i = 0; i < of_each_kind; ++i) {
        TsaiLens tsai{between(2.5, 9.0),   0.0,
                      between(290, 350),   between(210, 270),
                      between(0.97, 1.04), {0.00635, 0.0074, 768, 640}};
        tsai.kappa1_per_mm2 = between(0.0, 0.06);
        lenses.emplace_back(tsai);
        tsai.kappa1_per_mm2 = between(-0.2, 0.0) / (tsai.f_mm * tsai.f_mm);
        lenses.emplace_back(tsai);
        const double f_px = between(350, 1200);
        const auto brown = [&](const std::vector<double>& terms) {
            return BrownLens(f_px, f_px * between(0.95, 1.05), between(290, 350), between(210, 270),
                             terms);
        };
        const double p1 = between(-2e-3, 2e-3);
        const double p2 = between(-2e-3, 2e-3);
        lenses.emplace_back(
            brown({between(-0.35, -0.05), between(0.05, 0.15), p1, p2, between(-0.02, 0.0)}));
        lenses.emplace_back(brown({between(0.0, 0.2), between(-0.05, 0.05), p1, p2, 0.0}));
        lenses.emplace_back(brown({between(0.1, 0.4), between(0.0, 0.1), p1, p2, between(0.0, 0.02),
                                   between(0.3, 0.8), between(0.1, 0.2), between(0.0, 0.05)}));
    }
    return lenses;
}

/// Pixels all over the picture, its borders included.
inline std::vector<Eigen::Vector2d> picture_grid(int width_px, int height_px, int steps) {
    std::vector<Eigen::Vector2d> pixels;
    for (int j = 0; j <= steps; ++j) {
        for (int i = 0; i <= steps; ++i) {
            pixels.emplace_back((width_px - 1.0) * i / steps, (height_px - 1.0) * j / steps);
        }
    }
    return pixels;
}

}  // namespace kambara
