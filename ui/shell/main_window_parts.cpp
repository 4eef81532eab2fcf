// SPDX-License-Identifier: GPL-3.0-or-later
// What the main window is made of, and where it stands by default.
#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScreen>
#include <QSplitter>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/base/theme.h"
#include "ui/devices/hand_drive.h"
#include "ui/devices/pan_tilt_panel.h"
#include "ui/plots/plots_panel.h"
#include "ui/scene3d/scene_view.h"
#include "ui/shell/assistants.h"
#include "ui/shell/event_log.h"
#include "ui/shell/main_window.h"
#include "ui/shell/playback_bar.h"
#include "ui/shell/window_actions.h"
#include "ui/shell/window_layout.h"
#include "ui/tracking/correlation_map_view.h"
#include "ui/tracking/track_panel.h"
#include "ui/video/video_view.h"

namespace kambara::ui {

void MainWindow::build_views() {
    left_ = new VideoView(ViewedCamera::left, tr("Left"), this);
    left_->setObjectName(QStringLiteral("leftView"));
    left_->allow_selection(true);
    left_->setCursor(Qt::CrossCursor);
    right_ = new VideoView(ViewedCamera::right, tr("Right"), this);
    right_->setObjectName(QStringLiteral("rightView"));
    notice_ = new QLabel(this);
    notice_->setObjectName(QStringLiteral("notice"));
    notice_->setWordWrap(true);
    notice_->setMargin(6);
    notice_->setStyleSheet(
        QStringLiteral("background: %1; color: black").arg(theme::caution.name()));
    notice_->hide();
    playback_ = new PlaybackBar(actions_->play, actions_->step, this);
    playback_->setObjectName(QStringLiteral("playbackBar"));
    playback_->hide();
    auto* pair = new QSplitter(Qt::Horizontal, this);
    pair->addWidget(left_);
    pair->addWidget(right_);
    pair->setChildrenCollapsible(false);
    auto* central = new QWidget(this);
    auto* column = new QVBoxLayout(central);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(notice_);
    column->addWidget(pair, 1);
    column->addWidget(playback_);
    setCentralWidget(central);
}

QDockWidget* MainWindow::add_dock(QWidget* part, const QString& title, const char* object_name,
                                  Qt::DockWidgetArea area) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(QLatin1String(object_name));
    dock->setWidget(part);
    addDockWidget(area, dock);
    docks_ << dock;
    return dock;
}

void MainWindow::build_docks() {
    setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    track_ = new TrackPanel(this);
    track_->setObjectName(QStringLiteral("trackPanel"));
    pan_tilt_ = new VideoView(ViewedCamera::pan_tilt, tr("Pan-tilt"), this);
    pan_tilt_->setObjectName(QStringLiteral("panTiltView"));
    pan_tilt_->allow_pointing(true);
    pan_tilt_->setCursor(Qt::CrossCursor);
    pan_tilt_->setToolTip(tr("Click: what is there comes to the middle"));
    drive_ = new HandDrive(this);
    head_ = new PanTiltPanel(
        {actions_->home, actions_->reset_head, actions_->steer, actions_->halt}, drive_, this);
    head_->setObjectName(QStringLiteral("headPanel"));
    map_ = new CorrelationMapView(this);
    map_->setObjectName(QStringLiteral("mapView"));
    scene_ = new SceneView(options_.with_gl, this);
    scene_->setObjectName(QStringLiteral("sceneView"));
    plots_ = new PlotsPanel(this);
    plots_->setObjectName(QStringLiteral("plotsPanel"));
    events_ = new EventLog(this);
    events_->setObjectName(QStringLiteral("eventLog"));
    const auto right = Qt::RightDockWidgetArea;
    const auto bottom = Qt::BottomDockWidgetArea;
    add_dock(track_, tr("Target"), "targetDock", right);
    add_dock(pan_tilt_, tr("Pan-tilt picture"), "panTiltDock", right);
    add_dock(head_, tr("Pan-tilt head"), "headDock", right);
    add_dock(map_, tr("Correlation map"), "mapDock", bottom);
    add_dock(scene_, tr("3-D view"), "sceneDock", bottom);
    add_dock(plots_, tr("Plots"), "plotsDock", bottom);
    add_dock(events_, tr("Events"), "eventsDock", bottom);
}

void MainWindow::lay_out() {
    // A low screen has no room for three parts above each other: they become tabs.
    const bool low = screen()->availableSize().height() < 800;
    for (QDockWidget* dock : docks_) {
        dock->setFloating(false);
        addDockWidget(docks_.indexOf(dock) < 3 ? Qt::RightDockWidgetArea : Qt::BottomDockWidgetArea,
                      dock);
        dock->show();
    }
    QDockWidget *track = docks_[0], *picture = docks_[1], *head = docks_[2], *map = docks_[3],
                *scene = docks_[4], *plots = docks_[5], *events = docks_[6];
    if (low) {
        tabifyDockWidget(track, picture);
        tabifyDockWidget(picture, head);
        tabifyDockWidget(map, scene);
        tabifyDockWidget(scene, plots);
        tabifyDockWidget(plots, events);
        map->raise();
        resizeDocks({track}, {300}, Qt::Horizontal);
        resizeDocks({map}, {220}, Qt::Vertical);
    } else {
        splitDockWidget(track, picture, Qt::Vertical);
        splitDockWidget(picture, head, Qt::Vertical);
        splitDockWidget(map, scene, Qt::Horizontal);
        splitDockWidget(scene, plots, Qt::Horizontal);
        tabifyDockWidget(plots, events);
        plots->raise();
        resizeDocks({map, scene, plots}, {240, 440, 540}, Qt::Horizontal);
        resizeDocks({map, scene, plots}, {300, 300, 300}, Qt::Vertical);
        resizeDocks({track, picture, head}, {230, 250, 330}, Qt::Vertical);
    }
    track->raise();
}

void MainWindow::build_tools() {
    QToolBar* tools = addToolBar(tr("Tools"));
    tools->setObjectName(QStringLiteral("toolBar"));
    tools->setMovable(false);
    tools->addActions({actions_->open_recording, actions_->simulated_rig});
    tools->addSeparator();
    tools->addActions({actions_->freeze, actions_->select, actions_->start, actions_->stop,
                       actions_->update_template, actions_->clear});
    tools->addSeparator();
    tools->addActions({actions_->steer, actions_->home, actions_->halt});
}

void MainWindow::build_assistants() {
    assistants_ = new Assistants(options_.experiments, this);
    connect(actions_->level, &QAction::triggered, assistants_, &Assistants::show_levelling);
    connect(actions_->range_experiment, &QAction::triggered, assistants_,
            &Assistants::show_range_experiment);
    connect(actions_->calibrate_head, &QAction::triggered, assistants_,
            &Assistants::show_head_calibration);
    connect(actions_->calibrate_zoom, &QAction::triggered, assistants_,
            &Assistants::show_zoom_calibration);
    connect(assistants_, &Assistants::simulation_asked, this, [this](const QString& source) {
        SourceRequest request;
        request.left = source.toStdString();
        open(request);
    });
    connect(assistants_, &Assistants::command_asked, this,
            [this](const Command& command) { link_->send(command); });
    connect(assistants_, &Assistants::mount_found, this, [this](const Mount& mount) {
        rig_.mount = mount;
        track_->set_rig(rig_);
    });
}

void MainWindow::build_menus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(actions_->open_recording);
    recent_ = file->addMenu(tr("Open &recent"));
    recent_->setObjectName(QStringLiteral("recentMenu"));
    recent_->setToolTipsVisible(true);
    fill_recent();
    file->addAction(actions_->simulated_rig);
    file->addSeparator();
    file->addActions({actions_->close_form, actions_->quit});
    const auto add = [this](const QString& title, const QList<QAction*>& actions) {
        QMenu* menu = menuBar()->addMenu(title);
        menu->addActions(actions);
        menu->setToolTipsVisible(true);
        return menu;
    };
    add(tr("&Recording"), {actions_->play, actions_->step});
    add(tr("&Target"), {actions_->freeze, actions_->select, actions_->start, actions_->stop,
                        actions_->update_template, actions_->clear});
    add(tr("&Head"),
        {actions_->steer, actions_->servo, actions_->home, actions_->reset_head, actions_->halt});
    add(tr("&Calibration"), {actions_->calibrate});
    add(tr("Tool&s"), {actions_->level, actions_->range_experiment, actions_->calibrate_head,
                       actions_->calibrate_zoom});
    QMenu* view = add(tr("&View"), {actions_->stretch_map});
    view->addSeparator();
    for (QDockWidget* dock : docks_) {
        view->addAction(dock->toggleViewAction());
    }
    view->addSeparator();
    view->addAction(actions_->default_layout);
    add(tr("H&elp"), {actions_->keys, actions_->about});
}

}  // namespace kambara::ui
