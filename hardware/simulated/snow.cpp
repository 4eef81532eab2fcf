// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/snow.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

namespace kambara {
namespace {

// From the camera's window on, and as far as flakes can be told apart.
const Eigen::Array3d box_from_mm(-900.0, -600.0, 30.0);
const Eigen::Array3d box_size_mm(2250.0, 1300.0, 1500.0);
// As water passes a vehicle that keeps its place in 0.3 knots; flakes sink by about 1 mm/s.
const Eigen::Vector3d current_mm_s(150.0, 1.0, 0.0);
constexpr double stirred_mm_s = 25.0;

// The next whole number below; faster than std::floor.
double whole(double value) {
    const auto towards_zero = static_cast<double>(static_cast<std::int64_t>(value));
    return towards_zero - (value < towards_zero ? 1.0 : 0.0);
}

}  // namespace

double Snow::box_litres() {
    return box_size_mm.prod() * 1e-6;
}

Snow::Snow(double per_litre, std::uint32_t seed) {
    std::mt19937 random(seed * 15485863U + 29U);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::normal_distribution<double> normal;
    const auto count = static_cast<std::size_t>(std::llround(per_litre * box_litres()));
    flakes_.reserve(count);
    const double most = std::pow(thinnest_mm, -3.0);
    const double least = std::pow(thickest_mm, -3.0);
    for (std::size_t i = 0; i < count; ++i) {
        const Eigen::Array3d share(unit(random), unit(random), unit(random));
        const Eigen::Vector3d stirred(normal(random), normal(random), normal(random));
        // As many flakes are thicker than D as the integral of D^-4 says: D^-3 is uniform.
        const double diameter_mm = std::pow(most - unit(random) * (most - least), -1.0 / 3.0);
        flakes_.push_back({(box_size_mm * share).matrix().cast<float>(),
                           (current_mm_s + stirred_mm_s * stirred).cast<float>(),
                           static_cast<float>(diameter_mm),
                           static_cast<float>(130.0 + 100.0 * unit(random))});
    }
}

Eigen::Vector3f Snow::place_mm(const Flake& flake, double time_s) {
    Eigen::Vector3f place;
    for (int i = 0; i < 3; ++i) {
        const double on = static_cast<double>(flake.start_mm[i]) +
                          time_s * static_cast<double>(flake.drift_mm_s[i]);
        place[i] =
            static_cast<float>(on - box_size_mm[i] * whole(on / box_size_mm[i]) + box_from_mm[i]);
    }
    return place;
}

}  // namespace kambara
