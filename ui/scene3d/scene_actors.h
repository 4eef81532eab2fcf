// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkSmartPointer.h>

#include <Eigen/Core>
#include <QColor>
#include <optional>

#include "core/base/angles.h"
#include "core/camera/rig.h"

class vtkActor;
class vtkMatrix4x4;
class vtkPolyData;
class vtkRenderer;

namespace kambara::ui {

/// Distances, so many sigma from the mean, that hold 95 % of a normal distribution in space:
/// the square root of the 0.95 quantile of chi-square with three degrees of freedom.
constexpr double sigmas_of_95_percent = 2.7955;

/// The pyramid of a camera's field in the left camera's frame, `depth_mm` deep, its sides along the
/// rays of its corner pixels; turned by the head's angles where there are some.
vtkSmartPointer<vtkPolyData> field_of(const Rig& rig, const Camera& camera, double depth_mm,
                                      const std::optional<HeadAngles>& head);

/// The matrix that makes a unit sphere the ellipsoid of `scale` sigma about a point.
vtkSmartPointer<vtkMatrix4x4> ellipsoid(const Eigen::Vector3d& centre_mm,
                                        const Eigen::Matrix3d& covariance_mm2, double scale);

vtkSmartPointer<vtkActor> lines_actor(vtkPolyData* lines, const QColor& colour, float width);

/// Arcs of equal distance every metre in the plane y = 0, with labels.
void add_range_arcs(vtkRenderer& renderer);

}  // namespace kambara::ui
