// SPDX-License-Identifier: GPL-3.0-or-later
// A search allocates nothing once it has seen a picture: a program of its own, since it counts what
// is asked of operator new.
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <new>
#include <random>
#include <vector>

#include "core/matching/matcher.h"
#include "core/matching/peak.h"
#include "core/matching/transform_cache.h"

namespace {

thread_local long allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
    ++allocations;
    void* place = alignment == 0 ? std::malloc(size)
                                 : std::aligned_alloc(
                                       alignment, (size + alignment - 1) / alignment * alignment);
    if (place == nullptr) {
        throw std::bad_alloc();
    }
    return place;
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(size, 0);
}
void* operator new[](std::size_t size) {
    return counted(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* place) noexcept {
    std::free(place);
}
void operator delete[](void* place) noexcept {
    std::free(place);
}
void operator delete(void* place, std::size_t) noexcept {
    std::free(place);
}
void operator delete[](void* place, std::size_t) noexcept {
    std::free(place);
}
void operator delete(void* place, std::align_val_t) noexcept {
    std::free(place);
}
void operator delete[](void* place, std::align_val_t) noexcept {
    std::free(place);
}
void operator delete(void* place, std::size_t, std::align_val_t) noexcept {
    std::free(place);
}
void operator delete[](void* place, std::size_t, std::align_val_t) noexcept {
    std::free(place);
}

namespace kambara {
namespace {

Image random_picture(int width, int height, int channels, std::uint32_t seed) {
    std::mt19937 random(seed);
    Image picture(width, height, channels);
    for (int y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < picture.row_bytes(); ++x) {
            picture.row(y)[x] = static_cast<std::uint8_t>(random() & 0xFFU);
        }
    }
    return picture;
}

// What a search of a picture asks of the heap when it has searched two like it.
long asked_by(const MatchMethod& method, int size, int channels, TransformCache* cache) {
    std::vector<ImagePtr> pictures;
    for (std::uint32_t i = 0; i < 6; ++i) {
        pictures.push_back(std::make_shared<const Image>(random_picture(320, 240, channels, i)));
    }
    Matcher matcher(method);
    matcher.set_template(*pictures[0], {60, 50, size, size});
    ScoreMap map;
    long before = 0;
    for (std::size_t i = 0; i < pictures.size(); ++i) {
        // The cache keeps four pictures and then goes on with the memory of the oldest.
        if (cache != nullptr) {
            cache->keep(pictures[i]);
        }
        before = allocations;
        matcher.scores(*pictures[i], {0, 0, 320, 240}, map, cache);
        const auto peak = best_peak(map, method.measure);
        EXPECT_TRUE(peak);
        static_cast<void>(runner_up(map, method.measure, *peak, 5));
    }
    return allocations - before;
}

TEST(Allocation, CountsWhatIsAllocated) {
    const long before = allocations;
    const auto one = std::make_unique<std::vector<int>>(100);
    EXPECT_EQ(allocations - before, 2);
}

TEST(Allocation, ASearchAllocatesNothingAfterTheFirstPictures) {
    for (const char* measure : {"sad", "ncc", "zncc", "hamming"}) {
        for (const char* transform :
             {"none", "gauss", "rank3", "rank5", "sdog", "census", "gradient"}) {
            const auto method = parse_method(measure, transform);
            for (const int size : {7, 14, 31, 127}) {
                for (const int step : {1, 2}) {
                    if (method) {
                        MatchMethod sparse = *method;
                        sparse.step = step;
                        EXPECT_EQ(asked_by(sparse, size, 1, nullptr), 0)
                            << measure << " " << transform << " " << size << " step " << step;
                    }
                }
            }
        }
    }
    for (const Measure measure : {Measure::sad, Measure::ncc, Measure::zncc}) {
        EXPECT_EQ(asked_by({measure, Transform::none, 1}, 31, 3, nullptr), 0);
    }
}

TEST(Allocation, NorDoesOneWithACache) {
    for (const Transform transform : {Transform::gaussian, Transform::rank3, Transform::sdog}) {
        TransformCache cache;
        EXPECT_EQ(asked_by({Measure::zncc, transform, 1}, 31, 1, &cache), 0);
    }
}

}  // namespace
}  // namespace kambara
