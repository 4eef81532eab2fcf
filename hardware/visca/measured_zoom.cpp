// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/visca/measured_zoom.h"

#include <cmath>

namespace kambara::visca {
Result<HeadKind> with_measured_zoom(HeadKind kind,
                                    const std::vector<std::pair<double, double>>& curve,
                                    const std::optional<WidestLens>& widest) {
    ZoomModel& zoom = kind.zoom;
    if (widest) {
        zoom.wide_f_mm = widest->f_mm;
        zoom.sensor_width_mm = widest->sensor_width_mm;
    }
    if (!(zoom.wide_f_mm > 0.0 && zoom.sensor_width_mm > 0.0)) {
        return Error{"The lens of the head \"" + kind.name + "\" at its widest is not known.",
                     "Tell its focal length and its sensor's width, mm (--widest F,WIDTH)."};
    }
    zoom.curve.clear();
    for (const auto& [share, magnification] : curve) {
        zoom.curve.emplace_back(std::round(share * zoom.tele), zoom.wide_f_mm * magnification);
    }
    if (!curve.empty() && (curve.back().first >= 1.0 || !(zoom.tele_f_mm > 0.0))) {
        zoom.tele_f_mm = zoom.curve.back().second;
    }
    return kind;
}

}  // namespace kambara::visca
