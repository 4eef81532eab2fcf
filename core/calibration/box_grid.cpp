// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "core/calibration/projective_fit.h"

namespace kambara {
namespace {

constexpr std::size_t boxes_to_foretell = 4;
constexpr double tolerance_of_size = 0.16;  // of the box's smaller side, for a neighbour
constexpr double tolerance_px = 0.5;

struct Step {
    int columns, rows;
};
constexpr std::array<Step, 4> neighbours{{{1, 0}, {-1, 0}, {0, 1}, {0, -1}}};
constexpr std::array<Step, 10> farther{
    {{1, 1}, {1, -1}, {-1, 1}, {-1, -1}, {2, 0}, {-2, 0}, {0, 2}, {0, -2}, {0, 3}, {0, -3}}};

// One grid, grown from one box.
class Growth {
  public:
    Growth(const std::vector<Quadrilateral>& boxes, const std::vector<Eigen::Vector2d>& centres,
           const std::vector<bool>& taken, const BoxGridOptions& options)
        : options_(&options), centres_(&centres), boxes_(boxes), taken_(taken) {}

    void grow(std::size_t seed, int turn) {
        boxes_[seed] = turned(boxes_[seed], turn);
        grid_ = {{seed, 0, 0}};
        taken_[seed] = true;
        std::size_t near = 0;
        std::size_t far = 0;
        while (near < grid_.size() || far < grid_.size()) {
            const bool is_near = near < grid_.size();
            const GridBox from = grid_[is_near ? near++ : far++];
            if (is_near) {
                for (const Step& step : neighbours) {
                    try_step(from, step);
                }
            } else {
                for (const Step& step : farther) {
                    try_step(from, step);
                }
            }
        }
    }

    const BoxGrid& grid() const { return grid_; }
    const std::vector<Quadrilateral>& boxes() const { return boxes_; }
    const std::vector<bool>& taken() const { return taken_; }
    double score() const { return score_; }

  private:
    bool fits(int column, int row) const {
        int c0 = column, c1 = column, r0 = row, r1 = row;
        for (const GridBox& g : grid_) {
            if (g.column == column && g.row == row) {
                return false;
            }
            c0 = std::min(c0, g.column);
            c1 = std::max(c1, g.column);
            r0 = std::min(r0, g.row);
            r1 = std::max(r1, g.row);
        }
        return c1 - c0 < options_->most_columns && r1 - r0 < options_->most_rows;
    }

    Eigen::Vector2d place(int column, int row, int corner) const {
        return {column * (1.0 + options_->gap_to_width) + (corner == 1 || corner == 2 ? 1.0 : 0.0),
                row * (1.0 + options_->gap_to_height) + (corner >= 2 ? 1.0 : 0.0)};
    }

    // The boxes nearest in the grid foretell another one.
    Quadrilateral foretold(int column, int row) const {
        BoxGrid near = grid_;
        const std::size_t count = std::min(boxes_to_foretell, near.size());
        const auto distance = [&](const GridBox& g) {
            return std::abs(g.column - column) + std::abs(g.row - row);
        };
        std::partial_sort(
            near.begin(), near.begin() + static_cast<std::ptrdiff_t>(count), near.end(),
            [&](const GridBox& a, const GridBox& b) { return distance(a) < distance(b); });
        std::vector<Eigen::Vector2d> places;
        std::vector<Eigen::Vector2d> pixels;
        for (std::size_t i = 0; i < count; ++i) {
            for (int corner = 0; corner < 4; ++corner) {
                places.push_back(place(near[i].column, near[i].row, corner));
                pixels.push_back(boxes_[near[i].box][static_cast<std::size_t>(corner)]);
            }
        }
        const Homography H = fit_homography(places, pixels);
        Quadrilateral box;
        for (int corner = 0; corner < 4; ++corner) {
            box[static_cast<std::size_t>(corner)] = apply(H, place(column, row, corner));
        }
        return box;
    }

    // Whether anything free lies about there at all: most steps end here.
    bool anything_near(const GridBox& from, const Step& step) const {
        const Quadrilateral& b = boxes_[from.box];
        const Eigen::Vector2d across = 0.5 * (b[1] - b[0] + b[2] - b[3]);
        const Eigen::Vector2d down = 0.5 * (b[3] - b[0] + b[2] - b[1]);
        const Eigen::Vector2d at = (*centres_)[from.box] +
                                   step.columns * (1.0 + options_->gap_to_width) * across +
                                   step.rows * (1.0 + options_->gap_to_height) * down;
        const double reach = 0.5 * (across.norm() + down.norm()) *
                             std::max(std::abs(step.columns), std::abs(step.rows));
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            if (!taken_[i] && ((*centres_)[i] - at).norm() < reach) {
                return true;
            }
        }
        return false;
    }

    void try_step(const GridBox& from, const Step& step) {
        const int column = from.column + step.columns;
        const int row = from.row + step.rows;
        if (!fits(column, row) || !anything_near(from, step)) {
            return;
        }
        const Quadrilateral expected = foretold(column, row);
        const Eigen::Vector2d size = mean_size_px(expected);
        const double steps = std::abs(step.columns) + std::abs(step.rows);
        const double tolerance =
            tolerance_px + tolerance_of_size * std::min(size.x(), size.y()) * std::sqrt(steps);
        double best = tolerance;
        std::optional<std::size_t> choice;
        int turn = 0;
        const Eigen::Vector2d centre =
            0.25 * (expected[0] + expected[1] + expected[2] + expected[3]);
        for (std::size_t i = 0; i < boxes_.size(); ++i) {
            if (taken_[i] || !(((*centres_)[i] - centre).norm() < tolerance)) {
                continue;
            }
            const CornerMatch match = match_corners(boxes_[i], expected);
            if (match.farthest_px < best) {
                best = match.farthest_px;
                choice = i;
                turn = match.turn;
            }
        }
        if (choice) {
            boxes_[*choice] = turned(boxes_[*choice], turn);
            taken_[*choice] = true;
            grid_.push_back({*choice, column, row});
            score_ += 1.0 - best / tolerance;
        }
    }

    const BoxGridOptions* options_;
    const std::vector<Eigen::Vector2d>* centres_;
    std::vector<Quadrilateral> boxes_;
    std::vector<bool> taken_;
    BoxGrid grid_;
    double score_ = 0.0;  // how many were added, and how well they fit
};

bool clearly_upright(const Quadrilateral& b) {
    constexpr double within = 0.9;  // cosine
    const Eigen::Vector2d across = b[1] - b[0] + b[2] - b[3];
    const Eigen::Vector2d down = b[3] - b[0] + b[2] - b[1];
    return across.normalized().x() > within && down.normalized().y() > within;
}

}  // namespace

CornerMatch match_corners(const Quadrilateral& box, const Quadrilateral& foretold) {
    CornerMatch best{0, 1e18};
    for (int turn = 0; turn < 4; ++turn) {
        double farthest = 0.0;
        for (int i = 0; i < 4; ++i) {
            const double off = (box[static_cast<std::size_t>((i + turn) % 4)] -
                                foretold[static_cast<std::size_t>(i)])
                                   .norm();
            farthest = std::isfinite(off) ? std::max(farthest, off) : 1e18;
        }
        if (farthest < best.farthest_px) {
            best = {turn, farthest};
        }
    }
    return best;
}

std::vector<BoxGrid> grids_of(std::vector<Quadrilateral>& boxes, const BoxGridOptions& options) {
    std::vector<Eigen::Vector2d> centres;
    centres.reserve(boxes.size());
    for (const Quadrilateral& b : boxes) {
        centres.push_back(0.25 * (b[0] + b[1] + b[2] + b[3]));
    }
    std::vector<bool> taken(boxes.size(), false);
    std::vector<BoxGrid> grids;
    for (std::size_t seed = 0; seed < boxes.size(); ++seed) {
        if (taken[seed]) {
            continue;
        }
        // A box askew may stand on either of its sides: so that most neighbours fit best.
        Growth best(boxes, centres, taken, options);
        best.grow(seed, 0);
        if (!clearly_upright(boxes[seed])) {
            for (const int turn : {1, 3}) {
                Growth other(boxes, centres, taken, options);
                other.grow(seed, turn);
                if (other.score() > best.score()) {
                    std::swap(best, other);
                }
            }
        }
        boxes = best.boxes();
        taken = best.taken();
        grids.push_back(best.grid());
    }
    std::stable_sort(grids.begin(), grids.end(),
                     [](const BoxGrid& a, const BoxGrid& b) { return a.size() > b.size(); });
    return grids;
}

}  // namespace kambara
