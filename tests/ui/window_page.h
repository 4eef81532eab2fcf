// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QLabel>
#include <QString>
#include <functional>
#include <memory>

#include "core/base/clock.h"
#include "hardware/simulated/simulated_world.h"
#include "ui/plots/plots_panel.h"
#include "ui/scene3d/scene_view.h"
#include "ui/shell/event_log.h"
#include "ui/shell/main_window.h"
#include "ui/shell/open_recording_dialog.h"
#include "ui/tracking/correlation_map_view.h"
#include "ui/video/video_view.h"

namespace kambara::testing_support {

/// The window as an operator has it before them: what can be seen, clicked and typed.
class WindowPage {
  public:
    /// `profile`: of the simulated rig whose target the page knows.
    explicit WindowPage(const ui::WindowOptions& options, const std::string& profile = "default");
    /// On the simulated rig, live.
    static ui::WindowOptions simulated(bool with_gl = true);

    /// Lets the window live until something is so; false after `seconds`.
    static bool until(const std::function<bool()>& is_so, int seconds = 20);
    bool until_picture();
    bool until_state(TrackState state);

    ui::VideoView& left() { return part<ui::VideoView>("leftView"); }
    ui::VideoView& right() { return part<ui::VideoView>("rightView"); }
    ui::CorrelationMapView& map() { return part<ui::CorrelationMapView>("mapView"); }
    ui::PlotsPanel& plots() { return part<ui::PlotsPanel>("plotsPanel"); }
    ui::SceneView& scene() { return part<ui::SceneView>("sceneView"); }
    ui::EventLog& events() { return part<ui::EventLog>("eventLog"); }
    QString text(const char* object_name) { return part<QLabel>(object_name).text(); }
    QAction& action(const char* object_name);
    /// The dialog that is open, once it is.
    ui::OpenRecordingDialog* open_dialog();

    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier, int times = 1);
    /// A left drag from corner to corner of a rectangle of the left picture.
    void drag(const Rectangle& rectangle, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    /// A left click on a pixel of the left picture.
    void click(const Eigen::Vector2d& left_px, Qt::KeyboardModifiers modifiers);
    /// The target's rectangle in the left picture that is on show.
    Rectangle target() const;

    /// What the left or the right view shows; an empty one as long as nothing is shown.
    Snapshot shown() { return shown_in(left()); }
    Snapshot shown_right() { return shown_in(right()); }
    const SimulatedWorld& world() const { return *world_; }
    ui::MainWindow& window() { return *window_; }

    template <class Part>
    Part& part(const char* object_name) {
        auto* found = window_->findChild<Part*>(QLatin1String(object_name));
        if (found == nullptr) {
            throw std::logic_error(std::string("the window has no ") + object_name);
        }
        return *found;
    }

  private:
    static Snapshot shown_in(const ui::VideoView& view) {
        return view.shown() ? *view.shown() : Snapshot{};
    }

    SteadyClock clock_;
    std::unique_ptr<SimulatedWorld> world_;
    std::unique_ptr<ui::MainWindow> window_;
};

}  // namespace kambara::testing_support
