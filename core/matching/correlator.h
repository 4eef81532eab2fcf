// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "core/image/image.h"
#include "core/image/rectangle.h"
#include "core/matching/kernels/kernels.h"
#include "core/matching/measure.h"
#include "core/matching/score_map.h"
#include "core/matching/spectral_dot.h"

namespace kambara {

/// Compares one template with every position of a region, over and over: keeps the template in the
/// form that the kernels read and its working memory, so that nothing is allocated once the largest
/// region has been seen. One thread.
class Correlator {
  public:
    explicit Correlator(const Kernels& kernels = best_kernels());

    /// How products with large templates are made; the result is the same.
    enum class Way { quickest, kernels, spectrum };
    void set_way(Way way) { way_ = way; }

    /// Pictures to come must have the template's number of channels (1 or 3; bit pictures for
    /// Measure::hamming, see transform.h). 3 x 3 to 255 x 255 pixels. With a mask, of the same size
    /// and one channel, only the pixels where it is not 0 count. With a step n, every n-th pixel of
    /// every n-th row counts, the first included (sparse search).
    void set_template(Measure measure, const Image& templ, const Image* mask = nullptr,
                      int step = 1);

    /// The scores over `positions`, clipped to where the template fits wholly inside the picture;
    /// an empty map where it fits nowhere. Bit for bit the same for all kernels.
    void scores(const Image& picture, const Rectangle& positions, ScoreMap& map);

  private:
    void pack_bits(const Image& templ, const Image* mask);
    void pack_levels(const Image& templ, const Image* mask);
    // A part of the region at hand: every step-th pixel of every step-th row from the first.
    void load(const Image& picture, const Rectangle& region, int first_x, int first_y, int columns,
              int rows);
    void load_squares();
    void scan(int columns, int rows, int first_x, int first_y, ScoreMap& map);
    // Strips of rows into the map itself, or, with a step, into a strip that is spread over it.
    template <class T>
    void scan_strips(int columns, int rows, int first_x, int first_y, std::vector<T>& strip,
                     int map_width, std::vector<T>& map);
    void score_sads(const Block& block, int row, std::uint32_t* costs);
    void score_bits(const Block& block, int row, std::uint32_t* costs);
    void score_correlations(const Block& block, int row, float* scores);
    void score_by_products(const Block& block, int row, float* scores);
    void roll_to(int row, int columns);
    void take_padding_off(int row, int padding, int columns, std::uint32_t* costs);
    Planes planes_from(int row) const;

    const Kernels* kernels_;
    Measure measure_ = Measure::zncc;
    int width_ = 0;  // of the template as it is compared, every step-th pixel
    int height_ = 0;
    int channels_ = 1;
    int step_ = 1;
    Way way_ = Way::quickest;
    bool masked_ = false;
    bool by_products_ = false;
    bool spectral_ = false;        // the region at hand is better searched through the spectrum
    bool spectral_known_ = false;  // the template's spectrum is that of this template
    PackedTemplate packed_;
    std::vector<PackedTemplate> of_planes_;  // for correlations by products of single planes
    PackedTemplate inside_;                  // 1 where the mask lets a pixel count
    PackedTemplate outside_;                 // 1 where it does not; padding too, if SAD counts it
    Normalisation normalisation_;
    SpectralDot spectral_dot_;

    Planes planes_;                     // in pixels_
    std::vector<std::uint8_t> pixels_;  // planar, rows with slack
    std::vector<std::uint8_t> squares_low_;
    std::vector<std::uint8_t> squares_high_;
    std::vector<std::int32_t> dots_;
    std::vector<std::uint32_t> costs_;
    std::vector<std::uint32_t> sums_;
    std::vector<std::uint32_t> squares_;
    std::vector<std::uint32_t> column_sums_;
    std::vector<std::uint32_t> column_squares_;
    std::vector<double> wide_;
    std::vector<float> scores_;
};

}  // namespace kambara
