// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/matching/kernels/kernels.h"

namespace kambara {

/// sum(I (T - 128)) over a block of positions through the Fourier transform, for templates so large
/// that this is faster than the kernels. In double precision the result is within 1e-5 of a whole
/// number and rounded to it, so that it equals the kernels' (an error of 2^-53 times a few dozen,
/// of sums below 2^31). Keeps the template's spectrum. One thread.
class SpectralDot {
  public:
    SpectralDot();
    ~SpectralDot();
    SpectralDot(SpectralDot&&) noexcept;
    SpectralDot& operator=(SpectralDot&&) noexcept;

    /// At most 65,793 template pixels, planes included.
    void set_template(const PackedTemplate& templ);

    void dot(const Planes& image, const Block& block, std::int32_t* out);

    /// Whether dot() is likely to take less time than the best kernels' for such a block, by what
    /// both took when this was first asked.
    static bool pays(const PackedTemplate& templ, int columns, int rows);

  private:
    struct Plan;
    Plan& plan_for(int width, int height);
    void make_spectrum(Plan& plan);

    PackedTemplate template_;
    double template_sum_ = 0.0;
    std::uint64_t version_ = 0;
    std::vector<std::unique_ptr<Plan>> plans_;
};

}  // namespace kambara
