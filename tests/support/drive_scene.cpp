// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <fstream>

#include "core/base/median.h"
#include "core/matching/matcher.h"
#include "core/matching/peak.h"
#include "tests/support/real_scenes.h"

namespace kambara::testing_support {
namespace {

namespace fs = std::filesystem;

constexpr int half_px = 7;  // of the squares by which disparities are measured
constexpr int most_disparity_px = 120;
constexpr double least_disparity_px = 3.0;
constexpr double disparity_error_px = 0.3;
constexpr double most_truth_error_px = 0.8;  // that such an error may cause

// Zero-mean correlation's best place for the square about a pixel, by its centre, where it is good
// and without a rival.
std::optional<Eigen::Vector2d> clear_match(const Image& from, const Eigen::Vector2i& at,
                                           const Image& in, const Rectangle& centres) {
    constexpr int side = 2 * half_px + 1;
    const Rectangle square{at.x() - half_px, at.y() - half_px, side, side};
    if (!square.inside(from.width(), from.height())) {
        return std::nullopt;
    }
    thread_local Matcher matcher;
    thread_local ScoreMap map;
    matcher.set_template(from, square);
    matcher.scores(in, {centres.x - half_px, centres.y - half_px, centres.width, centres.height},
                   map);
    const auto peak = best_peak(map, Measure::zncc);
    if (!peak || peak->on_border || peak->score < 0.9 ||
        runner_up(map, Measure::zncc, *peak, 5).value_or(0.0) > peak->score - 0.05) {
        return std::nullopt;
    }
    return Eigen::Vector2d(peak->x + half_px, peak->y + half_px);
}

// How far to the left the right picture shows it, checked from there back.
std::optional<double> disparity(const Image& left, const Image& right, const Eigen::Vector2i& at) {
    const auto there = clear_match(
        left, at, right, {at.x() - most_disparity_px, at.y() - 2, most_disparity_px + 2, 5});
    if (!there || std::abs(there->y() - at.y()) > 0.7) {
        return std::nullopt;
    }
    const Eigen::Vector2i whole = there->array().round().cast<int>();
    const auto back =
        clear_match(right, whole, left, {whole.x() - 1, whole.y() - 2, most_disparity_px + 2, 5});
    const double found = at.x() - there->x();
    if (!back || std::abs(back->x() - whole.x() - found) > 1.0 || found < least_disparity_px) {
        return std::nullopt;
    }
    return found;
}

using Poses = std::vector<Eigen::Isometry3d>;

struct Drive {
    std::vector<ImagePtr> left;
    std::vector<ImagePtr> right;
    Poses world_from_left;  // metres
    double f_px = 1.0;
    double cx_px = 0.0;
    double cy_px = 0.0;
    double f_baseline_px_m = 1.0;
    // What the poses' small errors in rotation shift the picture by, summed up to each frame.
    std::vector<Eigen::Vector2d> drift_px;

    // A pixel with its disparity, of what stands still, as another frame sees it.
    Eigen::Vector3d seen_from(std::size_t a, const Eigen::Vector3d& pixel_and_disparity,
                              std::size_t b) const {
        const double z = f_baseline_px_m / pixel_and_disparity.z();
        const Eigen::Vector3d point((pixel_and_disparity.x() - cx_px) * z / f_px,
                                    (pixel_and_disparity.y() - cy_px) * z / f_px, z);
        const Eigen::Vector3d p = world_from_left[b].inverse() * (world_from_left[a] * point);
        const Eigen::Vector2d drift = drift_px[b] - drift_px[a];
        return {f_px * p.x() / p.z() + cx_px + drift.x(), f_px * p.y() / p.z() + cy_px + drift.y(),
                f_baseline_px_m / p.z()};
    }
};

// Where the square about a pixel is in another frame, near where it should be.
std::optional<Eigen::Vector2d> found_near(const Drive& drive, std::size_t a,
                                          const Eigen::Vector2i& at, std::size_t b,
                                          const Eigen::Vector2d& expected) {
    constexpr int reach_px = 8;
    const Eigen::Vector2i whole = expected.array().round().cast<int>();
    return clear_match(
        *drive.left[a], at, *drive.left[b],
        {whole.x() - reach_px, whole.y() - reach_px, 2 * reach_px + 1, 2 * reach_px + 1});
}

// How far the next frame's things are from where the poses say: the median over a grid.
Eigen::Vector2d drift_to_next(const Drive& drive, std::size_t a) {
    constexpr int grid_px = 24;
    std::vector<double> across;
    std::vector<double> down;
    for (int y = grid_px; y < drive.left[a]->height(); y += grid_px) {
        for (int x = grid_px; x < drive.left[a]->width(); x += grid_px) {
            if (const auto deep = disparity(*drive.left[a], *drive.right[a], {x, y})) {
                const Eigen::Vector2d expected =
                    drive.seen_from(a, {1.0 * x, 1.0 * y, *deep}, a + 1).head<2>();
                if (const auto found = found_near(drive, a, {x, y}, a + 1, expected)) {
                    across.push_back(found->x() - expected.x());
                    down.push_back(found->y() - expected.y());
                }
            }
        }
    }
    return {median(across), median(down)};
}

// Whether the frame before shows it where something standing still would be.
bool stands_still(const Drive& drive, std::size_t a, const Eigen::Vector3d& seen) {
    const Eigen::Vector3d expected = drive.seen_from(a, seen, a - 1);
    const Eigen::Vector2i whole = expected.head<2>().array().round().cast<int>();
    const Eigen::Vector2i at = seen.head<2>().cast<int>();
    const auto before = found_near(drive, a, at, a - 1, expected.head<2>());
    if (!before || (*before - expected.head<2>()).norm() > 1.0) {
        return false;
    }
    const auto deep = disparity(*drive.left[a - 1], *drive.right[a - 1], whole);
    return deep && std::abs(*deep - expected.z()) < 1.0;
}

std::vector<std::vector<double>> rows_of(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<std::vector<double>> rows;
    std::vector<double> row;
    for (double value = 0.0; stream >> value;) {
        row.push_back(value);
        if (row.size() == 12) {
            rows.push_back(std::move(row));
            row.clear();
        }
    }
    return rows;
}

Result<Drive> read_drive(const fs::path& folder) {
    auto left = grey_pictures((folder / "left" / "%06d.png").string());
    auto right = grey_pictures((folder / "right" / "%06d.png").string());
    if (!left || !right) {
        return left ? right.error() : left.error();
    }
    const auto cameras = rows_of(folder / "calib.txt");
    const auto poses = rows_of(folder / "poses.txt");
    if (cameras.size() != 2 || poses.size() < left->size() || left->size() != right->size()) {
        return Error{"The recording in " + folder.string() + " is not complete.",
                     "It holds pairs of pictures, calib.txt and poses.txt."};
    }
    Drive drive{std::move(*left), std::move(*right), {}, cameras[0][0], cameras[0][2],
                cameras[0][6],    -cameras[1][3],    {}};
    for (const auto& row : poses) {
        Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
        pose.matrix().topRows<3>() =
            Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(row.data());
        drive.world_from_left.push_back(pose);
    }
    drive.drift_px.assign(drive.left.size(), Eigen::Vector2d::Zero());
    for (std::size_t i = 0; i + 1 < drive.left.size(); ++i) {
        drive.drift_px[i + 1] = drive.drift_px[i];
        drive.drift_px[i + 1] += drift_to_next(drive, i);
    }
    return drive;
}

}  // namespace

Result<SearchSet> searches_from_the_car(const fs::path& data, int per_half) {
    const auto drive = read_drive(data / "drive");
    if (!drive) {
        return drive.error();
    }
    const Try one_try = [&](int first, int end, Random& random) -> std::optional<Search> {
        const int later = 1 + random.below(6);
        const int frame = first + 1 + random.below(end - first - 1 - later);
        const auto a = static_cast<std::size_t>(frame);
        const auto b = static_cast<std::size_t>(frame + later);
        const Image& picture = *drive->left[a];
        const Eigen::Vector2i at{random.below(picture.width()), random.below(picture.height())};
        const auto deep = disparity(picture, *drive->right[a], at);
        if (!deep) {
            return std::nullopt;
        }
        const Eigen::Vector3d seen(at.x(), at.y(), *deep);
        const Eigen::Vector2d truth = drive->seen_from(a, seen, b).head<2>();
        for (const double error : {-disparity_error_px, disparity_error_px}) {
            const Eigen::Vector3d other = seen + Eigen::Vector3d(0.0, 0.0, error);
            if ((drive->seen_from(a, other, b).head<2>() - truth).norm() > most_truth_error_px) {
                return std::nullopt;
            }
        }
        if (!stands_still(*drive, a, seen)) {
            return std::nullopt;
        }
        return search_about(drive->left[a], seen.head<2>(), drive->left[b], truth, random);
    };
    return both_halves("car", one_try, static_cast<int>(drive->left.size()), per_half, 5);
}

}  // namespace kambara::testing_support
