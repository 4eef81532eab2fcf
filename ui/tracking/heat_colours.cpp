// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tracking/heat_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace kambara::ui {
namespace {

struct Stop {
    double red, green, blue;
};
constexpr std::array<Stop, 6> stops{
    {{6, 6, 30}, {60, 15, 110}, {140, 40, 120}, {215, 80, 75}, {250, 155, 45}, {252, 250, 170}}};

std::array<QRgb, 256> table() {
    std::array<QRgb, 256> colours{};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        const double place = static_cast<double>(i) / 255.0 * (stops.size() - 1);
        const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(place), 4);
        const double t = place - static_cast<double>(below);
        const auto mix = [&](double a, double b) {
            return static_cast<int>(std::lround(a + t * (b - a)));
        };
        const Stop& a = stops[below];
        const Stop& b = stops[below + 1];
        colours[i] = qRgb(mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue));
    }
    return colours;
}

}  // namespace

QRgb heat_colour(double share) {
    static const auto colours = table();
    return colours[static_cast<std::size_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)))];
}

}  // namespace kambara::ui
