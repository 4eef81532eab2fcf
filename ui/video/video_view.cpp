// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/video/video_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QThread>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/video/picture_image.h"

namespace kambara::ui {
namespace {

constexpr int first_size_px = 41;
constexpr int coarse_step_px = 10;
constexpr double zoom_a_notch = 1.25;
constexpr qint64 old_ms = 500;
constexpr int margin = 6;
constexpr double click_reach_px = 4.0;

void paint_note(QPainter& painter, const QRectF& within, int alignment, const QString& text,
                const QColor& colour) {
    const QFontMetrics metrics = painter.fontMetrics();
    const QString fitting =
        metrics.elidedText(text, Qt::ElideRight, static_cast<int>(within.width()) - 16);
    QRectF box(0.0, 0.0, metrics.horizontalAdvance(fitting) + 10.0, metrics.height() + 4.0);
    box.moveTop((alignment & Qt::AlignBottom) != 0 ? within.bottom() - box.height() : within.top());
    box.moveLeft((alignment & Qt::AlignRight) != 0 ? within.right() - box.width() : within.left());
    painter.fillRect(box, QColor(0, 0, 0, 190));
    painter.setPen(colour);
    painter.drawText(box, Qt::AlignCenter, fitting);
}

}  // namespace

VideoView::VideoView(ViewedCamera camera, const QString& title, QWidget* parent)
    : QWidget(parent), camera_(camera), title_(title) {
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(title);
    // The age of the newest picture grows on show even when no more come.
    connect(&ageing_, &QTimer::timeout, this, [this] {
        if (since_newest_.isValid() && since_newest_.elapsed() > old_ms) {
            update();
        }
    });
    ageing_.start(250);
}

const Frame& VideoView::frame_of(const Snapshot& snapshot) const {
    switch (camera_) {
        case ViewedCamera::left:
            return snapshot.pictures.stereo.left;
        case ViewedCamera::right:
            return snapshot.pictures.stereo.right;
        case ViewedCamera::pan_tilt:
            break;
    }
    return snapshot.pictures.pan_tilt;
}

void VideoView::show_snapshot(const SnapshotPtr& snapshot) {
    newest_ = snapshot;
    since_newest_.start();
    if (!holding()) {
        take(snapshot);
    }
}

void VideoView::take(const SnapshotPtr& snapshot) {
    const QSize before = image_.size();
    shown_ = snapshot;
    image_ = image_sharing(frame_of(*snapshot).picture);
    if (fits_ && image_.size() != before) {
        fit();
    }
    update();
}

void VideoView::clear() {
    selection_.reset();
    set_frozen(false);
    newest_.reset();
    shown_.reset();
    image_ = {};
    since_newest_.invalidate();
    fits_ = true;
    update();
}

void VideoView::fit() {
    fits_ = true;
    view_ = ViewTransform::fitted(image_.size(), size());
    update();
}

void VideoView::set_view(const ViewTransform& view) {
    fits_ = false;
    view_ = view;
    update();
}

void VideoView::hold() {
    if (shown_) {
        emit held(shown_->frame);
    }
}

void VideoView::set_frozen(bool frozen) {
    if (frozen == frozen_ || (frozen && !shown_)) {
        return;
    }
    frozen_ = frozen;
    if (frozen_) {
        hold();
    } else if (newest_ && !holding()) {
        take(newest_);
    }
    emit frozen_changed(frozen_);
    update();
}

void VideoView::begin_selection() {
    if (!may_select_ || image_.isNull() || selection_) {
        return;
    }
    selection_ = RectangleSelection::centred(image_.size(), first_size_px);
    one_more_ = false;
    hold();
    setFocus(Qt::OtherFocusReason);
    update();
}

void VideoView::cancel_selection() {
    selection_.reset();
    if (newest_ && !holding()) {
        take(newest_);
    }
    update();
}

void VideoView::finish_selection() {
    const auto chosen = selection_;
    const qint64 frame = shown_ ? shown_->frame : -1;
    selection_.reset();
    // A click that was hardly a drag asks for nothing; with Ctrl, for the target under it.
    if (chosen && chosen->large_enough() && frame >= 0) {
        emit selected(chosen->rectangle(), frame, one_more_);
        set_frozen(false);
    } else if (chosen && one_more_ && shown_) {
        const Rectangle& spot = chosen->rectangle();
        if (const auto id = target_under(*shown_, {spot.centre_x_px(), spot.centre_y_px()})) {
            emit target_pointed_at(*id);
        }
    }
    cancel_selection();
}

bool VideoView::event(QEvent* event) {
    // While a rectangle is placed its keys are its own, not the window's shortcuts.
    if (event->type() == QEvent::ShortcutOverride && selection_) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter ||
            (key >= Qt::Key_Left && key <= Qt::Key_Down)) {
            event->accept();
            return true;
        }
    }
    return QWidget::event(event);
}

void VideoView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    if (fits_) {
        fit();
    }
}

void VideoView::wheelEvent(QWheelEvent* event) {
    if (!image_.isNull()) {
        const double notches = event->angleDelta().y() / 120.0;
        set_view(view_.zoomed(std::pow(zoom_a_notch, notches), event->position()));
    }
    event->accept();
}

void VideoView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton) {
        moved_from_ = event->pos();
    } else if (event->button() == Qt::LeftButton && may_select_ && !image_.isNull()) {
        const bool held_already = holding();
        selection_ = RectangleSelection(image_.size(), view_.pixel_from_widget(event->pos()));
        one_more_ = (event->modifiers() & Qt::ControlModifier) != 0;
        if (!held_already) {
            hold();
        }
        update();
    } else if (event->button() == Qt::LeftButton && may_point_ && !image_.isNull()) {
        pressed_at_ = event->pos();
    } else {
        QWidget::mousePressEvent(event);
    }
}

void VideoView::mouseMoveEvent(QMouseEvent* event) {
    cursor_ = event->pos();
    if (moved_from_) {
        set_view(view_.moved(event->pos() - *moved_from_));
        moved_from_ = event->pos();
    } else if (selection_ && (event->buttons() & Qt::LeftButton) != 0) {
        selection_->drag_to(view_.pixel_from_widget(event->pos()));
    }
    update();
}

void VideoView::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::MiddleButton) {
        moved_from_.reset();
    } else if (event->button() == Qt::LeftButton && selection_) {
        selection_->drag_to(view_.pixel_from_widget(event->pos()));
        finish_selection();
    } else if (event->button() == Qt::LeftButton && pressed_at_) {
        point(event->pos());
    }
}

// A press that was dragged elsewhere is no click; what is beside the picture is nothing.
void VideoView::point(const QPointF& released) {
    const QPointF pressed = *std::exchange(pressed_at_, std::nullopt);
    const QPointF pixel = view_.pixel_from_widget(released);
    const QRectF picture(-0.5, -0.5, image_.width(), image_.height());
    if ((released - pressed).manhattanLength() <= click_reach_px && picture.contains(pixel)) {
        emit pointed_at(pixel.x(), pixel.y());
    }
}

void VideoView::leaveEvent(QEvent* event) {
    cursor_.reset();
    update();
    QWidget::leaveEvent(event);
}

bool VideoView::selection_key(const QKeyEvent& event) {
    if (!selection_) {
        return false;
    }
    const bool grows = (event.modifiers() & Qt::ShiftModifier) != 0;
    const int step = (event.modifiers() & Qt::ControlModifier) != 0 ? 1 : coarse_step_px;
    const auto change = [&](int dx, int dy) {
        if (grows) {
            selection_->grow(dx, -dy);  // up makes it taller
        } else {
            selection_->move(dx, dy);
        }
        update();
    };
    switch (event.key()) {
        case Qt::Key_Left:
            change(-step, 0);
            return true;
        case Qt::Key_Right:
            change(step, 0);
            return true;
        case Qt::Key_Up:
            change(0, -step);
            return true;
        case Qt::Key_Down:
            change(0, step);
            return true;
        case Qt::Key_Return:
        case Qt::Key_Enter:
            one_more_ = (event.modifiers() & Qt::ControlModifier) != 0;
            finish_selection();
            return true;
        case Qt::Key_Escape:
            cancel_selection();
            return true;
        default:
            return false;
    }
}

void VideoView::keyPressEvent(QKeyEvent* event) {
    if (selection_key(*event)) {
        return;
    }
    switch (event->key()) {
        case Qt::Key_0:
            fit();
            break;
        case Qt::Key_1:
            set_view(view_.at_full_size(size()));
            break;
        case Qt::Key_F:
            set_frozen(!frozen_);
            break;
        default:
            QWidget::keyPressEvent(event);
    }
}

QString VideoView::cursor_text() const {
    if (!cursor_ || !shown_) {
        return {};
    }
    const ImagePtr& picture = frame_of(*shown_).picture;
    const QPointF pixel = view_.pixel_from_widget(*cursor_);
    const int x = static_cast<int>(std::lround(pixel.x()));
    const int y = static_cast<int>(std::lround(pixel.y()));
    if (!picture || !picture->contains(x, y)) {
        return {};
    }
    const QString place = QStringLiteral("x %1  y %2 px").arg(x).arg(y);
    if (picture->channels() == 3) {
        return place + tr("   red %1  green %2  blue %3")
                           .arg(picture->at(x, y, 2))
                           .arg(picture->at(x, y, 1))
                           .arg(picture->at(x, y, 0));
    }
    return place + tr("   grey %1").arg(picture->at(x, y));
}

// A camera may have stopped while the others go on: then its picture ages with every pair.
qint64 VideoView::age_ms() const {
    if (!newest_ || !shown_) {
        return 0;
    }
    const qint64 behind_ms = (newest_->time_ns - frame_of(*shown_).time_ns) / 1'000'000;
    return std::max<qint64>(0, behind_ms) + since_newest_.elapsed();
}

void VideoView::paint_notes(QPainter& painter) const {
    const QRectF within = QRectF(rect()).adjusted(margin, margin, -margin, -margin);
    if (image_.isNull()) {
        painter.setPen(theme::faint);
        painter.drawText(within, Qt::AlignCenter | Qt::TextWordWrap,
                         tr("%1: no picture").arg(title_));
        return;
    }
    const bool stands = newest_ && newest_->run != RunState::running;
    QString text = tr("%1   frame %2").arg(title_).arg(frame_of(*shown_).index);
    QColor colour = theme::text;
    if (holding()) {
        text += QStringLiteral("   ") + tr("FROZEN");
        colour = theme::caution;
    } else if (!stands) {
        text += QStringLiteral("   ") +
                tr("%1 old").arg(seconds(0.001 * static_cast<double>(age_ms())));
        colour = age_ms() > old_ms ? theme::bad : theme::text;
    }
    paint_note(painter, within, Qt::AlignTop | Qt::AlignLeft, text, colour);
    paint_note(painter, within, Qt::AlignBottom | Qt::AlignRight, percent(view_.zoom()),
               theme::faint);
    if (const QString cursor = cursor_text(); !cursor.isEmpty()) {
        paint_note(painter, within, Qt::AlignBottom | Qt::AlignLeft, cursor, theme::text);
    }
}

void VideoView::paintEvent(QPaintEvent*) {
    if (painting_delay_ms_ > 0) {
        QThread::msleep(static_cast<unsigned long>(painting_delay_ms_));
    }
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!image_.isNull()) {
        painter.drawImage(view_.picture_area(image_.size()), image_);
        painter.setRenderHint(QPainter::Antialiasing);
        paint_overlay(painter, view_, camera_, *shown_);
        if (selection_) {
            paint_selection(painter, view_, selection_->rectangle());
        }
    }
    paint_notes(painter);
    if (hasFocus()) {
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setPen(theme::accent);
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(rect().adjusted(0, 0, -1, -1));
    }
    if (shown_) {
        emit painted(shown_->frame);
    }
}

}  // namespace kambara::ui
