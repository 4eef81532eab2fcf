// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/transform.h"

namespace kambara {

/// What searches have transformed of the latest pictures, so that searches which overlap, of one
/// target or of several, transform nothing twice. Any number of threads may search the pictures of
/// one pair at a time.
class TransformCache {
  public:
    /// Remembers transforms of this picture from here on, and forgets those of all but the four
    /// latest ones. Null is passed over.
    void keep(const ImagePtr& picture);

    /// A picture of the same size whose `region` is transformed (see transform_region); the rest of
    /// it may hold anything. Valid until the picture is forgotten. Null for a picture that is not
    /// kept. The region lies within transformable().
    const Image* transformed(const Image& picture, Transform transform, const Rectangle& region);

    /// How many pixels were transformed since it was made.
    std::int64_t pixels_transformed() const;

  private:
    struct Entry {
        Transform transform = Transform::none;
        Image picture;
        std::vector<bool> done;  // by tiles, row by row
    };
    struct Kept {
        ImagePtr picture;
        std::vector<std::unique_ptr<Entry>> entries;
    };

    Entry& entry(Kept& kept, Transform transform);
    Image& tile(int width, int height, int channels);
    void complete(const Image& picture, Entry& entry, const Rectangle& region);

    mutable std::mutex mutex_;
    std::vector<Kept> kept_;
    std::int64_t pixels_ = 0;
    std::vector<Image> tiles_;
};

}  // namespace kambara
