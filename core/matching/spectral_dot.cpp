// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/matching/spectral_dot.h"

#include <fftw3.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <complex>
#include <mutex>

namespace kambara {
namespace {

constexpr std::size_t most_plans = 8;
constexpr int least_pixels = 400;
constexpr int columns_together = 8;
constexpr double clearly = 0.85;

// Sizes of which the transform is fast: products of 2, 3 and 5.
constexpr std::array widths{64, 80, 96, 128, 160, 192, 240, 256, 320, 384, 400, 480, 512, 576, 640};

// Without those that are slow down columns. Costs as they are beside each other: of a point of a
// column, there and back. FFTW has straight code for 64 and 128; the others take several passes.
struct Height {
    int points;
    double cost;
};
constexpr std::array<Height, 13> heights{{{64, 1.3},
                                          {80, 3.0},
                                          {96, 2.8},
                                          {128, 1.3},
                                          {160, 2.9},
                                          {256, 3.1},
                                          {320, 3.8},
                                          {384, 3.4},
                                          {400, 3.1},
                                          {480, 4.3},
                                          {512, 4.6},
                                          {576, 4.4},
                                          {640, 4.1}}};
constexpr double row_cost = 1.2;             // of a point of a row, one way
constexpr double product_cost = 0.6;         // of a point, with the template's
constexpr double memory_cost = 5.0;          // of a point that has left the cache by the next step
constexpr double most_in_cache = 200'000.0;  // points of a tile

// FFTW plans one at a time, whoever asks.
std::mutex& planning() {
    static std::mutex mutex;
    return mutex;
}

struct Tiling {
    int width = 0;  // of a tile, the template's overlap included
    int height = 0;
    int across = 1;
    int down = 1;
    double work = 0.0;  // cost of all tiles
};

// The tiles, all of one size, that cover the positions with the least work. Rows that hold nothing
// and rows that nobody reads cost nothing.
Tiling tiling_for(int template_width, int template_height, int columns, int rows) {
    Tiling best;
    const auto tiles = [](int positions, int size, int of_template) {
        const int covered = size - of_template + 1;
        return (positions + covered - 1) / covered;
    };
    for (const int width : widths) {
        for (const auto& [height, column_cost] : heights) {
            if (width < template_width || height < template_height) {
                continue;
            }
            Tiling tiling{width, height, tiles(columns, width, template_width),
                          tiles(rows, height, template_height), 0.0};
            const double points = static_cast<double>(width) * height;
            const double lines = 2.0 * rows + tiling.down * (template_height - 1.0);
            tiling.work =
                tiling.across *
                (lines * width * row_cost +
                 tiling.down * points *
                     (column_cost + product_cost + (points > most_in_cache ? memory_cost : 0.0)));
            if (best.work == 0.0 || tiling.work < best.work) {
                best = tiling;
            }
        }
    }
    return best;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

// A transform of two dimensions, as transforms of rows and of columns: rows that hold nothing and
// rows that nobody reads are left out, and the columns go to and fro a few at a time, in the cache.
struct SpectralDot::Plan {
    int width;
    int height;
    int value_stride;           // of `values`, from row to row
    int bin_stride;             // of the spectra, likewise: an odd number of groups of columns
    std::uint64_t version = 0;  // of the template whose spectrum this holds
    double* values;
    fftw_complex* spectrum;
    fftw_complex* product;
    std::vector<std::complex<double>> of_template;  // a spectrum a plane, conjugated
    fftw_plan row_forward;
    fftw_plan row_back;
    fftw_plan columns_forward;
    fftw_plan columns_back;

    Plan(int w, int h)
        : width(w),
          height(h),
          value_stride((w + columns_together - 1) / columns_together * columns_together),
          bin_stride(((w / 2 + columns_together) / columns_together | 1) * columns_together) {
        const std::lock_guard lock(planning());
        values = fftw_alloc_real(static_cast<std::size_t>(value_stride) *
                                 static_cast<std::size_t>(height));
        spectrum = fftw_alloc_complex(bins());
        product = fftw_alloc_complex(bins());
        std::fill_n(&spectrum[0][0], 2 * bins(), 0.0);
        std::fill_n(&product[0][0], 2 * bins(), 0.0);
        row_forward = fftw_plan_dft_r2c_1d(w, values, spectrum, FFTW_ESTIMATE);
        row_back = fftw_plan_dft_c2r_1d(w, product, values, FFTW_ESTIMATE);
        const auto columns = [&](fftw_complex* of, int sign) {
            return fftw_plan_many_dft(1, &height, columns_together, of, nullptr, bin_stride, 1, of,
                                      nullptr, bin_stride, 1, sign, FFTW_ESTIMATE);
        };
        columns_forward = columns(spectrum, FFTW_FORWARD);
        columns_back = columns(product, FFTW_BACKWARD);
    }
    ~Plan() {
        const std::lock_guard lock(planning());
        for (const fftw_plan plan : {row_forward, row_back, columns_forward, columns_back}) {
            fftw_destroy_plan(plan);
        }
        fftw_free(values);
        fftw_free(spectrum);
        fftw_free(product);
    }
    Plan(const Plan&) = delete;
    Plan& operator=(const Plan&) = delete;

    std::size_t points() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    std::size_t bins() const {
        return static_cast<std::size_t>(bin_stride) * static_cast<std::size_t>(height);
    }
    double* value_row(int y) const { return values + y * value_stride; }

    // The first `rows` of `values`, the rest being zeros, along their rows.
    void along_rows(int rows) const {
        for (int y = 0; y < rows; ++y) {
            fftw_execute_dft_r2c(row_forward, value_row(y), spectrum + y * bin_stride);
        }
        std::fill(&spectrum[0][0] + 2 * rows * bin_stride, &spectrum[0][0] + 2 * bins(), 0.0);
    }
    // A group of columns of the spectrum times the template's of this plane, added up.
    void multiply(int first, int plane) const {
        const auto* of_plane = reinterpret_cast<const double*>(
            of_template.data() + bins() * static_cast<std::size_t>(plane));
        best_kernels().multiply_spectra(&spectrum[first][0], of_plane + 2 * first,
                                        {height, columns_together, bin_stride}, plane > 0,
                                        &product[first][0]);
    }
    void down_columns(int plane, bool and_back) const {
        for (int first = 0; first < bin_stride; first += columns_together) {
            fftw_execute_dft(columns_forward, spectrum + first, spectrum + first);
            multiply(first, plane);
            if (and_back) {
                fftw_execute_dft(columns_back, product + first, product + first);
            }
        }
    }
};

SpectralDot::SpectralDot() = default;
SpectralDot::~SpectralDot() = default;
SpectralDot::SpectralDot(SpectralDot&&) noexcept = default;
SpectralDot& SpectralDot::operator=(SpectralDot&&) noexcept = default;

void SpectralDot::set_template(const PackedTemplate& templ) {
    template_ = templ;
    ++version_;
    template_sum_ = 0.0;
    for (const std::int8_t factor : templ.centred) {
        template_sum_ += factor;
    }
}

SpectralDot::Plan& SpectralDot::plan_for(int width, int height) {
    const auto known = std::find_if(plans_.begin(), plans_.end(), [&](const auto& plan) {
        return plan->width == width && plan->height == height;
    });
    if (known != plans_.end()) {
        return **known;
    }
    if (plans_.size() >= most_plans) {
        plans_.erase(plans_.begin());
    }
    plans_.push_back(std::make_unique<Plan>(width, height));
    return *plans_.back();
}

void SpectralDot::make_spectrum(Plan& plan) {
    plan.of_template.resize(plan.bins() * static_cast<std::size_t>(template_.planes));
    for (int plane = 0; plane < template_.planes; ++plane) {
        for (int y = 0; y < template_.height; ++y) {
            double* to = plan.value_row(y);
            std::copy_n(template_.centred.data() + template_.offset(plane, y), template_.width, to);
            std::fill(to + template_.width, to + plan.width, 0.0);
        }
        plan.along_rows(template_.height);
        for (int first = 0; first < plan.bin_stride; first += columns_together) {
            fftw_execute_dft(plan.columns_forward, plan.spectrum + first, plan.spectrum + first);
        }
        auto* to = plan.of_template.data() + plan.bins() * static_cast<std::size_t>(plane);
        for (std::size_t i = 0; i < plan.bins(); ++i) {
            to[i] = {plan.spectrum[i][0], -plan.spectrum[i][1]};
        }
    }
    plan.version = version_;
}

void SpectralDot::dot(const Planes& image, const Block& block, std::int32_t* out) {
    const Tiling tiling = tiling_for(template_.width, template_.height, block.columns, block.rows);
    Plan& plan = plan_for(tiling.width, tiling.height);
    if (plan.version != version_) {
        make_spectrum(plan);
    }
    const int step_x = plan.width - template_.width + 1;
    const int step_y = plan.height - template_.height + 1;
    const double scale = 1.0 / static_cast<double>(plan.points());
    const double middle = 128.0 * template_sum_;  // taken from the pixels, put back into the sums
    for (int top = 0; top < block.rows; top += step_y) {
        for (int left = 0; left < block.columns; left += step_x) {
            const int columns = std::min(step_x, block.columns - left);
            const int rows = std::min(step_y, block.rows - top);
            const int bytes = columns + template_.width - 1;
            const int lines = rows + template_.height - 1;
            for (int plane = 0; plane < template_.planes; ++plane) {
                for (int y = 0; y < lines; ++y) {
                    double* to = plan.value_row(y);
                    const std::uint8_t* from =
                        image.pixels + plane * image.plane_stride + (top + y) * image.stride + left;
                    best_kernels().centred_values(from, bytes, to);
                    std::fill(to + bytes, to + plan.width, 0.0);
                }
                plan.along_rows(lines);
                plan.down_columns(plane, plane + 1 == template_.planes);
            }
            for (int y = 0; y < rows; ++y) {
                double* from = plan.value_row(y);
                fftw_execute_dft_c2r(plan.row_back, plan.product + y * plan.bin_stride, from);
                best_kernels().whole_numbers(from, columns, scale, middle,
                                             out + (top + y) * block.stride + left);
            }
        }
    }
}

bool SpectralDot::pays(const PackedTemplate& templ, int columns, int rows) {
    if (templ.width * templ.height < least_pixels) {
        return false;  // on no processor
    }
    const auto direct_work = [](const PackedTemplate& t, int across, int down) {
        return static_cast<double>(t.padded_width) * t.height * t.planes * whole_groups(across) *
               down;
    };
    // Seconds per unit of work, of the best kernels and of the transform.
    struct Rates {
        double direct;
        double spectral;
    };
    static const Rates rates = [&] {
        constexpr int size = 256;
        PackedTemplate trial;
        trial.width = 32;
        trial.height = 32;
        trial.padded_width = 32;
        trial.bytes.assign(32 * 32 + kernel_template_slack, 90);
        trial.centre();
        const std::vector<std::uint8_t> pixels(size * 512 + kernel_row_slack, 77);
        const Planes planes{pixels.data(), 512, 0};
        const Block block{192, 64, 192};
        std::vector<std::int32_t> out(192 * 192);
        SpectralDot spectral;
        spectral.set_template(trial);
        Rates found{1e9, 1e9};
        for (int i = 0; i < 5; ++i) {
            auto start = std::chrono::steady_clock::now();
            best_kernels().dot(planes, trial, block, out.data());
            found.direct =
                std::min(found.direct, seconds_since(start) / direct_work(trial, 192, 64));
            start = std::chrono::steady_clock::now();
            spectral.dot(planes, {192, 192, 192}, out.data());
            found.spectral =
                std::min(found.spectral, seconds_since(start) / tiling_for(32, 32, 192, 192).work);
        }
        return found;
    }();
    const double planes_and_back = 0.5 * (templ.planes + 1);
    const double spectral = rates.spectral * planes_and_back *
                            tiling_for(templ.width, templ.height, columns, rows).work;
    return spectral < clearly * rates.direct * direct_work(templ, columns, rows);
}

}  // namespace kambara
