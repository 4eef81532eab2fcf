// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/nominal_rig.h"

#include <cmath>

#include "core/base/angles.h"

namespace kambara {
namespace {

Camera camera_at(const TsaiLens& lens, const Eigen::Matrix3d& R_camera_from_rig,
                 const Eigen::Vector3d& centre_in_rig_mm) {
    return {lens, 640, 480, {R_camera_from_rig, -(R_camera_from_rig * centre_in_rig_mm)}};
}

}  // namespace

Rig nominal_rig(Medium medium) {
    const Sensor sensor{0.00635, 0.0074, 768, 640};
    TsaiLens left{2.846366, 0.037709, 337.80, 240.50, 1.030092, sensor};
    TsaiLens right{2.882766, 0.035011, 292.14, 232.18, 1.029990, sensor};
    const TsaiLens pan_tilt{5.4, 0.0, 319.5, 239.5, 1.0, sensor};
    if (medium == Medium::water) {
        left.f_mm = 3.808516;
        left.kappa1_per_mm2 = 0.007852;
        right.f_mm = 3.814817;
        right.kappa1_per_mm2 = 0.007799;
    }
    Rig rig;
    rig.medium = medium;
    rig.left = camera_at(left, rotation_about_y(rad_from_deg(-3.0)), {0, 0, 0});
    rig.right = camera_at(right, rotation_about_y(rad_from_deg(3.0)), {450, 0, 0});
    rig.pan_tilt = camera_at(pan_tilt, rotation_about_x(rad_from_deg(21.0)), {225, -120, 30});
    rig.provenance.method = "nominal";
    return rig;
}

Rig unknown_camera(int width_px, int height_px) {
    const double f_px = 0.5 * width_px / std::tan(rad_from_deg(30.0));
    Rig rig;
    rig.left.lens = BrownLens(f_px, f_px, 0.5 * (width_px - 1), 0.5 * (height_px - 1));
    rig.left.width_px = width_px;
    rig.left.height_px = height_px;
    rig.provenance.method = "not calibrated";
    return rig;
}

}  // namespace kambara
