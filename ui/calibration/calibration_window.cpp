// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/calibration_window.h"

#include <QCloseEvent>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QStackedWidget>

#include "ui/base/core_text.h"
#include "ui/calibration/capture_page.h"
#include "ui/calibration/result_page.h"
#include "ui/calibration/setup_page.h"

namespace kambara::ui {

CalibrationWindow::CalibrationWindow(const CalibrationPorts& ports, QWidget* parent)
    : QWidget(parent, Qt::Window),
      setup_(new SetupPage),
      capture_(new CapturePage),
      result_(new ResultPage),
      pages_(new QStackedWidget(this)),
      worker_(new SessionWorker(ports, this)) {
    setObjectName(QStringLiteral("calibrationWindow"));
    setWindowTitle(tr("Calibration"));
    resize(1320, 780);
    auto* centred = new QWidget;
    auto* row = new QHBoxLayout(centred);
    row->addStretch(1);
    row->addWidget(setup_, 100);
    row->addStretch(1);
    pages_->addWidget(centred);
    pages_->addWidget(capture_);
    pages_->addWidget(result_);
    auto* all = new QHBoxLayout(this);
    all->addWidget(pages_);
    connect_pages();
    connect_worker();
}

CalibrationWindow::~CalibrationWindow() = default;

void CalibrationWindow::connect_pages() {
    connect(setup_, &SetupPage::begin_asked, this, &CalibrationWindow::begin);
    connect(setup_, &SetupPage::resume_asked, this, &CalibrationWindow::resume);
    connect(capture_, &CapturePage::kept_changed, worker_, &SessionWorker::set_kept);
    connect(capture_, &CapturePage::undo_asked, worker_, &SessionWorker::undo);
    connect(capture_, &CapturePage::capture_asked, worker_, &SessionWorker::capture_by_hand);
    connect(capture_, &CapturePage::paused, worker_, [this](bool on) { worker_->watch(!on); });
    connect(capture_, &CapturePage::cancel_asked, worker_, &SessionWorker::cancel);
    connect(capture_, &CapturePage::leave_asked, this, &CalibrationWindow::leave);
    connect(capture_, &CapturePage::solve_asked, this, [this] {
        worker_->watch(false);
        capture_->show_solving(true, 0.0);
        worker_->solve();
    });
    connect(result_, &ResultPage::back_asked, this, &CalibrationWindow::start_capturing);
    connect(result_, &ResultPage::save_rig_asked, this,
            [this](const QString& file) { save(file, false); });
    connect(result_, &ResultPage::save_report_asked, this,
            [this](const QString& file) { save(file, true); });
}

void CalibrationWindow::connect_worker() {
    connect(worker_, &SessionWorker::begun, this, [this] {
        state_.reset();
        outcome_.reset();
    });
    connect(worker_, &SessionWorker::changed, this, [this](const SessionStatePtr& state) {
        const bool first = state_ == nullptr;
        state_ = state;
        if (first) {
            capture_->set_hand(hand_);
            capture_->begin(state->setup);
            start_capturing();
        }
        capture_->show_state(state);
    });
    connect(worker_, &SessionWorker::looked, this, [this](const SessionLookPtr& look) {
        if (pages_->currentWidget() == capture_) {
            capture_->show_look(look);
        }
    });
    connect(worker_, &SessionWorker::progressed, this,
            [this](double share) { capture_->show_solving(true, share); });
    connect(worker_, &SessionWorker::cancelled, this, &CalibrationWindow::start_capturing);
    connect(worker_, &SessionWorker::solved, this, [this](const SessionOutcomePtr& outcome) {
        capture_->show_solving(false, 1.0);
        outcome_ = outcome;
        result_->show_outcome(outcome, QString::fromStdString(state_->folder.string()));
        pages_->setCurrentWidget(result_);
    });
    connect(worker_, &SessionWorker::saved, result_, &ResultPage::show_saved);
    connect(worker_, &SessionWorker::failed, this, &CalibrationWindow::fail);
}

void CalibrationWindow::set_source(const Rig& rig, const TargetHand& hand, bool simulated) {
    hand_ = hand;
    simulated_ = simulated;
    capture_->set_hand(hand);
    if (waiting_) {
        const auto [setup, folder] = *std::exchange(waiting_, std::nullopt);
        worker_->begin(setup, folder.toStdString());
        return;
    }
    setup_->set_rig(rig, QString::fromStdString(hand.target));
}

void CalibrationWindow::show_snapshot(const SnapshotPtr& snapshot) {
    setup_->show_snapshot(*snapshot);
    worker_->offer(snapshot);
}

void CalibrationWindow::begin(const SessionSetup& setup, const QString& folder) {
    setup_->show_failure({});
    const std::string target = to_string(setup.target);
    if (simulated_ && hand_.target != target) {
        waiting_ = std::make_pair(setup, folder);
        emit simulated_target_asked(QString::fromStdString(target));
        return;
    }
    worker_->begin(setup, folder.toStdString());
}

void CalibrationWindow::resume(const QString& folder) {
    worker_->resume(folder.toStdString());
}

void CalibrationWindow::start_capturing() {
    capture_->show_solving(false, 0.0);
    pages_->setCurrentWidget(capture_);
    worker_->watch(true);
    capture_->follow_again();
}

void CalibrationWindow::fail(const Error& error) {
    const QString text = translated(error);
    if (pages_->currentWidget() == capture_) {
        capture_->show_failure(text);
    } else if (pages_->currentWidget() == result_) {
        result_->show_failure(text);
    } else {
        setup_->show_failure(text);
    }
}

void CalibrationWindow::leave() {
    worker_->watch(false);
    if (hand_) {
        hand_.let_go();
    }
    setup_->offer_new_folder();
    pages_->setCurrentIndex(0);
}

void CalibrationWindow::save(const QString& file, bool report) {
    if (!outcome_) {
        return;
    }
    const QString folder = QFileInfo(file).absolutePath();
    if (!QDir().mkpath(folder)) {
        result_->show_failure(
            tr("The folder %1 can't be made. Choose a place that can be written to.").arg(folder));
        return;
    }
    if (report) {
        worker_->save_report(outcome_, file.toStdString());
    } else {
        worker_->save_rig(outcome_, file.toStdString());
    }
}

// Nothing is asked: every shot is on disk already.
void CalibrationWindow::closeEvent(QCloseEvent* event) {
    worker_->cancel();
    leave();
    QWidget::closeEvent(event);
}

}  // namespace kambara::ui
