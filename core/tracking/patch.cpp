// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/patch.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/matching/score_map.h"

namespace kambara {
namespace {

constexpr double smallest_cosine = 0.05;  // rays along the plane hit it nowhere useful
constexpr double least_forward = 0.02;    // of a ray's direction, to meet a plane before the rig
constexpr double least_turn_rad = 0.03;   // a patch turned by less is drawn in full, unmasked

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

std::uint8_t level_at(const Image& grey, const Eigen::Vector2d& place) {
    const double value = cubic_sample(grey, place.x(), place.y());
    return static_cast<std::uint8_t>(std::clamp(value + 0.5, 0.0, 255.0));
}

// Where the pixels of a region lie in another picture: exact at every fourth, linear between, which
// the maps of lenses are to a hundredth of a pixel at worst.
class SmoothMap {
  public:
    template <class Exact>
    static std::optional<SmoothMap> made(const Rectangle& region, const Exact& exact) {
        SmoothMap map;
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

    /// Of the region's pixel (x, y), counted from its first.
    Eigen::Vector2d at(int x, int y) const {
        const int i = std::min(x / cell_px, std::max(0, columns_ - 2));
        const int rows = static_cast<int>(nodes_.size()) / columns_;
        const int j = std::min(y / cell_px, std::max(0, rows - 2));
        const double tx = static_cast<double>(x - i * cell_px) / cell_px;
        const double ty = static_cast<double>(y - j * cell_px) / cell_px;
        const auto node = [&](int di, int dj) -> const Eigen::Vector2d& {
            const int column = std::min(i + di, columns_ - 1);
            return nodes_[static_cast<std::size_t>(std::min(j + dj, rows - 1) * columns_ + column)];
        };
        return (1.0 - ty) * ((1.0 - tx) * node(0, 0) + tx * node(1, 0)) +
               ty * ((1.0 - tx) * node(0, 1) + tx * node(1, 1));
    }

  private:
    static constexpr int cell_px = 4;

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

// From a camera's pixel to the plane through `point`, square to the rig's z axis; there changed
// about that point, carried to the plane through `to_point`, and seen by the other camera.
std::optional<Eigen::Vector2d> carried(const Camera& camera, const Eigen::Vector2d& pixel,
                                       const Eigen::Vector3d& point, const Eigen::Matrix2d& change,
                                       const Camera& to_camera, const Eigen::Vector3d& to_point) {
    const auto ray = camera.unproject(pixel);
    if (!ray || std::abs(ray->direction.z()) < smallest_cosine) {
        return std::nullopt;
    }
    const double along = (point.z() - ray->origin_mm.z()) / ray->direction.z();
    Eigen::Vector3d from_point = ray->at(along) - point;
    from_point.head<2>() = change * from_point.head<2>();
    return to_camera.project(to_point + from_point);
}

bool is_turned(const ReferencePatch& patch) {
    return std::abs(patch.change.turn_rad) > least_turn_rad;
}

// Half width and half height, in whole pixels, of the upright rectangle about the centre that the
// patch fills: the largest one within it while it is not turned, then the one about it.
std::optional<Eigen::Vector2i> half_size_at(const ReferencePatch& patch, const Camera& left,
                                            const Camera& camera, const Eigen::Vector3d& point,
                                            const Eigen::Vector2d& centre) {
    Eigen::Vector2d half(1e9, 1e9);
    for (int axis = 0; axis < 2; ++axis) {
        for (const double sign : {-1.0, 1.0}) {
            Eigen::Vector2d side = patch.centre_px;
            side[axis] += sign * 0.5 * patch.size_px[axis];
            const auto ray = left.unproject(side);
            if (!ray || std::abs(ray->direction.z()) < smallest_cosine) {
                return std::nullopt;
            }
            const double along =
                (patch.point_in_rig_mm.z() - ray->origin_mm.z()) / ray->direction.z();
            const Eigen::Vector3d from_point =
                patch.change.scale * (ray->at(along) - patch.point_in_rig_mm);
            const auto pixel = camera.project(point + from_point);
            if (!pixel) {
                return std::nullopt;
            }
            half[axis] = std::min(half[axis], (*pixel - centre).norm());
        }
    }
    if (is_turned(patch)) {
        const double c = std::abs(std::cos(patch.change.turn_rad));
        const double s = std::abs(std::sin(patch.change.turn_rad));
        half = Eigen::Vector2d(c * half.x() + s * half.y(), s * half.x() + c * half.y());
    }
    const Eigen::Vector2i whole = (half.array() - 0.49).floor().cast<int>();
    // Never more than twice as large as it was.
    const int longest = std::max(patch.size_px.x(), patch.size_px.y());
    const Eigen::Vector2i most =
        is_turned(patch) ? Eigen::Vector2i(longest, longest) : Eigen::Vector2i(patch.size_px);
    return whole.cwiseMin(most.cwiseMin((largest_template_px - 1) / 2));
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

std::optional<RenderedPatch> render_patch(const ReferencePatch& patch, const Camera& left,
                                          const Camera& camera,
                                          const Eigen::Vector3d& point_in_rig_mm, int margin) {
    const auto centre = camera.project(point_in_rig_mm);
    if (!centre || !camera.sees(*centre)) {
        return std::nullopt;
    }
    const auto half = half_size_at(patch, left, camera, point_in_rig_mm, *centre);
    if (!half || half->minCoeff() < 2) {
        return std::nullopt;
    }
    const Eigen::Vector2i middle(static_cast<int>(std::lround(centre->x())),
                                 static_cast<int>(std::lround(centre->y())));
    RenderedPatch result;
    result.top_left = middle - *half;
    result.centre = *centre - result.top_left.cast<double>();
    result.margin = margin;
    result.picture = Image(2 * (half->x() + margin) + 1, 2 * (half->y() + margin) + 1);
    const Eigen::Vector2i first = result.top_left - Eigen::Vector2i(margin, margin);
    const Eigen::Matrix2d back = matrix_of(patch.change).inverse();
    const bool turned = is_turned(patch);
    if (turned) {
        result.mask = Image(2 * half->x() + 1, 2 * half->y() + 1);
    }
    const Rectangle region{first.x(), first.y(), result.picture.width(), result.picture.height()};
    const auto sources = SmoothMap::made(region, [&](const Eigen::Vector2d& pixel) {
        return carried(camera, pixel, point_in_rig_mm, back, left, patch.point_in_rig_mm);
    });
    if (!sources) {
        return std::nullopt;
    }
    const Eigen::Vector2d piece_at = patch.piece_at_px.cast<double>();
    for (int y = 0; y < result.picture.height(); ++y) {
        std::uint8_t* out = result.picture.row(y);
        for (int x = 0; x < result.picture.width(); ++x) {
            const Eigen::Vector2d source = sources->at(x, y);
            if (turned && result.mask.contains(x - margin, y - margin)) {
                result.mask.at(x - margin, y - margin) = within(patch, source) ? 1 : 0;
            }
            out[x] = level_at(*patch.left_grey, source - piece_at);
        }
    }
    return result;
}

std::optional<Image> drawn_back(const ReferencePatch& patch, const Camera& left, const Image& grey,
                                const Eigen::Vector3d& point_in_rig_mm, const Rectangle& piece) {
    const Eigen::Matrix2d onwards = matrix_of(patch.change);
    const auto places = SmoothMap::made(piece, [&](const Eigen::Vector2d& pixel) {
        return carried(left, pixel, patch.point_in_rig_mm, onwards, left, point_in_rig_mm);
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
