// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_identity.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/base/median.h"
#include "core/calibration/box_marks.h"

namespace kambara {
namespace {

constexpr std::size_t least_boxes = 4;
constexpr std::size_t most_pairs = 60;  // of grids that are tried
constexpr int most_fitted = 6;  // of the placements of a pair, the best ones, fitted in full
// What a view may leave unexplained: an honest one leaves what its one radial term doesn't tell.
constexpr double most_rms_px = 0.3;
constexpr double most_rms_of_size = 0.012;
// A rival placement counts as possible when it fits not much worse.
constexpr double rival_factor = 3.0;
constexpr double rival_px = 0.1;
// Of the direction of a grid's rows along x: a plane's may be far off the target's.
constexpr double least_upright = 0.17;
constexpr double least_target_upright = 0.5;  // 60 degrees: 45, and what perspective adds

// A grid on a plane, turned by so many quarters: its first column and row stand there.
struct Placement {
    const BoxGrid* grid;
    int turn, plane, column, row;
};

struct Extent {
    int column0, row0, columns, rows;
};

Extent extent_of(const BoxGrid& grid) {
    int c0 = grid[0].column, c1 = c0, r0 = grid[0].row, r1 = r0;
    for (const GridBox& g : grid) {
        c0 = std::min(c0, g.column);
        c1 = std::max(c1, g.column);
        r0 = std::min(r0, g.row);
        r1 = std::max(r1, g.row);
    }
    return {c0, r0, c1 - c0 + 1, r1 - r0 + 1};
}

// By quarter turns: what was the top right corner becomes the top left one.
BoxGrid turned_grid(BoxGrid grid, int turn) {
    for (int i = 0; i < turn; ++i) {
        for (GridBox& g : grid) {
            g = {g.box, g.row, -g.column};
        }
    }
    return grid;
}

struct Candidate {
    std::vector<IdentifiedBox> boxes;
    TargetView view;
    double rms = 1e9;
};

class Identification {
  public:
    Identification(const std::vector<Quadrilateral>& boxes, const std::vector<BoxGrid>& grids,
                   const BoxLayout& layout, const Image& grey)
        : boxes_(boxes), grids_(grids), layout_(layout), grey_(grey) {
        radial_.centre_px = {0.5 * (grey.width() - 1), 0.5 * (grey.height() - 1)};
        radial_.radius_px = radial_.centre_px.norm();
    }

    Result<Identity> run() {
        if (layout_.columns.size() == 1) {
            for (std::size_t i = 0; i < std::min(most_pairs, grids_.size()); ++i) {
                std::vector<std::vector<Placement>> all;
                for (const int roll : rolls()) {
                    for (const Placement& placement : placements_of(grids_[i], 0, roll)) {
                        all.push_back({placement});
                    }
                }
                try_placements(all);
                if (!found_.empty()) {
                    break;
                }
            }
        } else {
            try_pairs();
        }
        return judged();
    }

  private:
    // By how many quarters the target itself may be turned.
    std::vector<int> rolls() const {
        return layout_.marks.empty() ? std::vector<int>{0} : std::vector<int>{0, 1, 2, 3};
    }

    const Quadrilateral& first_of(const BoxGrid& grid) const { return boxes_[grid[0].box]; }

    Eigen::Vector2d centre_of(const BoxGrid& grid) const {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const GridBox& g : grid) {
            const Quadrilateral& b = boxes_[g.box];
            sum += 0.25 * (b[0] + b[1] + b[2] + b[3]);
        }
        return sum / static_cast<double>(grid.size());
    }

    // The direction of a grid's rows, as its boxes' sides of both kinds have it together.
    Eigen::Vector2d across_of(const BoxGrid& grid) const {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const GridBox& g : grid) {
            sum += across_of(boxes_[g.box]);
        }
        return sum.normalized();
    }
    static Eigen::Vector2d across_of(const Quadrilateral& b) {
        const Eigen::Vector2d across = b[1] - b[0] + b[2] - b[3];
        const Eigen::Vector2d down = b[3] - b[0] + b[2] - b[1];
        return across.normalized() + Eigen::Vector2d(down.y(), -down.x()).normalized();
    }

    // The quarter turns in which a grid may stand: a plane seen askew may look turned by more than
    // the target is.
    std::vector<int> turns_of(const BoxGrid& grid) const {
        const Eigen::Vector2d across = across_of(grid);
        std::vector<int> turns;
        for (int turn = 0; turn < 4; ++turn) {
            // The row's direction after the turns: down is where across was turned clockwise.
            const double x = turn == 0   ? across.x()
                             : turn == 1 ? -across.y()
                             : turn == 2 ? -across.x()
                                         : across.y();
            if (x > least_upright) {
                turns.push_back(turn);
            }
        }
        return turns;
    }

    std::vector<Placement> placements_of(const BoxGrid& grid, int plane, int roll) const {
        std::vector<Placement> all;
        for (const int upright_turn : turns_of(grid)) {
            const int turn = (upright_turn + roll) % 4;
            const Extent e = extent_of(turned_grid(grid, turn));
            for (int c = 0; c + e.columns <= layout_.columns[static_cast<std::size_t>(plane)];
                 ++c) {
                for (int r = 0; r + e.rows <= layout_.rows; ++r) {
                    all.push_back({&grid, turn, plane, c, r});
                }
            }
        }
        return all;
    }

    // Pairs of grids, the most boxes first, near enough to be neighbours, left one first.
    void try_pairs() {
        struct Pair {
            std::size_t a, b, size;
        };
        std::vector<Pair> pairs;
        for (std::size_t a = 0; a < grids_.size(); ++a) {
            for (std::size_t b = a + 1; b < grids_.size() && grids_[a].size() > 1; ++b) {
                const std::size_t size = grids_[a].size() + grids_[b].size();
                if (size >= least_boxes && near(grids_[a], grids_[b])) {
                    pairs.push_back({a, b, size});
                }
            }
        }
        std::stable_sort(pairs.begin(), pairs.end(),
                         [](const Pair& a, const Pair& b) { return a.size > b.size; });
        pairs.resize(std::min(pairs.size(), most_pairs));
        for (const Pair& pair : pairs) {
            std::vector<std::vector<Placement>> all;
            for (const int roll : rolls()) {
                add_placements(grids_[pair.a], grids_[pair.b], roll, all);
            }
            try_placements(all);
            if (!found_.empty()) {
                return;
            }
        }
    }

    void add_placements(const BoxGrid& one, const BoxGrid& other, int roll,
                        std::vector<std::vector<Placement>>& all) const {
        // To the right on the target: a quarter more of roll turns that clockwise in the picture.
        const Eigen::Vector2d from = centre_of(other) - centre_of(one);
        const double right = roll == 0   ? from.x()
                             : roll == 1 ? from.y()
                             : roll == 2 ? -from.x()
                                         : -from.y();
        const BoxGrid& first = right < 0.0 ? other : one;
        const BoxGrid& last = right < 0.0 ? one : other;
        for (int p = 0; p < static_cast<int>(layout_.columns.size()); ++p) {
            for (int q = p + 1; q < static_cast<int>(layout_.columns.size()); ++q) {
                for (const Placement& a : placements_of(first, p, roll)) {
                    for (const Placement& b : placements_of(last, q, roll)) {
                        all.push_back({a, b});
                    }
                }
            }
        }
    }

    // Within so many boxes' sizes that one target can hold both.
    bool near(const BoxGrid& a, const BoxGrid& b) const {
        const Eigen::Vector2d size_a = mean_size_px(first_of(a));
        const Eigen::Vector2d size_b = mean_size_px(first_of(b));
        const double height = std::max(size_a.y(), size_b.y());
        if (std::min(size_a.y(), size_b.y()) < 0.3 * height) {
            return false;
        }
        const double rows = layout_.rows * (1.0 + layout_.gap_to_height);
        return (centre_of(a) - centre_of(b)).norm() < 1.5 * rows * height;
    }

    SeenPoints seen(const std::vector<IdentifiedBox>& boxes) const {
        SeenPoints result;
        for (const IdentifiedBox& b : boxes) {
            const auto corners = layout_.corners_of(b.number);
            for (std::size_t i = 0; i < 4; ++i) {
                result.points.push_back(corners[i]);
                result.pixels.push_back(boxes_[b.box][(i + static_cast<std::size_t>(b.turn)) % 4]);
            }
        }
        return result;
    }

    std::vector<IdentifiedBox> placed(const std::vector<Placement>& placements) const {
        std::vector<IdentifiedBox> result;
        for (const Placement& p : placements) {
            const BoxGrid grid = turned_grid(*p.grid, p.turn);
            const Extent e = extent_of(grid);
            for (const GridBox& g : grid) {
                const BoxPlace place{p.plane, p.column + g.column - e.column0,
                                     p.row + g.row - e.row0};
                result.push_back({g.box, layout_.box_number(place), p.turn});
            }
        }
        return result;
    }

    // Those that fit best at first sight are looked at closely.
    void try_placements(const std::vector<std::vector<Placement>>& all) {
        std::vector<Candidate> candidates;
        for (const auto& placements : all) {
            Candidate candidate{placed(placements), {}, 1e9};
            const SeenPoints points = seen(candidate.boxes);
            for (const double k1 : {0.0, 0.15, 0.3}) {
                RadialTerms radial = radial_;
                radial.k1 = k1;
                const TargetView view = fit_view(points, radial);
                candidate.rms = std::min(candidate.rms, rms_px(view, points));
            }
            candidates.push_back(std::move(candidate));
        }
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](const Candidate& a, const Candidate& b) { return a.rms < b.rms; });
        int fitted = 0;
        for (Candidate& candidate : candidates) {
            if (fitted >= most_fitted &&
                candidate.rms > rival_factor * candidates.front().rms + rival_px) {
                break;
            }
            ++fitted;
            if (!complete(candidate)) {
                continue;
            }
            if (marks_agree(candidate)) {
                found_.push_back(std::move(candidate));
            } else {
                without_mark_ = std::max(without_mark_, candidate.boxes.size());
            }
        }
    }

    double allowed_px(const std::vector<IdentifiedBox>& boxes) const {
        double size = 0.0;
        for (const IdentifiedBox& b : boxes) {
            size += mean_size_px(boxes_[b.box]).mean() / static_cast<double>(boxes.size());
        }
        return most_rms_px + most_rms_of_size * size;
    }

    bool stands_upright(const std::vector<IdentifiedBox>& boxes) const {
        Eigen::Vector2d sum = Eigen::Vector2d::Zero();
        for (const IdentifiedBox& b : boxes) {
            sum += across_of(turned(boxes_[b.box], b.turn)).normalized();
        }
        return sum.x() > least_target_upright * sum.norm();
    }

    bool fit(Candidate& candidate) const {
        const SeenPoints points = seen(candidate.boxes);
        candidate.view = fit_view_and_radial(points, radial_);
        candidate.rms = rms_px(candidate.view, points);
        return candidate.rms <= allowed_px(candidate.boxes) &&
               (!layout_.marks.empty() || stands_upright(candidate.boxes)) &&
               (layout_.columns.size() == 1 ||
                seen_from_before(candidate.view.projection, points.points));
    }

    std::optional<Quadrilateral> foretold(const TargetView& view, int number) const {
        Quadrilateral box;
        const auto corners = layout_.corners_of(number);
        for (std::size_t i = 0; i < 4; ++i) {
            const auto pixel = view.pixel(corners[i]);
            if (!pixel) {
                return std::nullopt;
            }
            box[i] = *pixel;
        }
        return box;
    }

    // Fits, and takes up what the view foretells of the boxes that are missing.
    bool complete(Candidate& candidate) const {
        if (!fit(candidate)) {
            return false;
        }
        for (int round = 0; round < 2; ++round) {
            std::set<std::size_t> used;
            std::set<int> numbers;
            for (const IdentifiedBox& b : candidate.boxes) {
                used.insert(b.box);
                numbers.insert(b.number);
            }
            const std::size_t before = candidate.boxes.size();
            for (int number = 0; number < layout_.boxes(); ++number) {
                const auto expected =
                    numbers.contains(number) ? std::nullopt : foretold(candidate.view, number);
                for (std::size_t i = 0; expected && i < boxes_.size(); ++i) {
                    if (used.contains(i)) {
                        continue;
                    }
                    const CornerMatch match = match_corners(boxes_[i], *expected);
                    if (match.farthest_px < 2.0 * allowed_px({{i, number, 0}}) + 0.5) {
                        candidate.boxes.push_back({i, number, match.turn});
                        used.insert(i);
                        break;
                    }
                }
            }
            if (candidate.boxes.size() == before) {
                break;
            }
            if (!fit(candidate)) {
                return false;
            }
        }
        return candidate.boxes.size() >= least_boxes;
    }

    // One mark at the least, and none missing where it ought to be seen.
    bool marks_agree(const Candidate& candidate) const {
        if (layout_.marks.empty()) {
            return true;
        }
        std::vector<double> ink;
        for (const IdentifiedBox& b : candidate.boxes) {
            const Quadrilateral& box = boxes_[b.box];
            if (const auto level =
                    level_between(grey_, 0.25 * (box[0] + box[1] + box[2] + box[3]))) {
                ink.push_back(*level);
            }
        }
        const SeenMarks seen = seen_marks(grey_, layout_.marks, candidate.view, median(ink));
        return seen.present > 0 && seen.absent == 0;
    }

    bool certain(const Candidate& candidate) const {
        if (!layout_.marks.empty()) {
            return true;  // its marks are where they should be
        }
        int top = layout_.rows;
        int bottom = -1;
        int first = 1 << 20;
        int last = -1;
        const bool flat = layout_.columns.size() == 1;
        for (const IdentifiedBox& b : candidate.boxes) {
            const BoxPlace place = layout_.place_of(b.number);
            top = std::min(top, place.row);
            bottom = std::max(bottom, place.row);
            first = std::min(first, flat ? place.column : place.plane);
            last = std::max(last, flat ? place.column : place.plane);
        }
        const int end =
            flat ? layout_.columns[0] - 1 : static_cast<int>(layout_.columns.size()) - 1;
        return top == 0 && bottom == layout_.rows - 1 && first == 0 && last == end;
    }

    static bool contradict(const Candidate& a, const Candidate& b) {
        for (const IdentifiedBox& x : a.boxes) {
            for (const IdentifiedBox& y : b.boxes) {
                if (x.box == y.box && x.number != y.number) {
                    return true;
                }
            }
        }
        return false;
    }

    Result<Identity> judged() const {
        const auto better = [](const Candidate& a, const Candidate& b) {
            return a.boxes.size() != b.boxes.size() ? a.boxes.size() > b.boxes.size()
                                                    : a.rms < b.rms;
        };
        const auto best = std::min_element(found_.begin(), found_.end(), better);
        const std::string target = std::to_string(layout_.boxes()) + " boxes";
        if (best == found_.end() && without_mark_ > 0) {
            return Error{std::to_string(without_mark_) + " of the target's " + target +
                             " are found, but its round marks are not where they belong.",
                         "Show a mark, unhidden and without glare; check that the target is the "
                         "one that carries them."};
        }
        if (best == found_.end()) {
            return Error{"No boxes that stand like the target's " + target + " are found among " +
                             std::to_string(boxes_.size()) + " quadrilaterals.",
                         "Show more of the target, evenly lit, within 45 degrees of upright."};
        }
        const bool rivals = std::any_of(found_.begin(), found_.end(), [&](const Candidate& other) {
            return contradict(*best, other) && other.rms < rival_factor * best->rms + rival_px &&
                   5 * other.boxes.size() >= 4 * best->boxes.size();
        });
        if (rivals || !certain(*best)) {
            return Error{"Which of the target's " + target + " the " +
                             std::to_string(best->boxes.size()) +
                             " found are can't be told for certain.",
                         layout_.columns.size() == 1
                             ? "Show boxes of the top and the bottom row, and of the first and the "
                               "last column."
                             : "Show boxes of the top and the bottom row, and of both planes."};
        }
        return Identity{best->boxes, best->view, best->rms};
    }

    const std::vector<Quadrilateral>& boxes_;
    const std::vector<BoxGrid>& grids_;
    const BoxLayout& layout_;
    const Image& grey_;
    RadialTerms radial_;
    std::vector<Candidate> found_;
    std::size_t without_mark_ = 0;  // boxes of the best placement that the marks spoke against
};

}  // namespace

Result<Identity> identify_boxes(const std::vector<Quadrilateral>& boxes,
                                const std::vector<BoxGrid>& grids, const BoxLayout& layout,
                                const Image& grey) {
    return Identification(boxes, grids, layout, grey).run();
}

}  // namespace kambara
