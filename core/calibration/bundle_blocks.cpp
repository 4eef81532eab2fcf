// SPDX-License-Identifier: GPL-3.0-or-later
// Lenses and poses as blocks of numbers, and back.
#include <Eigen/Geometry>

#include "core/calibration/bundle.h"

namespace kambara {

LensBlock block_of(const Lens& lens) {
    if (const auto* brown = std::get_if<BrownLens>(&lens)) {
        return brown->parameters();
    }
    const auto& tsai = std::get<TsaiLens>(lens);
    return {tsai.f_mm, tsai.kappa1_per_mm2, tsai.cx_px, tsai.cy_px, tsai.sx};
}

Lens lens_of(const LensBlock& p, LensModel model, const Sensor& sensor) {
    if (model == LensModel::tsai) {
        return TsaiLens{p[0], p[1], p[2], p[3], p[4], sensor};
    }
    return BrownLens(p[0], p[1], p[2], p[3], {p[4], p[5], p[6], p[7], p[8]});
}

std::vector<std::string> parameter_names(LensModel model) {
    if (model == LensModel::tsai) {
        return {"f_mm", "kappa1_per_mm2", "cx_px", "cy_px", "sx"};
    }
    return {"fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "p1", "p2", "k3"};
}

RigidTransform transform_of(const PoseBlock& pose) {
    const Eigen::Vector3d axis(pose[0], pose[1], pose[2]);
    const double angle = axis.norm();
    RigidTransform T;
    if (angle > 0.0) {
        T.R = Eigen::AngleAxisd(angle, axis / angle).toRotationMatrix();
    }
    T.t_mm = {pose[3], pose[4], pose[5]};
    return T;
}

PoseBlock block_of(const RigidTransform& T) {
    const Eigen::AngleAxisd turn(T.R);
    const Eigen::Vector3d axis = turn.angle() * turn.axis();
    return {axis.x(), axis.y(), axis.z(), T.t_mm.x(), T.t_mm.y(), T.t_mm.z()};
}

}  // namespace kambara
