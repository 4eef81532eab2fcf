// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "core/vsystem/snapshot.h"
#include "ui/video/overlay.h"
#include "ui/video/rectangle_selection.h"
#include "ui/video/view_transform.h"

namespace kambara::ui {

/// One camera's live picture with its overlays, painted in one pass from one snapshot.
///
/// Wheel zooms about the cursor, middle drag moves, 0 fits, 1 shows pixel for pixel, F freezes.
/// Where selecting is allowed, a left drag draws a rectangle; begin_selection() offers one that
/// the arrow keys move (10 px; with Ctrl 1 px; with Shift they change its size), Enter takes and
/// Escape drops. While a rectangle is drawn the picture stands still. A drag, or Enter, with Ctrl
/// asks for one more target; a click with Ctrl on a target's box for steering to it.
class VideoView : public QWidget {
    Q_OBJECT
  public:
    VideoView(ViewedCamera camera, const QString& title, QWidget* parent = nullptr);

    void show_snapshot(const SnapshotPtr& snapshot);
    void clear();
    void allow_selection(bool allowed) { may_select_ = allowed; }
    /// A left click asks for what is there (pointed_at).
    void allow_pointing(bool allowed) { may_point_ = allowed; }
    void begin_selection();
    void cancel_selection();
    bool selecting() const { return selection_.has_value(); }
    void set_frozen(bool frozen);
    bool frozen() const { return frozen_; }
    /// The snapshot on show; null before the first.
    const SnapshotPtr& shown() const { return shown_; }
    /// Of the picture on show: what the newest pair is younger, and how long ago that came.
    qint64 age_ms() const;
    const ViewTransform& view() const { return view_; }
    /// Slows every painting down by so much: for measuring what a slow painter does to the rest.
    void set_painting_delay_ms(int delay_ms) { painting_delay_ms_ = delay_ms; }

    QSize sizeHint() const override { return {640, 480}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

  signals:
    /// A rectangle was chosen in the left picture of that frame: for the steered target, or for one
    /// more.
    void selected(const kambara::Rectangle& rectangle, qint64 frame, bool one_more);
    /// The operator clicked on that pixel of the picture on show.
    void pointed_at(double x_px, double y_px);
    /// The operator pointed at a target's box.
    void target_pointed_at(int id);
    /// The operator looks at that frame: it should be remembered.
    void held(qint64 frame);
    void frozen_changed(bool frozen);
    void painted(qint64 frame);

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

  private:
    const Frame& frame_of(const Snapshot& snapshot) const;
    void take(const SnapshotPtr& snapshot);
    void set_view(const ViewTransform& view);
    void fit();
    bool holding() const { return frozen_ || selection_.has_value(); }
    void hold();
    void finish_selection();
    void point(const QPointF& released);
    bool selection_key(const QKeyEvent& event);
    void paint_notes(QPainter& painter) const;
    QString cursor_text() const;

    const ViewedCamera camera_;
    const QString title_;
    SnapshotPtr newest_;
    SnapshotPtr shown_;
    QImage image_;
    ViewTransform view_;
    bool fits_ = true;
    bool may_select_ = false;
    bool may_point_ = false;
    std::optional<QPointF> pressed_at_;  // where pointing is allowed
    bool frozen_ = false;
    std::optional<RectangleSelection> selection_;
    bool one_more_ = false;  // the selection is for one more target
    std::optional<QPointF> moved_from_;
    std::optional<QPointF> cursor_;
    QElapsedTimer since_newest_;
    QTimer ageing_;
    int painting_delay_ms_ = 0;
};

}  // namespace kambara::ui
