// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>
#include <QUrl>

#include "ui/base/core_text.h"
#include "ui/calibration/calibration_window.h"
#include "ui/devices/hand_drive.h"
#include "ui/devices/pan_tilt_panel.h"
#include "ui/plots/plots_panel.h"
#include "ui/scene3d/scene_view.h"
#include "ui/shell/about_dialog.h"
#include "ui/shell/assistants.h"
#include "ui/shell/event_log.h"
#include "ui/shell/keys_dialog.h"
#include "ui/shell/open_recording_dialog.h"
#include "ui/shell/playback_bar.h"
#include "ui/shell/recent_recordings.h"
#include "ui/shell/status_fields.h"
#include "ui/shell/window_actions.h"
#include "ui/shell/window_layout.h"
#include "ui/tracking/correlation_map_view.h"
#include "ui/tracking/track_panel.h"
#include "ui/video/video_view.h"

namespace kambara::ui {
namespace {

constexpr int numbers_ms = 100;  // people read no faster
constexpr int notice_ms = 10000;

bool is_simulation(const SourceRequest& request) {
    return request.left.starts_with("sim:");
}

// One more than there may be where none is free: it is refused with the reason.
int first_free_number(const Snapshot& snapshot) {
    int number = 1;
    for (const TrackSnapshot& track : snapshot.tracks) {
        number += track.id == number ? 1 : 0;
    }
    return number;
}

// A folder stands for the pictures in it.
QString source_of(const QString& file) {
    if (!QFileInfo(file).isDir()) {
        return file;
    }
    for (const char* kind : {"png", "jpg", "jpeg", "tif", "tiff", "pgm", "ppm", "bmp"}) {
        const QString pattern = QStringLiteral("*.") + QLatin1String(kind);
        if (!QDir(file).entryList({pattern}, QDir::Files).isEmpty()) {
            return QDir(file).filePath(pattern);
        }
    }
    return file;
}

}  // namespace

MainWindow::MainWindow(SystemOpener opener, const WindowOptions& options, QWidget* parent)
    : QMainWindow(parent),
      options_(options),
      link_(new SystemLink(std::move(opener), this)),
      actions_(new WindowActions(this)) {
    setObjectName(QStringLiteral("mainWindow"));
    setWindowTitle(QStringLiteral("Kambara Vision"));
    setAcceptDrops(true);
    qApp->installEventFilter(this);
    setDockNestingEnabled(true);
    status_ = new StatusFields(statusBar());
    build_views();
    build_docks();
    build_menus();
    build_tools();
    build_assistants();
    connect_actions();
    connect_head();
    connect_link();
    restore_layout();
    numbers_.start(numbers_ms);
    notice_time_.setSingleShot(true);
    left_->setFocus();
    if (!options_.first.left.empty()) {
        open(options_.first);
    }
}

MainWindow::~MainWindow() = default;

void MainWindow::connect_actions() {
    const auto on = [this](QAction* action, auto&& act) {
        connect(action, &QAction::triggered, this, act);
    };
    on(actions_->open_recording, [this] { open_recording_dialog(opened_recording()); });
    on(actions_->simulated_rig, [this] { open(options_.simulation); });
    on(actions_->close_form, [this] {
        QWidget* front = QApplication::activeWindow();
        if (front != nullptr && front != this && front->windowType() == Qt::Window) {
            front->close();
        }
    });
    on(actions_->quit, [this] { close(); });
    on(actions_->play, [this] {
        const bool running = newest_ && newest_->run == RunState::running;
        link_->send(Flow{running ? Flow::Kind::pause : Flow::Kind::run});
    });
    on(actions_->step, [this] { link_->send(Flow{Flow::Kind::step}); });
    on(actions_->freeze, [this](bool on_now) { left_->set_frozen(on_now); });
    on(actions_->select, [this] { left_->begin_selection(); });
    on(actions_->start, [this] { link_->send(StartTracking{}); });
    on(actions_->stop, [this] {
        left_->cancel_selection();
        std::vector<Command> commands{StopTracking{}};
        if (newest_ && newest_->head) {
            commands.emplace_back(HaltHead{});
            drive_->drop_all();
        }
        link_->send(std::move(commands));
    });
    on(actions_->update_template, [this] { link_->send(UpdateTemplate{}); });
    on(actions_->clear, [this] { link_->send(ClearTemplate{}); });
    on(actions_->stretch_map, [this](bool on_now) { map_->set_stretched(on_now); });
    on(actions_->default_layout, [this] { lay_out(); });
    on(actions_->calibrate, [this] { show_calibration(); });
    on(actions_->keys, [this] { show_keys(*menuBar(), this); });
    on(actions_->about, [this] { show_about(this); });
    connect(left_, &VideoView::selected, this, &MainWindow::select);
    connect(left_, &VideoView::target_pointed_at, this,
            [this](int id) { link_->send(SteerTo{id}); });
    connect(left_, &VideoView::held, this, [this](qint64 frame) { link_->send(HoldFrame{frame}); });
    connect(left_, &VideoView::frozen_changed, actions_->freeze, &QAction::setChecked);
    connect(playback_, &PlaybackBar::seek_asked, this,
            [this](qint64 frame) { link_->send(Seek{frame}); });
    connect(&numbers_, &QTimer::timeout, this, &MainWindow::show_numbers);
    connect(&notice_time_, &QTimer::timeout, notice_, &QLabel::hide);
}

void MainWindow::connect_link() {
    connect(link_, &SystemLink::snapshot_came, this, &MainWindow::show_snapshot);
    connect(link_, &SystemLink::event_came, events_, &EventLog::add);
    connect(link_, &SystemLink::opened, this, &MainWindow::show_opened);
    connect(link_, &SystemLink::refused, this, &MainWindow::show_refusal);
    connect(link_, &SystemLink::open_failed, this,
            [this](const SourceRequest& request, const Error& error) {
                show_refusal(error);
                if (!is_simulation(request)) {
                    open_recording_dialog(request, translated(error));
                }
            });
}

CalibrationWindow& MainWindow::show_calibration() {
    if (calibration_ == nullptr) {
        calibration_ = new CalibrationWindow(options_.calibration, this);
        connect(calibration_, &CalibrationWindow::simulated_target_asked, this,
                [this](const QString& target) {
                    SourceRequest request;
                    request.left = "sim:chessboard?target=" + target.toStdString();
                    open(request);
                });
        calibration_->set_source(rig_, link_->hand(), !recording_);
    }
    calibration_->show();
    calibration_->raise();
    calibration_->activateWindow();
    return *calibration_;
}

SourceRequest MainWindow::opened_recording() const {
    return recording_ ? opened_ : SourceRequest{};
}

void MainWindow::open(const SourceRequest& request) {
    statusBar()->showMessage(tr("Opening %1\u2026").arg(QString::fromStdString(request.left)));
    link_->open(request);
}

void MainWindow::show_opened(const SourceRequest& request, const Rig& rig) {
    statusBar()->clearMessage();
    opened_ = request;
    rig_ = rig;
    recording_ = !is_simulation(request);
    if (newest_ && newest_->head) {
        by_hand_ = !newest_->head->automatic;
    }
    newest_.reset();
    drive_->drop_all();
    for (VideoView* view : {left_, right_, pan_tilt_}) {
        view->clear();
    }
    map_->clear();
    track_->clear();
    plots_->clear();
    scene_->set_rig(rig);
    scene_->clear_trail();
    playback_->setVisible(recording_);
    const QString title = recording_ ? RecentRecordings::title(request) : tr("simulated rig");
    setWindowTitle(tr("Kambara Vision \u2013 %1").arg(title));
    status_->show_source(title, rig);
    events_->add_note(tr("Opened: %1").arg(title));
    if (calibration_ != nullptr) {
        calibration_->set_source(rig, link_->hand(), !recording_);
    }
    track_->set_rig(rig);
    assistants_->set_source(rig, link_->stations(), link_->hand(), !recording_);
    if (recording_) {
        RecentRecordings::remember(request);
        fill_recent();
    }
}

void MainWindow::show_snapshot(const SnapshotPtr& snapshot) {
    // A system that was just opened steers; a head that was taken by hand stays so.
    if (newest_ == nullptr && by_hand_ && snapshot->head) {
        link_->send(SteerHead{false});
    }
    const bool first = newest_ == nullptr || newest_->run != snapshot->run;
    newest_ = snapshot;
    left_->show_snapshot(snapshot);
    right_->show_snapshot(snapshot);
    pan_tilt_->show_snapshot(snapshot);
    map_->show_snapshot(snapshot);
    plots_->add(*snapshot);
    scene_->add(*snapshot);
    if (calibration_ != nullptr && calibration_->isVisible()) {
        calibration_->show_snapshot(snapshot);
    }
    assistants_->show_snapshot(snapshot);
    if (first) {
        show_numbers();  // what can be done now should be possible at once
    }
}

void MainWindow::show_numbers() {
    actions_->update(newest_.get(), recording_);
    if (!newest_) {
        return;
    }
    track_->show_snapshot(newest_);
    head_->show_snapshot(newest_);
    status_->show_snapshot(*newest_);
    if (recording_) {
        playback_->show_snapshot(*newest_);
    }
}

void MainWindow::show_refusal(const Error& error) {
    statusBar()->clearMessage();
    notice_->setText(translated(error));
    notice_->show();
    notice_time_.start(notice_ms);
    events_->add_fault(translated(error));
}

void MainWindow::select(const Rectangle& rectangle, qint64 frame, bool one_more) {
    auto target = newest_ ? newest_->steered_target : std::nullopt;
    if (one_more && target) {
        target = first_free_number(*newest_);
    }
    link_->send({SelectTemplate{rectangle, frame, target}, StartTracking{target}});
}

// A dialog keeps shortcuts from the window behind it; the key that stops the head must work all the
// same.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress && QApplication::activeModalWidget() != nullptr &&
        QKeySequence(static_cast<QKeyEvent*>(event)->key()) == actions_->halt->shortcut()) {
        halt_head();
        return true;
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::open_recording_dialog(const SourceRequest& request, const QString& failure) {
    auto* dialog = new OpenRecordingDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->set_request(request);
    dialog->show_failure(failure);
    connect(dialog, &QDialog::accepted, this, [this, dialog] { open(dialog->request()); });
    connect(dialog, &QDialog::finished, notice_, &QWidget::hide);  // it was about what was tried
    dialog->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) {
        event->acceptProposedAction();
    }
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList files;
    for (const QUrl& url : event->mimeData()->urls()) {
        if (url.isLocalFile()) {
            files << source_of(url.toLocalFile());
        }
    }
    SourceRequest request = request_of_files(files);
    if (request.rig.empty()) {
        request.rig = opened_recording().rig;
    }
    if (request.left.empty() || request.rig.empty()) {
        open_recording_dialog(request);
    } else {
        open(request);
    }
    event->acceptProposedAction();
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!assistants_->may_close()) {
        event->ignore();
        return;
    }
    if (options_.keep_layout) {
        save_layout(*this);
    }
    // Left open, they would ask again, and one that stays would keep the program running.
    assistants_->close_all();
    QMainWindow::closeEvent(event);
}

void MainWindow::restore_layout() {
    give_default_size(*this);
    lay_out();
    if (options_.keep_layout) {
        load_layout(*this);
    }
}

void MainWindow::fill_recent() {
    recent_->clear();
    for (const SourceRequest& request : RecentRecordings::load()) {
        QAction* action = recent_->addAction(RecentRecordings::title(request));
        action->setToolTip(QString::fromStdString(request.left));
        connect(action, &QAction::triggered, this, [this, request] { open(request); });
    }
    recent_->setEnabled(!recent_->isEmpty());
}

}  // namespace kambara::ui
