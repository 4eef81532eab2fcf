// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <QTimer>
#include <memory>

#include "core/devices/gamepad.h"
#include "ui/shell/system_link.h"

class QDockWidget;
class QLabel;
class QMenu;

namespace kambara::ui {

class Assistants;
class CalibrationWindow;
class CorrelationMapView;
class EventLog;
class HandDrive;
class OpenRecordingDialog;
class PanTiltPanel;
class PlaybackBar;
class PlotsPanel;
class SceneView;
class StatusFields;
class TrackPanel;
class VideoView;
class WindowActions;

struct WindowOptions {
    bool with_gl = true;       ///< false: without the 3-D view
    bool keep_layout = true;   ///< false: the layout is neither read nor kept
    SourceRequest first;       ///< opened at once
    SourceRequest simulation;  ///< what "Simulated rig" opens
    CalibrationPorts calibration = {};
    /// Null where there is no way to one.
    std::shared_ptr<const GamepadBase> gamepad = nullptr;
    ExperimentPorts experiments = {};
};

/// twoView's successor: live views, target, map, 3-D view, plots, head and events in one window.
class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    MainWindow(SystemOpener opener, const WindowOptions& options, QWidget* parent = nullptr);
    ~MainWindow() override;

    SystemLink& link() { return *link_; }
    /// The guided calibration's window; shown, made when it is first asked for.
    CalibrationWindow& show_calibration();
    void open_recording_dialog(const SourceRequest& request = {}, const QString& failure = {});

  protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void build_views();
    void build_docks();
    void build_menus();
    void build_tools();
    void connect_actions();
    void connect_link();
    void build_assistants();
    QDockWidget* add_dock(QWidget* part, const QString& title, const char* object_name,
                          Qt::DockWidgetArea area);
    void lay_out();
    void restore_layout();
    void fill_recent();
    SourceRequest opened_recording() const;
    void open(const SourceRequest& request);
    void show_opened(const SourceRequest& request, const Rig& rig);
    void show_snapshot(const SnapshotPtr& snapshot);
    void show_numbers();
    void show_refusal(const Error& error);
    void connect_head();
    void halt_head();
    void select(const Rectangle& rectangle, qint64 frame, bool one_more);

    const WindowOptions options_;
    SystemLink* link_;
    WindowActions* actions_;
    VideoView* left_ = nullptr;
    VideoView* right_ = nullptr;
    VideoView* pan_tilt_ = nullptr;
    QLabel* notice_ = nullptr;
    PlaybackBar* playback_ = nullptr;
    TrackPanel* track_ = nullptr;
    CorrelationMapView* map_ = nullptr;
    PlotsPanel* plots_ = nullptr;
    SceneView* scene_ = nullptr;
    HandDrive* drive_ = nullptr;
    PanTiltPanel* head_ = nullptr;
    EventLog* events_ = nullptr;
    StatusFields* status_ = nullptr;
    CalibrationWindow* calibration_ = nullptr;
    Assistants* assistants_ = nullptr;
    Rig rig_;
    QMenu* recent_ = nullptr;
    QList<QDockWidget*> docks_;
    SnapshotPtr newest_;
    SourceRequest opened_;
    bool recording_ = false;
    bool by_hand_ = false;  // the head, when the source before was left
    QTimer numbers_;
    QTimer notice_time_;
};

}  // namespace kambara::ui
