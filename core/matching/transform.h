// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/kernels/transform_rows.h"

namespace kambara {

/// What is done to a grey picture before it is compared (correspondence: transforms).
enum class Transform {
    none,
    gaussian,  ///< smoothed, sigma 1 px
    rank3,     ///< how many of the 8 neighbours are darker
    rank5,     ///< how many of the 24 neighbours within 2 px are darker
    census,    ///< which of these 24 are darker: a bit each, in 3 channels
    sdog,      ///< 1 where the picture smoothed by 0.8 px is brighter than by 1.6 px, else 0
    gradient,  ///< magnitude of the Sobel gradient, a quarter of it, at most 255
};

/// Reads `none`, `gauss`, `rank3`, `rank5`, `census`, `sdog` or `gradient`.
Result<Transform> parse_transform(std::string_view name);
std::string to_string(Transform transform);

/// How far a pixel's neighbourhood reaches: so much of the picture's border has no transform.
int margin_px(Transform transform);

/// Whether every value is 0 or 1.
constexpr bool is_binary(Transform transform) {
    return transform == Transform::sdog;
}

/// The transform of a region of a picture, which may have 3 channels only for Transform::none. The
/// region keeps the margin's distance from the border: no border is ever invented. `out` is given
/// the region's size. In whole numbers, the same on every processor and by any of the kernels'
/// `rows`.
void transform_region(const Image& picture, const Rectangle& region, Transform transform,
                      Image& out, const TransformRows& rows = transform_rows());

/// The part of a picture that has a transform; empty sides are 0 or less.
Rectangle transformable(const Image& picture, Transform transform);

}  // namespace kambara
