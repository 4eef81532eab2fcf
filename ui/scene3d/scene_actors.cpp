// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene_actors.h"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr int farthest_arc_m = 4;
constexpr double arc_half_angle_rad = 0.7;
constexpr int arc_steps = 40;

void add_line(vtkCellArray& cells, vtkIdType from, vtkIdType to) {
    const vtkIdType ids[] = {from, to};
    cells.InsertNextCell(2, ids);
}

}  // namespace

vtkSmartPointer<vtkPolyData> field_of(const Rig& rig, const Camera& camera, double depth_mm,
                                      const std::optional<HeadAngles>& head) {
    RigidTransform T_rig_from_camera = camera.T_camera_from_rig.inverse();
    if (head && rig.head) {
        T_rig_from_camera = T_camera_from_rig(*rig.head, *head).inverse();
    } else if (head) {
        T_rig_from_camera.R = T_rig_from_camera.R * rotation_about_y(head->pan_rad) *
                              rotation_about_x(head->tilt_rad);
    }
    const RigidTransform T_left_from_camera = rig.left.T_camera_from_rig * T_rig_from_camera;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    const Eigen::Vector3d eye = T_left_from_camera.t_mm;
    points->InsertNextPoint(eye.data());
    const double right = camera.width_px - 0.5;
    const double bottom = camera.height_px - 0.5;
    const std::array<Eigen::Vector2d, 4> corners{
        {{-0.5, -0.5}, {right, -0.5}, {right, bottom}, {-0.5, bottom}}};
    for (const Eigen::Vector2d& corner : corners) {
        const auto ray = camera.unproject(corner);
        if (!ray) {
            continue;
        }
        const Eigen::Vector3d direction = camera.T_camera_from_rig.R * ray->direction;
        const Eigen::Vector3d place = T_left_from_camera * (direction * (depth_mm / direction.z()));
        const vtkIdType id = points->InsertNextPoint(place.data());
        add_line(*cells, 0, id);
    }
    const vtkIdType count = points->GetNumberOfPoints();
    for (vtkIdType id = 1; id < count; ++id) {
        add_line(*cells, id, id + 1 < count ? id + 1 : 1);
    }
    auto field = vtkSmartPointer<vtkPolyData>::New();
    field->SetPoints(points);
    field->SetLines(cells);
    return field;
}

vtkSmartPointer<vtkMatrix4x4> ellipsoid(const Eigen::Vector3d& centre_mm,
                                        const Eigen::Matrix3d& covariance_mm2, double scale) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance_mm2);
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    for (int column = 0; column < 3; ++column) {
        const double length_mm = scale * std::sqrt(std::max(0.0, axes.eigenvalues()[column]));
        for (int row = 0; row < 3; ++row) {
            matrix->SetElement(row, column, axes.eigenvectors()(row, column) * length_mm);
        }
    }
    for (int row = 0; row < 3; ++row) {
        matrix->SetElement(row, 3, centre_mm[row]);
    }
    return matrix;
}

vtkSmartPointer<vtkActor> lines_actor(vtkPolyData* lines, const QColor& colour, float width) {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(lines);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour.redF(), colour.greenF(), colour.blueF());
    actor->GetProperty()->SetLineWidth(width);
    actor->GetProperty()->LightingOff();
    return actor;
}

void add_range_arcs(vtkRenderer& renderer) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (int metres = 1; metres <= farthest_arc_m; ++metres) {
        const double radius_mm = 1000.0 * metres;
        for (int i = 0; i <= arc_steps; ++i) {
            const double angle = arc_half_angle_rad * (2.0 * i / arc_steps - 1.0);
            const vtkIdType id = points->InsertNextPoint(radius_mm * std::sin(angle), 0.0,
                                                         radius_mm * std::cos(angle));
            if (i > 0) {
                add_line(*cells, id - 1, id);
            }
        }
        vtkNew<vtkBillboardTextActor3D> label;
        label->SetInput((std::to_string(metres) + " m").c_str());
        label->SetPosition(radius_mm * std::sin(arc_half_angle_rad), 0.0,
                           radius_mm * std::cos(arc_half_angle_rad));
        label->GetTextProperty()->SetFontSize(14);
        label->GetTextProperty()->SetColor(theme::faint.redF(), theme::faint.greenF(),
                                           theme::faint.blueF());
        renderer.AddActor(label);
    }
    vtkNew<vtkPolyData> arcs;
    arcs->SetPoints(points);
    arcs->SetLines(cells);
    renderer.AddActor(lines_actor(arcs, theme::line, 1.0F));
}

}  // namespace kambara::ui
