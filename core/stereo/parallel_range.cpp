// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stereo/parallel_range.h"

#include <string>

namespace kambara {

Result<double> parallel_range_mm(double baseline_mm, double f_mm, double disparity_px,
                                 double pixel_size_mm) {
    if (!(disparity_px > 0.0)) {
        return Error{
            "The disparity is " + std::to_string(disparity_px) +
                " px: for parallel cameras it must be positive.",
            "Check that left and right are not swapped and that the cameras are parallel."};
    }
    return baseline_mm * f_mm / (disparity_px * pixel_size_mm);
}

}  // namespace kambara
