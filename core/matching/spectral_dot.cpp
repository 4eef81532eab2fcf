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

// Sizes of which the transform is fast: products of 2, 3 and 5.
constexpr std::array sizes{64, 80, 96, 128, 160, 192, 240, 256, 320, 384, 400, 480, 512, 576, 640};

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
    double work = 0.0;  // points times the logarithm of their number, over all tiles
};

// The tiles, all of one size, that cover the positions with the least work.
Tiling tiling_for(int template_width, int template_height, int columns, int rows) {
    Tiling best;
    for (const int width : sizes) {
        for (const int height : sizes) {
            if (width < template_width || height < template_height) {
                continue;
            }
            const auto tiles = [](int positions, int size, int of_template) {
                const int covered = size - of_template + 1;
                return (positions + covered - 1) / covered;
            };
            Tiling tiling{width, height, tiles(columns, width, template_width),
                          tiles(rows, height, template_height), 0.0};
            const double points = static_cast<double>(width) * height;
            tiling.work = tiling.across * tiling.down * points * std::log2(points);
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

struct SpectralDot::Plan {
    int width;
    int height;
    std::uint64_t version = 0;  // of the template whose spectrum this holds
    double* values;
    fftw_complex* spectrum;
    fftw_complex* product;
    std::vector<std::complex<double>> of_template;  // a spectrum a plane, conjugated
    fftw_plan forward;
    fftw_plan back;

    Plan(int w, int h) : width(w), height(h) {
        const std::lock_guard lock(planning());
        values = fftw_alloc_real(points());
        spectrum = fftw_alloc_complex(bins());
        product = fftw_alloc_complex(bins());
        forward = fftw_plan_dft_r2c_2d(h, w, values, spectrum, FFTW_ESTIMATE);
        back = fftw_plan_dft_c2r_2d(h, w, product, values, FFTW_ESTIMATE);
    }
    ~Plan() {
        const std::lock_guard lock(planning());
        fftw_destroy_plan(forward);
        fftw_destroy_plan(back);
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
        return static_cast<std::size_t>(width / 2 + 1) * static_cast<std::size_t>(height);
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
        std::fill_n(plan.values, plan.points(), 0.0);
        for (int y = 0; y < template_.height; ++y) {
            std::copy_n(template_.centred.data() + template_.offset(plane, y), template_.width,
                        plan.values + y * plan.width);
        }
        fftw_execute(plan.forward);
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
            std::fill_n(&plan.product[0][0], 2 * plan.bins(), 0.0);
            for (int plane = 0; plane < template_.planes; ++plane) {
                const int bytes = columns + template_.width - 1;
                for (int y = 0; y < plan.height; ++y) {
                    double* to = plan.values + y * plan.width;
                    const int used = y < rows + template_.height - 1 ? bytes : 0;
                    const std::uint8_t* from =
                        image.pixels + plane * image.plane_stride + (top + y) * image.stride + left;
                    for (int x = 0; x < used; ++x) {
                        to[x] = from[x] - 128;
                    }
                    std::fill(to + used, to + plan.width, 0.0);
                }
                fftw_execute(plan.forward);
                const double* a = &plan.spectrum[0][0];
                const auto* b = reinterpret_cast<const double*>(
                    plan.of_template.data() + plan.bins() * static_cast<std::size_t>(plane));
                double* sum = &plan.product[0][0];
                for (std::size_t i = 0; i < 2 * plan.bins(); i += 2) {
                    sum[i] += a[i] * b[i] - a[i + 1] * b[i + 1];
                    sum[i + 1] += a[i] * b[i + 1] + a[i + 1] * b[i];
                }
            }
            fftw_execute(plan.back);
            for (int y = 0; y < rows; ++y) {
                const double* from = plan.values + y * plan.width;
                std::int32_t* to = out + (top + y) * block.stride + left;
                for (int x = 0; x < columns; ++x) {
                    to[x] = static_cast<std::int32_t>(std::nearbyint(from[x] * scale + middle));
                }
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
    return spectral < rates.direct * direct_work(templ, columns, rows);
}

}  // namespace kambara
