// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <charconv>
#include <cmath>
#include <sstream>
#include <vector>

#include "core/camera/foreign_formats.h"

namespace kambara {
namespace {

using Projection = std::array<double, 12>;

// The numbers of a line after an optional name with a colon; empty where it is no such line.
std::vector<double> numbers_of(const std::string& line) {
    const auto colon = line.find(':');
    std::istringstream words(colon == std::string::npos ? line : line.substr(colon + 1));
    std::vector<double> numbers;
    std::string word;
    while (words >> word) {
        double number = 0.0;
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), number);
        if (code != std::errc{} || end != word.data() + word.size() || !std::isfinite(number)) {
            return {};
        }
        numbers.push_back(number);
    }
    return numbers;
}

Error refused(const std::string& why) {
    return {"The KITTI calibration " + why + ".",
            "Give a calib.txt with two lines of twelve numbers: the left and the right projection "
            "matrix."};
}

}  // namespace

Result<Rig> rig_from_kitti(std::string_view text, const std::optional<PictureSize>& size) {
    std::vector<Projection> matrices;
    std::istringstream lines{std::string(text)};
    std::string line;
    while (std::getline(lines, line) && matrices.size() < 2) {
        const auto numbers = numbers_of(line);
        if (numbers.size() == 12) {
            Projection P;
            std::copy(numbers.begin(), numbers.end(), P.begin());
            matrices.push_back(P);
        }
    }
    if (matrices.size() != 2) {
        return refused("does not hold two projection matrices");
    }
    if (!size) {
        return Error{"A KITTI calibration does not say how large the pictures are.",
                     "Give --size W,H."};
    }
    Camera cameras[2];
    double offset_mm[2];
    for (std::size_t i = 0; i < 2; ++i) {
        const Projection& P = matrices[i];
        if (std::abs(P[10] - 1.0) > 1e-9 || P[0] <= 0.0 || P[5] <= 0.0 || P[1] != 0.0 ||
            P[4] != 0.0 || P[8] != 0.0 || P[9] != 0.0) {
            return refused("holds a matrix that is not a rectified camera's");
        }
        cameras[i] = {BrownLens(P[0], P[5], P[2], P[6]), size->width_px, size->height_px, {}};
        if (const auto why = implausibility(cameras[i].lens, size->width_px, size->height_px);
            !why.empty()) {
            return refused("can't be: " + why);
        }
        offset_mm[i] = 1000.0 * P[3] / P[0];
    }
    RigidTransform T_right_from_left;
    T_right_from_left.t_mm.x() = offset_mm[1] - offset_mm[0];
    if (!(std::abs(T_right_from_left.t_mm.x()) > 1e-3)) {
        return refused("has both cameras in one place");
    }
    Rig rig = rig_from_pair(cameras[0], cameras[1], T_right_from_left);
    rig.provenance.method = "converted from kitti";
    return rig;
}

}  // namespace kambara
