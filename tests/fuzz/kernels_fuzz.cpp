// SPDX-License-Identifier: GPL-3.0-or-later
// Any picture, template, mask and step: every vector unit's kernels, and the way through the
// spectrum, against the plain loops, to the last bit.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/matching/correlator.h"

namespace {

using namespace kambara;

// Takes bytes from the front; 0 when there are no more.
class Bytes {
  public:
    Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
    std::uint8_t next() {
        if (size_ == 0) {
            return 0;
        }
        --size_;
        return *data_++;
    }
    int up_to(int most) { return 1 + next() % most; }

    // The rest over and over, turned a little each time so that rows differ.
    void fill(Image& image, bool binary) {
        std::size_t at = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (std::size_t i = 0; i < image.row_bytes(); ++i) {
                std::uint8_t value = size_ > 0 ? data_[at % size_] : std::uint8_t{0};
                value = static_cast<std::uint8_t>(value + (size_ > 0 ? at / size_ * 7 : 0));
                image.row(y)[i] = binary ? value & 1U : value;
                ++at;
            }
        }
    }

  private:
    const std::uint8_t* data_;
    std::size_t size_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(data, size);
    constexpr Measure measures[] = {Measure::sad, Measure::ncc, Measure::zncc, Measure::hamming};
    const Measure measure = measures[bytes.next() % 4];
    const int channels = bytes.next() % 2 == 0 ? 1 : 3;
    const int width = bytes.up_to(40);
    const int height = bytes.up_to(40);
    const int step = bytes.up_to(3);
    const bool masked = bytes.next() % 3 == 0;
    const bool binary = measure == Measure::hamming && channels == 1;
    Image templ(width, height, channels);
    Image picture(width + bytes.up_to(150), height + bytes.up_to(30), channels);
    Image mask(width, height, 1);
    bytes.fill(mask, true);
    bytes.next();
    bytes.fill(picture, binary);
    bytes.next();
    bytes.fill(templ, binary);
    ScoreMap expected;
    bool first = true;
    for (const Kernels& kernels : runnable_kernels()) {
        for (const auto way : {Correlator::Way::kernels, Correlator::Way::spectrum}) {
            Correlator correlator(kernels);
            correlator.set_way(way);
            correlator.set_template(measure, templ, masked ? &mask : nullptr, step);
            ScoreMap map;
            correlator.scores(picture, {0, 0, 1000, 1000}, map);
            if (first) {
                expected = map;
                first = false;
            } else if (map.positions != expected.positions || map.costs != expected.costs ||
                       map.scores != expected.scores) {
                std::abort();
            }
        }
    }
    return 0;
}
