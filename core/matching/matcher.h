// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/correlator.h"
#include "core/matching/match_method.h"
#include "core/matching/score_map.h"
#include "core/matching/transform_cache.h"

namespace kambara {

/// Looks for a template in pictures by one method: transforms both, where the search looks and
/// nowhere else, and compares. Grey pictures for every method; colour ones where nothing is
/// transformed. Keeps its working memory. One thread.
class Matcher {
  public:
    explicit Matcher(const MatchMethod& method = {}, const Kernels& kernels = best_kernels());

    const MatchMethod& method() const { return method_; }

    /// `picture` holds the template at `rectangle`, and about it the pixels that the transform
    /// needs: margin() on each side. The mask, of the rectangle's size, is 0 where a pixel does not
    /// count; null where all do.
    void set_template(const Image& picture, const Rectangle& rectangle,
                      const Image* mask = nullptr);
    int margin() const { return margin_px(method_.transform); }
    int width() const { return width_; }  ///< of the template
    int height() const { return height_; }

    /// The scores over `positions` of the template's top-left pixel, clipped to where the template
    /// and what its transform needs lie inside the picture. With a cache that keeps the picture,
    /// nothing of it is transformed twice.
    void scores(const Image& picture, const Rectangle& positions, ScoreMap& map,
                TransformCache* cache = nullptr);

    /// The cost that means no likeness at all; 1 for correlations. What quality() is measured by.
    double unlike() const { return unlike_; }

    /// A score as the normalised quality in [0, 1], 1 for a perfect match: correlations themselves
    /// (negative ones give 0); costs as 1 - cost / unlike().
    double quality(double score) const;

  private:
    MatchMethod method_;
    const TransformRows* rows_;
    Correlator correlator_;
    Image template_;
    Image region_;
    int width_ = 0;
    int height_ = 0;
    double unlike_ = 1.0;
};

}  // namespace kambara
