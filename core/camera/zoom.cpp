// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/zoom.h"

namespace kambara {
namespace {

TsaiLens zoomed_model(TsaiLens lens, double factor) {
    lens.f_mm *= factor;
    return lens;
}

BrownLens zoomed_model(const BrownLens& lens, double factor) {
    return {factor * lens.fx_px(), factor * lens.fy_px(), lens.cx_px(), lens.cy_px(),
            lens.distortion()};
}

}  // namespace

Lens zoomed(const Lens& lens, double factor) {
    return std::visit([&](const auto& model) { return Lens(zoomed_model(model, factor)); }, lens);
}

}  // namespace kambara
