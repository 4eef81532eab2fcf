// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/temporal_filter.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>

namespace kambara {
namespace {

using Byte = std::uint8_t;
using Rows = std::array<const Byte*, most_temporal_frames>;

// Plain loops over bytes of least and greatest, which the compiler turns into vector code.

void put_in_order(Byte& a, Byte& b) {
    const Byte least = std::min(a, b);
    b = std::max(a, b);
    a = least;
}

Byte median_of_3(Byte a, Byte b, Byte c) {
    put_in_order(a, b);
    return std::max(a, std::min(b, c));
}

// The least and the greatest of four can't be the middle of five.
Byte median_of_5(Byte a, Byte b, Byte c, Byte d, Byte e) {
    put_in_order(a, b);
    put_in_order(c, d);
    return median_of_3(std::max(a, c), std::min(b, d), e);
}

void medians_of_3(const Rows& in, std::size_t size, Byte* out) {
    const Byte *a = in[0], *b = in[1], *c = in[2];
    for (std::size_t i = 0; i < size; ++i) {
        out[i] = median_of_3(a[i], b[i], c[i]);
    }
}

void medians_of_5(const Rows& in, std::size_t size, Byte* out) {
    const Byte *a = in[0], *b = in[1], *c = in[2], *d = in[3], *e = in[4];
    for (std::size_t i = 0; i < size; ++i) {
        out[i] = median_of_5(a[i], b[i], c[i], d[i], e[i]);
    }
}

constexpr std::size_t block_bytes = 64;

// Sorts a block of pixels at a time, all of them at once, down to the middle: each pass carries the
// greatest of the rest to its place.
void medians_of(const Rows& in, int count, std::size_t size, Byte* out) {
    std::array<std::array<Byte, block_bytes>, most_temporal_frames> block{};
    for (std::size_t first = 0; first < size; first += block_bytes) {
        const std::size_t here = std::min(block_bytes, size - first);
        for (std::size_t k = 0; k < static_cast<std::size_t>(count); ++k) {
            std::copy_n(in[k] + first, here, block[k].begin());
        }
        const auto middle = static_cast<std::size_t>(count / 2);
        const std::size_t lower = count % 2 == 0 ? middle - 1 : middle;
        for (auto last = static_cast<std::size_t>(count - 1);
             last >= std::max(lower, std::size_t{1}); --last) {
            for (std::size_t k = 0; k < last; ++k) {
                for (std::size_t i = 0; i < block_bytes; ++i) {
                    put_in_order(block[k][i], block[k + 1][i]);
                }
            }
        }
        for (std::size_t i = 0; i < here; ++i) {
            out[first + i] = static_cast<Byte>((block[lower][i] + block[middle][i] + 1) / 2);
        }
    }
}

// Exact for sums of up to 15 bytes: the reciprocal is too large by less than 15 / 65536.
void divide(const std::uint16_t* sums, std::size_t size, int count, Byte* out) {
    const auto reciprocal = static_cast<std::uint32_t>((65536 + count - 1) / count);
    const auto half = static_cast<std::uint16_t>(count / 2);
    if (count == 1) {
        std::copy_n(sums, size, out);
        return;
    }
    for (std::size_t i = 0; i < size; ++i) {
        const auto sum = static_cast<std::uint16_t>(sums[i] + half);
        out[i] = static_cast<Byte>(sum * reciprocal >> 16U);
    }
}

}  // namespace

Result<TemporalOptions> parse_temporal(std::string_view text) {
    TemporalOptions options;
    const std::string_view kind = text.substr(0, text.find(':'));
    const std::string_view number = kind.size() < text.size() ? text.substr(kind.size() + 1) : "";
    const char* const end = number.data() + number.size();
    const auto [stopped, code] = std::from_chars(number.data(), end, options.frames);
    const bool good = code == std::errc{} && stopped == end && options.frames >= 1 &&
                      options.frames <= most_temporal_frames;
    options.kind = kind == "mean" ? TemporalOptions::Kind::mean : TemporalOptions::Kind::median;
    if (!good || (kind != "mean" && kind != "median")) {
        return Error{"There is no temporal filter \"" + std::string(text) + "\".",
                     "Give median:N or mean:N, with N from 1 to 15 pictures."};
    }
    return options;
}

std::string to_string(const TemporalOptions& options) {
    return (options.kind == TemporalOptions::Kind::mean ? "mean:" : "median:") +
           std::to_string(options.frames);
}

TemporalFilter::TemporalFilter(const TemporalOptions& options) : options_(options) {
    if (options.frames < 1 || options.frames > most_temporal_frames) {
        throw std::invalid_argument("a temporal filter is over 1 to 15 pictures");
    }
}

void TemporalFilter::begin(const Image& picture) {
    size_ = picture.row_bytes() * static_cast<std::size_t>(picture.height());
    history_.resize(size_ * static_cast<std::size_t>(options_.frames));
    if (options_.kind == TemporalOptions::Kind::mean) {
        sums_.resize(size_);
    }
    out_ = Image(picture.width(), picture.height(), picture.channels());
    seen_ = 0;
}

const Image& TemporalFilter::filter(const Image& picture) {
    if (picture.width() != out_.width() || picture.height() != out_.height() ||
        picture.channels() != out_.channels()) {
        begin(picture);
    }
    if (size_ == 0) {
        return out_;
    }
    if (seen_ == 0) {
        next_ = 0;
        std::fill(sums_.begin(), sums_.end(), std::uint16_t{0});
    }
    Byte* const slot = kept(next_);
    const bool full = seen_ == options_.frames;
    const int count = full ? seen_ : seen_ + 1;
    if (options_.kind == TemporalOptions::Kind::mean) {
        take_mean(picture.row(0), full ? slot : nullptr, count);
    }
    std::copy_n(picture.row(0), size_, slot);
    seen_ = count;
    next_ = (next_ + 1) % options_.frames;
    if (options_.kind == TemporalOptions::Kind::median) {
        take_median(count);
    }
    return out_;
}

void TemporalFilter::take_mean(const Byte* newest, const Byte* oldest, int count) {
    std::uint16_t* const sums = sums_.data();
    for (std::size_t i = 0; i < size_; ++i) {
        sums[i] = static_cast<std::uint16_t>(sums[i] + newest[i]);
    }
    for (std::size_t i = 0; i < size_ && oldest != nullptr; ++i) {
        sums[i] = static_cast<std::uint16_t>(sums[i] - oldest[i]);
    }
    divide(sums, size_, count, out_.row(0));
}

void TemporalFilter::take_median(int count) {
    Rows rows{};
    for (int k = 0; k < count; ++k) {
        rows[static_cast<std::size_t>(k)] = kept(k);
    }
    if (count == 3) {
        medians_of_3(rows, size_, out_.row(0));
    } else if (count == 5) {
        medians_of_5(rows, size_, out_.row(0));
    } else {
        medians_of(rows, count, size_, out_.row(0));
    }
}

}  // namespace kambara
