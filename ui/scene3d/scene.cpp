// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene.h"

#include <QVTKOpenGLStereoWidget.h>
#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCoordinate.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <QCoreApplication>
#include <QFile>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <vector>

#include "ui/base/theme.h"
#include "ui/scene3d/scene_actors.h"

namespace kambara::ui {
namespace {

constexpr std::size_t most_trail_points = 3000;
constexpr double field_depth_mm = 300.0;
constexpr double faintest = 0.25;  // the trail's oldest end
// The ellipsoid is of millimetres in a scene of metres: it is drawn larger, by the first of these
// that leaves it this small beside the range.
constexpr std::array magnifications{50, 20, 10, 5, 2, 1};
constexpr double most_share_of_range = 0.15;
const Eigen::Vector3d first_focus_mm(0.0, 0.0, 1200.0);

int magnification_of(const Position& position) {
    const double longest_mm =
        sigmas_of_95_percent * std::sqrt(std::max(0.0, position.covariance_mm2.trace()));
    const double room_mm = most_share_of_range * position.point_in_left_mm.norm();
    const auto* fits = std::find_if(magnifications.begin(), magnifications.end(),
                                    [&](int times) { return times * longest_mm <= room_mm; });
    return fits == magnifications.end() ? 1 : *fits;
}

class VtkScene final : public Scene {
  public:
    explicit VtkScene(QWidget* parent) : widget_(new QVTKOpenGLStereoWidget(parent)) {
        widget_->setRenderWindow(window_.Get());
        widget_->setMinimumSize(160, 120);
        window_->SetMultiSamples(0);
        window_->AddRenderer(renderer_);
        vtkNew<vtkInteractorStyleTrackballCamera> style;
        window_->GetInteractor()->SetInteractorStyle(style);
        renderer_->SetBackground(0.07, 0.08, 0.095);
        add_range_arcs(*renderer_);
        add_trail();
        add_target();
        add_note();
        look_from(ScenePreset::behind);
    }

    QWidget* widget() override { return widget_; }

    void set_rig(const Rig& rig) override {
        rig_ = rig;
        for (const auto& actor : fields_) {
            renderer_->RemoveActor(actor);
        }
        fields_.clear();
        remove_pan_tilt_field();
        add_field(rig.left, theme::good);
        if (rig.right) {
            add_field(*rig.right, theme::epipolar);
        }
        turn_head({});
    }

    void add(const Snapshot& snapshot) override {
        if (snapshot.head && head_ != snapshot.head->axes) {
            head_ = snapshot.head->axes;
            head_turned_ = true;
        }
        const auto position = steered_estimate(snapshot).position;
        if (snapshot.steered_target != trail_target_) {
            trail_target_ = snapshot.steered_target;
            broken_ = true;
        }
        in_sight_ = position.has_value();
        if (!position) {
            broken_ = true;
            return;
        }
        newest_ = *position;
        if (!trail_.empty() && trail_.back().point_mm == position->point_in_left_mm) {
            return;
        }
        trail_.push_back({position->point_in_left_mm, !broken_ && !trail_.empty()});
        broken_ = false;
        if (trail_.size() > most_trail_points) {
            trail_.pop_front();
            trail_.front().joined = false;
        }
    }

    void clear_trail() override {
        trail_.clear();
        broken_ = true;
    }

    void look_from(ScenePreset preset) override {
        const Eigen::Vector3d focus = in_sight_ ? newest_.point_in_left_mm : first_focus_mm;
        Eigen::Vector3d eye(-900.0, -1100.0, -1900.0);
        Eigen::Vector3d up(0.0, -1.0, 0.0);
        if (preset == ScenePreset::above) {
            eye = focus + Eigen::Vector3d(0.0, -4200.0, -1.0);
            up = Eigen::Vector3d(0.0, 0.0, 1.0);
        } else if (preset == ScenePreset::side) {
            eye = focus + Eigen::Vector3d(4200.0, -300.0, 0.0);
        }
        vtkCamera* camera = renderer_->GetActiveCamera();
        camera->SetFocalPoint(focus.data());
        camera->SetPosition(eye.data());
        camera->SetViewUp(up.data());
        renderer_->ResetCameraClippingRange();
    }

    void follow(bool follows) override { follows_ = follows; }

    void render() override {
        if (head_turned_) {
            turn_head(head_);
            head_turned_ = false;
        }
        draw_trail();
        target_->SetVisibility(in_sight_ ? 1 : 0);
        spread_->SetVisibility(in_sight_ ? 1 : 0);
        if (in_sight_) {
            target_->SetPosition(newest_.point_in_left_mm.x(), newest_.point_in_left_mm.y(),
                                 newest_.point_in_left_mm.z());
            const int times = magnification_of(newest_);
            spread_->SetUserMatrix(ellipsoid(newest_.point_in_left_mm, newest_.covariance_mm2,
                                             times * sigmas_of_95_percent));
            write_note(times);
            if (follows_) {
                centre_on(newest_.point_in_left_mm);
            }
        }
        renderer_->ResetCameraClippingRange();
        window_->Render();
    }

    bool save_png(const QString& file) override {
        render();
        vtkNew<vtkWindowToImageFilter> shot;
        shot->SetInput(window_);
        shot->ReadFrontBufferOff();
        vtkNew<vtkPNGWriter> writer;
        writer->SetInputConnection(shot->GetOutputPort());
        writer->SetFileName(QFile::encodeName(file).constData());
        writer->Write();
        return writer->GetErrorCode() == 0 && QFile::exists(file);
    }

    int trail_points() const override { return static_cast<int>(trail_.size()); }

  private:
    struct TrailPoint {
        Eigen::Vector3d point_mm;
        bool joined;  // to the one before
    };

    void add_field(const Camera& camera, const QColor& colour) {
        fields_.push_back(
            lines_actor(field_of(rig_, camera, field_depth_mm, std::nullopt), colour, 1.5F));
        renderer_->AddActor(fields_.back());
    }

    void turn_head(const HeadAngles& angles) {
        if (!rig_.pan_tilt) {
            return;
        }
        remove_pan_tilt_field();
        pan_tilt_field_ = lines_actor(field_of(rig_, *rig_.pan_tilt, field_depth_mm, angles),
                                      theme::caution, 1.5F);
        renderer_->AddActor(pan_tilt_field_);
    }

    void remove_pan_tilt_field() {
        if (pan_tilt_field_) {
            renderer_->RemoveActor(pan_tilt_field_);
            pan_tilt_field_ = nullptr;
        }
    }

    void add_trail() { renderer_->AddActor(lines_actor(trail_data_, theme::accent, 2.0F)); }

    void add_target() {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetRadius(1.0);
        sphere->SetThetaResolution(24);
        sphere->SetPhiResolution(16);
        for (vtkActor* actor : {target_.Get(), spread_.Get()}) {
            vtkNew<vtkPolyDataMapper> mapper;
            mapper->SetInputConnection(sphere->GetOutputPort());
            actor->SetMapper(mapper);
            actor->GetProperty()->LightingOff();
            actor->SetVisibility(0);
            renderer_->AddActor(actor);
        }
        target_->SetScale(12.0);
        target_->GetProperty()->SetColor(1.0, 1.0, 1.0);
        spread_->GetProperty()->SetColor(theme::good.redF(), theme::good.greenF(),
                                         theme::good.blueF());
        spread_->GetProperty()->SetOpacity(0.5);
    }

    void add_note() {
        write_note(magnifications.front());
        note_->GetTextProperty()->SetFontSize(11);
        note_->GetTextProperty()->SetVerticalJustificationToTop();
        note_->GetTextProperty()->SetColor(theme::faint.redF(), theme::faint.greenF(),
                                           theme::faint.blueF());
        // At the top: the cameras' fields of view fill the bottom.
        note_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
        note_->SetPosition(0.02, 0.97);
        renderer_->AddActor2D(note_);
    }

    void write_note(int times) {
        const QString text = QCoreApplication::translate("kambara::ui::SceneView",
                                                         "left green, right cyan, pan-tilt amber\n"
                                                         "95 % ellipsoid drawn %1 times as large");
        note_->SetInput(text.arg(times).toUtf8().constData());
    }

    void draw_trail() {
        vtkNew<vtkPoints> points;
        vtkNew<vtkCellArray> cells;
        vtkNew<vtkUnsignedCharArray> colours;
        colours->SetNumberOfComponents(3);
        for (const TrailPoint& place : trail_) {
            const vtkIdType id = points->InsertNextPoint(place.point_mm.data());
            if (place.joined) {
                const vtkIdType ids[] = {id - 1, id};
                cells->InsertNextCell(2, ids);
                const double age =
                    1.0 - static_cast<double>(id + 1) / static_cast<double>(trail_.size());
                const double strength = 1.0 - (1.0 - faintest) * age;
                colours->InsertNextTuple3(strength * theme::accent.red(),
                                          strength * theme::accent.green(),
                                          strength * theme::accent.blue());
            }
        }
        trail_data_->SetPoints(points);
        trail_data_->SetLines(cells);
        trail_data_->GetCellData()->SetScalars(colours);
    }

    void centre_on(const Eigen::Vector3d& point_mm) {
        vtkCamera* camera = renderer_->GetActiveCamera();
        const Eigen::Vector3d focus(camera->GetFocalPoint());
        const Eigen::Vector3d eye(camera->GetPosition());
        const Eigen::Vector3d moved = eye + point_mm - focus;
        camera->SetFocalPoint(point_mm.data());
        camera->SetPosition(moved.data());
    }

    QVTKOpenGLStereoWidget* widget_;  // owned by its parent
    vtkNew<vtkGenericOpenGLRenderWindow> window_;
    vtkNew<vtkRenderer> renderer_;
    vtkNew<vtkPolyData> trail_data_;
    vtkNew<vtkActor> target_;
    vtkNew<vtkActor> spread_;
    vtkNew<vtkTextActor> note_;
    std::vector<vtkSmartPointer<vtkActor>> fields_;
    vtkSmartPointer<vtkActor> pan_tilt_field_;
    Rig rig_;
    std::deque<TrailPoint> trail_;
    Position newest_;
    HeadAngles head_;
    bool head_turned_ = false;
    bool in_sight_ = false;
    bool broken_ = true;
    std::optional<int> trail_target_;  // whose the trail is
    bool follows_ = false;
};

}  // namespace

std::unique_ptr<Scene> make_scene(QWidget* parent) {
    return std::make_unique<VtkScene>(parent);
}

}  // namespace kambara::ui
