// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/image/image.h"

namespace kambara {

struct TemporalOptions {
    enum class Kind { median, mean };
    Kind kind = Kind::median;
    int frames = 5;  ///< the picture at hand among them

    bool operator==(const TemporalOptions&) const = default;
};

inline constexpr int most_temporal_frames = 15;

/// Reads `median:N` or `mean:N`, N from 1 to 15.
Result<TemporalOptions> parse_temporal(std::string_view text);
std::string to_string(const TemporalOptions& options);

/// Temporal low-pass (correspondence: transforms): the median or the mean, pixel by pixel and
/// channel by channel, over the last pictures of a still camera. Bubbles and particles, which are
/// at one pixel for a picture or two, vanish; so does whatever else moves, and what moves slowly
/// lags. Until there are enough pictures, over those there are. Of an even number the median is the
/// mean of the middle two; means are rounded, halves up. Nothing is allocated after the first
/// pictures. One thread.
class TemporalFilter {
  public:
    explicit TemporalFilter(const TemporalOptions& options = {});

    /// Takes the next picture and gives the filtered one, which stays until the next call. A
    /// picture of another size or number of channels begins anew.
    const Image& filter(const Image& picture);

    /// Forgets the pictures, as after a cut.
    void reset() { seen_ = 0; }

  private:
    std::uint8_t* kept(int slot) {
        return history_.data() + static_cast<std::size_t>(slot) * size_;
    }
    void begin(const Image& picture);
    void take_mean(const std::uint8_t* newest, const std::uint8_t* oldest, int count);
    void take_median(int count);

    const TemporalOptions options_;
    std::size_t size_ = 0;  // bytes of a picture
    int seen_ = 0;          // pictures kept
    int next_ = 0;          // the place of the next one: that of the oldest once all are taken
    std::vector<std::uint8_t> history_;
    std::vector<std::uint16_t> sums_;  // for the mean
    Image out_;
};

}  // namespace kambara
