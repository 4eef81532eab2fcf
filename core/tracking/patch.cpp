// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/patch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/matching/cubic_spline.h"
#include "core/matching/score_map.h"

namespace kambara {
namespace {

constexpr double smallest_cosine = 0.05;  // rays along the plane hit it nowhere useful
constexpr double least_forward = 0.02;    // of a ray's direction, to meet a plane before the rig
constexpr double least_turn_rad = 0.03;   // a patch turned by less is drawn in full, unmasked
// Likewise where the cameras are turned against each other: usual rigs are by less.
constexpr double least_view_turn_rad = 0.15;

constexpr int coarse_cell_px = 4;
constexpr int fine_cell_px = 2;

// Keys' cubic convolution with a = -1/2: exact for quadratics.
void cubic_weights(double t, double* w) {
    const double t2 = t * t;
    const double t3 = t2 * t;
    w[0] = -0.5 * t3 + t2 - 0.5 * t;
    w[1] = 1.5 * t3 - 2.5 * t2 + 1.0;
    w[2] = -1.5 * t3 + 2.0 * t2 + 0.5 * t;
    w[3] = 0.5 * t3 - 0.5 * t2;
}

// Pixels beyond the border repeat it: only the interpolation's outermost taps ever ask for them.
double cubic_sample(const Image& grey, double x, double y) {
    const double fx = std::floor(x);
    const double fy = std::floor(y);
    double wx[4];
    double wy[4];
    cubic_weights(x - fx, wx);
    cubic_weights(y - fy, wy);
    const int x0 = static_cast<int>(fx) - 1;
    const int y0 = static_cast<int>(fy) - 1;
    double sum = 0.0;
    for (int j = 0; j < 4; ++j) {
        const std::uint8_t* row = grey.row(std::clamp(y0 + j, 0, grey.height() - 1));
        double of_row = 0.0;
        for (int i = 0; i < 4; ++i) {
            of_row += wx[i] * row[std::clamp(x0 + i, 0, grey.width() - 1)];
        }
        sum += wy[j] * of_row;
    }
    return sum;
}

std::uint8_t level_of(double value) {
    return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
}

std::uint8_t level_at(const Image& grey, const Eigen::Vector2d& place) {
    return level_of(cubic_sample(grey, place.x(), place.y()));
}

// A picture's spline about all places of a map, drawn from the border inwards.
class ExactSource {
  public:
    ExactSource(const Image& grey, const Eigen::Vector2d& low, const Eigen::Vector2d& high)
        : last_(grey.width() - 1.0, grey.height() - 1.0), spline_(grey, piece(grey, low, high)) {}

    std::uint8_t level_at(const Eigen::Vector2d& place) const {
        const Eigen::Vector2d inside = place.cwiseMax(0.0).cwiseMin(last_);
        return level_of(spline_.value(inside.x(), inside.y()));
    }

  private:
    Rectangle piece(const Image& grey, const Eigen::Vector2d& low,
                    const Eigen::Vector2d& high) const {
        const Eigen::Vector2i from = low.cwiseMax(0.0).cwiseMin(last_).cast<int>();
        const Eigen::Vector2i to = high.cwiseMax(0.0).cwiseMin(last_).cast<int>();
        return spline_piece({from.x(), from.y(), to.x() - from.x() + 2, to.y() - from.y() + 2},
                            grey);
    }

    Eigen::Vector2d last_;
    CubicSpline spline_;
};

// Where the pixels of a region lie in another picture: exact at every `cell_px`th, linear between,
// which the maps of lenses are over four pixels to a hundredth of a pixel at worst.
class SmoothMap {
  public:
    template <class Exact>
    static std::optional<SmoothMap> made(const Rectangle& region, int cell_px, const Exact& exact) {
        SmoothMap map;
        map.cell_px_ = cell_px;
        map.columns_ = (region.width + cell_px - 2) / cell_px + 1;
        const int rows = (region.height + cell_px - 2) / cell_px + 1;
        map.nodes_.reserve(static_cast<std::size_t>(map.columns_ * rows));
        for (int j = 0; j < rows; ++j) {
            for (int i = 0; i < map.columns_; ++i) {
                const auto node =
                    exact(Eigen::Vector2d(region.x + i * cell_px, region.y + j * cell_px));
                if (!node) {
                    return std::nullopt;
                }
                map.nodes_.push_back(*node);
            }
        }
        return map;
    }

    /// All places are between these, an overhang of the last cells included.
    Eigen::Vector2d low() const {
        Eigen::Vector2d result = nodes_.front();
        for (const Eigen::Vector2d& node : nodes_) {
            result = result.cwiseMin(node);
        }
        return result;
    }
    Eigen::Vector2d high() const {
        Eigen::Vector2d result = nodes_.front();
        for (const Eigen::Vector2d& node : nodes_) {
            result = result.cwiseMax(node);
        }
        return result;
    }

    /// Of the region's pixel (x, y), counted from its first.
    Eigen::Vector2d at(int x, int y) const {
        const int i = std::min(x / cell_px_, std::max(0, columns_ - 2));
        const int rows = static_cast<int>(nodes_.size()) / columns_;
        const int j = std::min(y / cell_px_, std::max(0, rows - 2));
        const double tx = static_cast<double>(x - i * cell_px_) / cell_px_;
        const double ty = static_cast<double>(y - j * cell_px_) / cell_px_;
        const auto node = [&](int di, int dj) -> const Eigen::Vector2d& {
            const int column = std::min(i + di, columns_ - 1);
            return nodes_[static_cast<std::size_t>(std::min(j + dj, rows - 1) * columns_ + column)];
        };
        return (1.0 - ty) * ((1.0 - tx) * node(0, 0) + tx * node(1, 0)) +
               ty * ((1.0 - tx) * node(0, 1) + tx * node(1, 1));
    }

  private:
    int cell_px_ = 1;
    int columns_ = 0;
    std::vector<Eigen::Vector2d> nodes_;
};

// A turn in the plane square to the rig's z axis, and growth.
Eigen::Matrix2d matrix_of(const PlanarChange& change) {
    const double c = change.scale * std::cos(change.turn_rad);
    const double s = change.scale * std::sin(change.turn_rad);
    Eigen::Matrix2d matrix;
    matrix << c, -s, s, c;
    return matrix;
}

struct Plane {
    Eigen::Vector3d point;
    Eigen::Vector2d slope;

    /// Where the camera sees it at `pixel`, from its point.
    std::optional<Eigen::Vector3d> seen_at(const Camera& camera,
                                           const Eigen::Vector2d& pixel) const {
        const auto ray = camera.unproject(pixel);
        const Eigen::Vector3d normal(-slope.x(), -slope.y(), 1.0);
        if (!ray || std::abs(ray->direction.z()) < smallest_cosine ||
            std::abs(ray->direction.dot(normal)) < smallest_cosine) {
            return std::nullopt;
        }
        const double along = (point - ray->origin_mm).dot(normal) / ray->direction.dot(normal);
        return ray->at(along) - point;
    }
};

// From a camera's pixel to the plane; there changed about its point, the height over that point
// with it, carried to `to_point`, and seen by the other camera.
std::optional<Eigen::Vector2d> carried(const Camera& camera, const Eigen::Vector2d& pixel,
                                       const Plane& plane, const Eigen::Matrix2d& change,
                                       const Camera& to_camera, const Eigen::Vector3d& to_point) {
    auto from_point = plane.seen_at(camera, pixel);
    if (!from_point) {
        return std::nullopt;
    }
    from_point->head<2>() = change * from_point->head<2>();
    from_point->z() *= std::sqrt(std::abs(change.determinant()));
    return to_camera.project(to_point + *from_point);
}

bool is_turned(const ReferencePatch& patch) {
    return std::abs(patch.change.turn_rad) > least_turn_rad;
}

// The upright rectangle about the centre that the patch fills: half its width and height in whole
// pixels, the largest one within the patch while it is not turned, then the one about it.
struct Extent {
    Eigen::Vector2i half;
    bool turned = false;  ///< by its own change, or because the cameras are turned
};

std::optional<Extent> extent_at(const ReferencePatch& patch, const Camera& left,
                                const Camera& camera, const Eigen::Vector3d& point,
                                const Eigen::Vector2d& centre) {
    const Plane plane{patch.point_in_rig_mm, patch.slope};
    Eigen::Vector2d half(1e9, 1e9);
    Eigen::Matrix2d halfway = Eigen::Matrix2d::Zero();  // columns: to the right, and to the lower
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            Eigen::Vector2d side = patch.centre_px;
            side[axis] += sign * 0.5 * patch.size_px[axis];
            const auto from_point = plane.seen_at(left, side);
            const auto pixel = from_point ? camera.project(point + patch.change.scale * *from_point)
                                          : std::nullopt;
            if (!pixel) {
                return std::nullopt;
            }
            half[axis] = std::min(half[axis], (*pixel - centre).norm());
            halfway.col(axis) += 0.5 * sign * (*pixel - centre);
        }
    }
    const double own_turn_rad = patch.change.turn_rad;
    const double c = std::cos(own_turn_rad);
    const double s = std::sin(own_turn_rad);
    const double view_turn_rad = std::atan2(halfway(1, 0), halfway(0, 0));
    Extent extent;
    extent.turned = is_turned(patch);
    if (std::abs(view_turn_rad) > least_view_turn_rad) {
        extent.turned = true;
        Eigen::Matrix2d own;
        own << c, -s, s, c;
        half = (halfway * own).cwiseAbs().rowwise().sum();
    } else if (extent.turned) {
        half = Eigen::Vector2d(std::abs(c) * half.x() + std::abs(s) * half.y(),
                               std::abs(s) * half.x() + std::abs(c) * half.y());
    }
    const Eigen::Vector2i whole = (half.array() - 0.49).floor().cast<int>();
    // Never more than twice as large as it was.
    const int longest = std::max(patch.size_px.x(), patch.size_px.y());
    const Eigen::Vector2i most =
        extent.turned ? Eigen::Vector2i(longest, longest) : Eigen::Vector2i(patch.size_px);
    extent.half = whole.cwiseMin(most.cwiseMin((largest_template_px - 1) / 2));
    return extent;
}

// Whether a place of the picture that the patch was cut from belongs to the patch.
bool within(const ReferencePatch& patch, const Eigen::Vector2d& source) {
    const Eigen::Vector2d from = (source - patch.centre_px).cwiseAbs();
    return from.x() <= 0.5 * patch.size_px.x() && from.y() <= 0.5 * patch.size_px.y();
}

}  // namespace

std::optional<Eigen::Vector3d> place_at_depth(const Camera& camera, const Eigen::Vector2d& pixel,
                                              double depth_mm) {
    const auto ray = camera.unproject(pixel);
    if (!ray || ray->direction.z() < least_forward) {
        return std::nullopt;
    }
    return ray->at((depth_mm - ray->origin_mm.z()) / ray->direction.z());
}

Eigen::Vector2d ReferencePatch::slope_now() const {
    return matrix_of({1.0, change.turn_rad}) * slope;
}

std::optional<RenderedPatch> render_patch(const ReferencePatch& patch, const Camera& left,
                                          const Camera& camera,
                                          const Eigen::Vector3d& point_in_rig_mm, int margin,
                                          Drawing drawing) {
    const auto centre = camera.project(point_in_rig_mm);
    if (!centre || !camera.sees(*centre)) {
        return std::nullopt;
    }
    const auto extent = extent_at(patch, left, camera, point_in_rig_mm, *centre);
    if (!extent || extent->half.minCoeff() < 2) {
        return std::nullopt;
    }
    const Eigen::Vector2i half = extent->half;
    const bool turned = extent->turned;
    const Eigen::Vector2i middle(static_cast<int>(std::lround(centre->x())),
                                 static_cast<int>(std::lround(centre->y())));
    RenderedPatch result;
    result.top_left = middle - half;
    result.centre = *centre - result.top_left.cast<double>();
    result.margin = margin;
    result.picture = Image(2 * (half.x() + margin) + 1, 2 * (half.y() + margin) + 1);
    const Eigen::Vector2i first = result.top_left - Eigen::Vector2i(margin, margin);
    const Eigen::Matrix2d back = matrix_of(patch.change).inverse();
    if (turned) {
        result.mask = Image(2 * half.x() + 1, 2 * half.y() + 1);
    }
    const Rectangle region{first.x(), first.y(), result.picture.width(), result.picture.height()};
    const Plane plane_now{point_in_rig_mm, patch.slope_now()};
    const int cell_px = drawing == Drawing::exact ? fine_cell_px : coarse_cell_px;
    const auto sources = SmoothMap::made(region, cell_px, [&](const Eigen::Vector2d& pixel) {
        return carried(camera, pixel, plane_now, back, left, patch.point_in_rig_mm);
    });
    if (!sources) {
        return std::nullopt;
    }
    const Eigen::Vector2d piece_at = patch.piece_at_px.cast<double>();
    std::optional<ExactSource> exact;
    if (drawing == Drawing::exact) {
        exact.emplace(*patch.left_grey, sources->low() - piece_at, sources->high() - piece_at);
    }
    for (int y = 0; y < result.picture.height(); ++y) {
        std::uint8_t* out = result.picture.row(y);
        for (int x = 0; x < result.picture.width(); ++x) {
            const Eigen::Vector2d source = sources->at(x, y);
            if (turned && result.mask.contains(x - margin, y - margin)) {
                result.mask.at(x - margin, y - margin) = within(patch, source) ? 1 : 0;
            }
            out[x] = exact ? exact->level_at(source - piece_at)
                           : level_at(*patch.left_grey, source - piece_at);
        }
    }
    return result;
}

std::optional<Image> drawn_back(const ReferencePatch& patch, const Camera& left, const Image& grey,
                                const Eigen::Vector3d& point_in_rig_mm, const Rectangle& piece) {
    const Eigen::Matrix2d onwards = matrix_of(patch.change);
    const Plane plane{patch.point_in_rig_mm, patch.slope};
    const auto places = SmoothMap::made(piece, fine_cell_px, [&](const Eigen::Vector2d& pixel) {
        return carried(left, pixel, plane, onwards, left, point_in_rig_mm);
    });
    if (!places) {
        return std::nullopt;
    }
    Image result(piece.width, piece.height);
    for (int y = 0; y < piece.height; ++y) {
        for (int x = 0; x < piece.width; ++x) {
            const Eigen::Vector2d now = places->at(x, y);
            if (!left.sees(now)) {
                return std::nullopt;
            }
            result.at(x, y) = level_at(grey, now);
        }
    }
    return result;
}

}  // namespace kambara
