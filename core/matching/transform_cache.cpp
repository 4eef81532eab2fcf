// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/transform_cache.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

namespace kambara {
namespace {

constexpr std::size_t most_pictures = 4;
constexpr int tile_px = 32;

int tiles(int length_px) {
    return (length_px + tile_px - 1) / tile_px;
}

}  // namespace

void TransformCache::keep(const ImagePtr& picture) {
    const std::lock_guard lock(mutex_);
    const auto same = [&](const Kept& kept) { return kept.picture == picture; };
    if (!picture || std::any_of(kept_.begin(), kept_.end(), same)) {
        return;
    }
    Kept latest{picture, {}};
    if (kept_.size() >= most_pictures) {
        latest.entries = std::move(kept_.front().entries);  // for their memory
        kept_.erase(kept_.begin());
        for (const auto& entry : latest.entries) {
            std::fill(entry->done.begin(), entry->done.end(), false);
        }
    }
    kept_.push_back(std::move(latest));
}

const Image* TransformCache::transformed(const Image& picture, Transform transform,
                                         const Rectangle& region) {
    const std::lock_guard lock(mutex_);
    const auto same = [&](const Kept& kept) { return kept.picture.get() == &picture; };
    const auto kept = std::find_if(kept_.begin(), kept_.end(), same);
    if (kept == kept_.end()) {
        return nullptr;
    }
    Entry& found = entry(*kept, transform);
    complete(picture, found, region);
    return &found.picture;
}

std::int64_t TransformCache::pixels_transformed() const {
    const std::lock_guard lock(mutex_);
    return pixels_;
}

TransformCache::Entry& TransformCache::entry(Kept& kept, Transform transform) {
    const int width = kept.picture->width();
    const int height = kept.picture->height();
    for (const auto& entry : kept.entries) {
        if (entry->transform == transform && entry->picture.width() == width &&
            entry->picture.height() == height) {
            return *entry;
        }
    }
    auto made = std::make_unique<Entry>();
    made->transform = transform;
    made->picture = Image(width, height, transform == Transform::census ? 3 : 1);
    made->done.resize(static_cast<std::size_t>(tiles(width)) *
                      static_cast<std::size_t>(tiles(height)));
    kept.entries.push_back(std::move(made));
    return *kept.entries.back();
}

// Tiles at the borders are smaller: one picture for each size, so that none is made anew.
Image& TransformCache::tile(int width, int height, int channels) {
    const auto same = [&](const Image& one) {
        return one.width() == width && one.height() == height && one.channels() == channels;
    };
    const auto found = std::find_if(tiles_.begin(), tiles_.end(), same);
    return found != tiles_.end() ? *found : tiles_.emplace_back(width, height, channels);
}

void TransformCache::complete(const Image& picture, Entry& entry, const Rectangle& region) {
    const Rectangle all = transformable(picture, entry.transform);
    const int across = tiles(picture.width());
    for (int j = region.y / tile_px; j * tile_px < region.y + region.height; ++j) {
        for (int i = region.x / tile_px; i * tile_px < region.x + region.width; ++i) {
            const auto index = static_cast<std::size_t>(j * across + i);
            if (entry.done[index]) {
                continue;
            }
            entry.done[index] = true;
            const int left = std::max(i * tile_px, all.x);
            const int top = std::max(j * tile_px, all.y);
            const int right = std::min((i + 1) * tile_px, all.x + all.width);
            const int bottom = std::min((j + 1) * tile_px, all.y + all.height);
            Image& part = tile(right - left, bottom - top, entry.picture.channels());
            transform_region(picture, {left, top, right - left, bottom - top}, entry.transform,
                             part);
            for (int y = top; y < bottom; ++y) {
                std::memcpy(entry.picture.row(y) + left * entry.picture.channels(),
                            part.row(y - top), part.row_bytes());
            }
            pixels_ += static_cast<std::int64_t>(right - left) * (bottom - top);
        }
    }
}

}  // namespace kambara
