// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/box_detector.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/median.h"
#include "core/calibration/box_grid.h"
#include "core/calibration/box_identity.h"
#include "core/calibration/box_measure.h"
#include "core/calibration/target_view.h"

namespace kambara {
namespace {

constexpr double least_outline_px = 2.5;  // breadth of what is looked at closely
constexpr double thin_length_px = 6.0;    // of what may be a box seen from its side
constexpr std::size_t least_thin = 4;     // that make a plane of such boxes
constexpr double unknown_blur_px = 0.3;   // where no edge is seen whole
constexpr double much_blur_px = 0.8;      // which the first look's windows cut short
constexpr int blur_rounds = 4;
constexpr std::size_t lines_for_terms = 12;  // long sides that tell the lens's bending
constexpr std::size_t points_of_long_side = 16;
constexpr double contrast_share = 0.6;  // of the chains' least contrast, at a glance
// A box that lies so far from where the others have it is covered in part, or none.
constexpr double misfit_px = 0.25;
constexpr double misfit_of_size = 0.004;
constexpr double misfit_medians = 6.0;

Image inverted(const Image& grey) {
    Image result = grey;
    for (int y = 0; y < result.height(); ++y) {
        std::uint8_t* row = result.row(y);
        std::transform(row, row + result.width(), row,
                       [](std::uint8_t level) { return static_cast<std::uint8_t>(255 - level); });
    }
    return result;
}

class Detector {
  public:
    Detector(const Image& grey, const BoxLayout& layout, const BoxDetectorOptions& options,
             BoxStages& stages)
        : grey_(grey),
          layout_(layout),
          options_(options),
          stages_(stages),
          light_(light_of_level(1.0)),
          measure_(grey, light_, {layout.gap_to_width, layout.gap_to_height, unknown_blur_px}) {}

    Result<BoxDetection> run() {
        look_for_quadrilaterals();
        for (const FittedBox& candidate : stages_.candidates) {
            corners_.push_back(candidate.corners_px);
        }
        const int most_columns = *std::max_element(layout_.columns.begin(), layout_.columns.end());
        const auto grids = grids_of(
            corners_, {layout_.gap_to_width, layout_.gap_to_height, most_columns, layout_.rows});
        const auto identity = identify_boxes(corners_, grids, layout_, grey_);
        if (!identity) {
            return explained(identity.error(), grids.empty() ? BoxGrid{} : grids.front());
        }
        measure_again(*identity);
        leave_out_misfits();
        return detection();
    }

  private:
    void look_for_quadrilaterals() {
        stages_.chains = closed_edge_chains(grey_, options_.chains);
        for (const EdgeChain& chain : stages_.chains) {
            const auto outline = box_outline(chain);
            if (!outline) {
                continue;
            }
            const double breadth = breadth_px(*outline);
            if (breadth < options_.least_width_px &&
                mean_size_px(*outline).maxCoeff() > std::max(thin_length_px, 2.0 * breadth)) {
                thin_.push_back(*outline);
            }
            if (breadth >= least_outline_px && stands_out(*outline)) {
                stages_.outlines.push_back(upright(*outline));
            }
        }
        // What takes all of a step in depends on its width: again, where it is wider than thought.
        double blur_px = unknown_blur_px;
        auto measured = measure_.each(stages_.outlines);
        for (int round = 0; round < blur_rounds; ++round) {
            std::vector<double> blurs;
            for (const auto& box : measured) {
                if (box && !box->sides[0].points_px.empty()) {
                    blurs.push_back(box->blur_px);
                }
            }
            if (blurs.empty()) {
                break;
            }
            blur_seen_ = true;
            const double before = std::exchange(blur_px, median(blurs));
            measure_.set_blur_px(blur_px);
            if (blur_px < much_blur_px || blur_px < 1.05 * before) {
                break;
            }
            auto again = measure_.each(stages_.outlines);
            for (std::size_t i = 0; i < measured.size(); ++i) {
                if (again[i]) {
                    measured[i] = std::move(again[i]);
                }
            }
        }
        for (auto& box : measured) {
            if (box) {
                stages_.candidates.push_back(std::move(*box));
            }
        }
    }

    // Whether it is darker within than without at the middle of every side: a look at a few pixels
    // that spares much work in a noisy picture.
    bool stands_out(const Quadrilateral& box) const {
        const double depth = std::min(1.8, 0.45 * breadth_px(box));
        for (std::size_t i = 0; i < 4; ++i) {
            const Eigen::Vector2d along = (box[(i + 1) % 4] - box[i]).normalized();
            const Eigen::Vector2d out(along.y(), -along.x());
            const Eigen::Vector2d middle = 0.5 * (box[i] + box[(i + 1) % 4]);
            const double light = std::max(level_at(middle + out), level_at(middle + 1.8 * out));
            const double dark =
                std::min(level_at(middle - 0.5 * depth * out), level_at(middle - depth * out));
            if (light - dark < contrast_share * options_.chains.least_contrast) {
                return false;
            }
        }
        return true;
    }

    double level_at(const Eigen::Vector2d& place) const {
        const int x = static_cast<int>(std::lround(place.x()));
        const int y = static_cast<int>(std::lround(place.y()));
        return grey_.contains(x, y) ? grey_.at(x, y) : 0.0;
    }

    // Long sides tell it best; of small boxes, their corners' places do.
    Straightener straightener(const Identity& identity) const {
        if (options_.lens) {
            return Straightener(*options_.lens);
        }
        std::vector<StraightPoints> lines;
        std::size_t long_sides = 0;
        for (const IdentifiedBox& b : identity.boxes) {
            for (const FittedSide& side : stages_.candidates[b.box].sides) {
                if (side.points_px.size() >= 3) {
                    lines.push_back({side.points_px, side.sigma_px});
                    long_sides += side.points_px.size() >= points_of_long_side ? 1 : 0;
                }
            }
        }
        if (long_sides < lines_for_terms) {
            return Straightener(identity.view.radial);
        }
        // Not the sides' own deviations: those hold the bend.
        for (StraightPoints& line : lines) {
            line.sigma_px = 0.02;
        }
        return Straightener(plumb_line_terms(lines, identity.view.radial));
    }

    void measure_again(const Identity& identity) {
        straightener_ = straightener(identity);
        std::vector<Quadrilateral> starts;
        std::vector<int> numbers;
        for (const IdentifiedBox& b : identity.boxes) {
            starts.push_back(turned(corners_[b.box], b.turn));
            numbers.push_back(b.number);
        }
        const std::size_t identified = starts.size();
        add_foretold(identity.view, starts, numbers);
        const auto measured = measure_.together(starts, straightener_);
        for (std::size_t i = 0; i < measured.size(); ++i) {
            if (measured[i]) {
                stages_.boxes.push_back(*measured[i]);
                stages_.numbers.push_back(numbers[i]);
            } else if (i < identified) {
                remark(numbers[i], "can't be measured");
            }
        }
    }

    // Boxes whose chains came to nothing, where the others say that they must be.
    void add_foretold(const TargetView& view, std::vector<Quadrilateral>& starts,
                      std::vector<int>& numbers) const {
        for (int number = 0; number < layout_.boxes(); ++number) {
            if (std::find(numbers.begin(), numbers.end(), number) != numbers.end()) {
                continue;
            }
            Quadrilateral box;
            bool seen = true;
            for (std::size_t k = 0; k < 4; ++k) {
                const auto pixel = view.pixel(layout_.corners_of(number)[k]);
                seen = seen && pixel;
                box[k] = pixel.value_or(Eigen::Vector2d::Zero());
            }
            if (seen && stands_out(box)) {
                starts.push_back(box);
                numbers.push_back(number);
            }
        }
    }

    // Boxes of which the others say that they lie elsewhere, and those that are too narrow.
    void leave_out_misfits() {
        SeenPoints seen;
        for (std::size_t i = 0; i < stages_.boxes.size(); ++i) {
            const auto points = layout_.corners_of(stages_.numbers[i]);
            for (std::size_t k = 0; k < 4; ++k) {
                const Eigen::Vector2d& pixel = stages_.boxes[i].corners_px[k];
                seen.points.push_back(points[k]);
                seen.pixels.push_back(straightener_.straight(pixel).value_or(pixel));
            }
        }
        if (stages_.boxes.size() < 2) {
            return;
        }
        const TargetView view = fit_view(seen, {});
        std::vector<double> misfits;
        for (std::size_t i = 0; i < stages_.boxes.size(); ++i) {
            double worst = 0.0;
            for (std::size_t k = 4 * i; k < 4 * i + 4; ++k) {
                worst = std::max(worst,
                                 (apply(view.projection, seen.points[k]) - seen.pixels[k]).norm());
            }
            misfits.push_back(worst);
        }
        const double typical = median(misfits);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < stages_.boxes.size(); ++i) {
            const FittedBox& box = stages_.boxes[i];
            const Eigen::Vector2d size = mean_size_px(box.corners_px);
            const double limit =
                std::max(misfit_px + misfit_of_size * size.maxCoeff(), misfit_medians * typical);
            if (misfits[i] > limit) {
                remark(stages_.numbers[i], "lies beside where the others have it");
            } else if (size.minCoeff() < options_.least_width_px) {
                remark(stages_.numbers[i],
                       "is narrower than the " +
                           std::to_string(options_.least_width_px).substr(0, 3) +
                           " px that it takes");
            } else {
                stages_.boxes[kept] = box;
                stages_.numbers[kept] = stages_.numbers[i];
                ++kept;
            }
        }
        stages_.boxes.resize(kept);
        stages_.numbers.resize(kept);
    }

    // As steps between neighbours at two pixels' distance show it, which a pixel's own area and
    // their distance widen: so edges are as wide as those of other targets' corners.
    double edge_width_px(const FittedBox& box) const {
        constexpr double sharp_variance_px2 = 1.0 / 12.0 + 4.0 / 12.0;
        return blur_seen_ ? std::sqrt(2.0 * std::numbers::pi *
                                      (box.blur_px * box.blur_px + sharp_variance_px2))
                          : 0.0;
    }

    void remark(int number, const std::string& what) {
        remarks_.push_back("Box " + std::to_string(number) + " " + what + "; it is left out.");
    }

    Result<BoxDetection> detection() const {
        BoxDetection result;
        result.boxes_total = layout_.boxes();
        result.remarks = remarks_;
        for (std::size_t i = 0; i < stages_.boxes.size(); ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                result.corners.push_back(
                    {4 * stages_.numbers[i] + static_cast<int>(k), stages_.boxes[i].corners_px[k],
                     stages_.boxes[i].sigma_px[k], edge_width_px(stages_.boxes[i])});
            }
        }
        std::sort(result.corners.begin(), result.corners.end(),
                  [](const DetectedCorner& a, const DetectedCorner& b) { return a.id < b.id; });
        if (result.corners.size() < 16) {
            return Error{"Only " + std::to_string(result.corners.size() / 4) +
                             " of the target's boxes are large and clear enough.",
                         "Bring the target nearer, out of glare."};
        }
        return result;
    }

    // A refusal, with what the picture itself may have to do with it.
    Error explained(Error error, const BoxGrid& largest_grid) const {
        std::vector<double> breadths;
        for (const Quadrilateral& outline : stages_.outlines) {
            breadths.push_back(breadth_px(outline));
        }
        if (breadths.size() >= 4 && median(breadths) < options_.least_width_px) {
            error.cause += " Those seen are about " +
                           std::to_string(median(breadths)).substr(0, 3) +
                           " px wide, which is too small.";
            error.remedy = "Bring the target nearer.";
        } else if (const auto thin = thin_beside(largest_grid); !thin.empty()) {
            error.cause += " One plane shows " + std::to_string(largest_grid.size()) +
                           " boxes; others beside it are about " +
                           std::to_string(median(thin)).substr(0, 3) +
                           " px wide, which is too small.";
            error.remedy = "Turn the target so that it faces the camera with both planes, nearer.";
        } else if (const double blur = picture_blur_px(); blur > 2.0) {
            error.cause += " The picture is blurred: its sharpest edges are about " +
                           std::to_string(static_cast<int>(std::lround(2.0 * blur))) + " px wide.";
            error.remedy = "Focus the lens, or hold the target still.";
        }
        return error;
    }

    // Where one plane shows well and long outlines stand beside it that are too narrow: how broad
    // these are. Empty otherwise.
    std::vector<double> thin_beside(const BoxGrid& grid) const {
        if (layout_.columns.size() < 2 ||
            4 * grid.size() < static_cast<std::size_t>(layout_.boxes())) {
            return {};
        }
        Eigen::AlignedBox2d plane;
        for (const GridBox& g : grid) {
            for (const Eigen::Vector2d& corner : corners_[g.box]) {
                plane.extend(corner);
            }
        }
        std::vector<double> breadths;
        for (const Quadrilateral& outline : thin_) {
            if (plane.exteriorDistance(0.5 * (outline[0] + outline[2])) < plane.diagonal().norm()) {
                breadths.push_back(breadth_px(outline));
            }
        }
        return breadths.size() >= least_thin ? breadths : std::vector<double>{};
    }

    // From the steepest steps between neighbours, by the whole range of levels.
    double picture_blur_px() const {
        int darkest = 255;
        int lightest = 0;
        int steepest = 1;
        for (int y = 0; y < grey_.height(); ++y) {
            const std::uint8_t* row = grey_.row(y);
            for (int x = 1; x + 1 < grey_.width(); ++x) {
                darkest = std::min<int>(darkest, row[x]);
                lightest = std::max<int>(lightest, row[x]);
                steepest = std::max(steepest, std::abs(row[x + 1] - row[x - 1]));
            }
        }
        constexpr double root_two_pi = 2.5066;
        return 2.0 * (lightest - darkest) / (root_two_pi * steepest);
    }

    const Image& grey_;
    const BoxLayout& layout_;
    const BoxDetectorOptions& options_;
    BoxStages& stages_;
    const LightOfLevel light_;
    BoxMeasure measure_;
    Straightener straightener_;
    bool blur_seen_ = false;  // an edge whole, so that its width could be told
    std::vector<Quadrilateral> corners_;
    std::vector<Quadrilateral> thin_;  // long outlines, too narrow to be used
    std::vector<std::string> remarks_;
};

}  // namespace

Result<BoxDetection> detect_boxes(const Image& grey, const BoxTarget& target,
                                  const BoxDetectorOptions& options, BoxStages* stages) {
    BoxStages own;
    BoxStages& filled = stages != nullptr ? *stages : own;
    filled = {};
    const BoxLayout layout = box_layout(target);
    if (target.dark_on_light) {
        return Detector(grey, layout, options, filled).run();
    }
    const Image dark_boxes = inverted(grey);
    return Detector(dark_boxes, layout, options, filled).run();
}

}  // namespace kambara
