// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QWidget>
#include <array>

#include "ui/calibration/session_worker.h"

class QCheckBox;
class QLabel;
class QListWidget;
class QProgressBar;
class QPushButton;

namespace kambara::ui {

class CoveragePlot;
class GuideView;
class HoldPad;

/// The session's live page: all cameras with what is found and where to go, what is covered, the
/// shots, and on the simulated rig the hand that holds the target.
class CapturePage : public QWidget {
    Q_OBJECT
  public:
    explicit CapturePage(QWidget* parent = nullptr);

    static constexpr int enough_shots = 12;

    void set_hand(const TargetHand& hand);
    void begin(const SessionSetup& setup);
    void show_state(const SessionStatePtr& state);
    void show_look(const SessionLookPtr& look);
    void show_failure(const QString& text);
    void show_solving(bool under_way, double share);
    void follow_again();  ///< the helper's hand goes to the outline once more

  signals:
    void kept_changed(int shot, bool kept);
    void undo_asked();
    void capture_asked();
    void paused(bool on);
    void solve_asked();
    void cancel_asked();
    void leave_asked();

  private:
    void build_side(QWidget* side);
    void say(const QString& text, const QColor& colour);
    void fill_shots();
    void fill_buttons();

    TargetHand hand_;
    SessionStatePtr state_;
    bool solving_ = false;
    int helper_went_for_ = -1;  // shots kept
    QElapsedTimer since_found_;
    QElapsedTimer since_told_;  // what is to be read for a while
    qint64 told_for_ms_ = 0;
    QElapsedTimer since_hold_;
    std::array<GuideView*, most_cameras> views_{};
    QLabel* banner_;
    QProgressBar* progress_;
    QLabel* progress_text_;
    CoveragePlot* coverage_;
    QListWidget* shots_;
    QPushButton* undo_;
    QPushButton* capture_;
    QPushButton* pause_;
    QWidget* hand_box_;
    QCheckBox* helper_;
    HoldPad* pad_;
    QProgressBar* solving_bar_;
    QPushButton* solve_;
    QPushButton* leave_;
};

}  // namespace kambara::ui
