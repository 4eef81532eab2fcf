// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/playback_bar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QSignalBlocker>
#include <QSlider>
#include <QStyle>
#include <QStyleOptionSlider>
#include <QToolButton>

#include "ui/base/quantities.h"

namespace kambara::ui {

namespace {

// A press beside the handle brings it there.
class SeekSlider final : public QSlider {
  public:
    using QSlider::QSlider;

  protected:
    void mousePressEvent(QMouseEvent* event) override {
        if (event->button() == Qt::LeftButton) {
            QStyleOptionSlider option;
            initStyleOption(&option);
            const QRect handle =
                style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
            if (!handle.contains(event->pos())) {
                setSliderPosition(QStyle::sliderValueFromPosition(
                    minimum(), maximum(), event->pos().x() - handle.width() / 2,
                    width() - handle.width()));
            }
        }
        QSlider::mousePressEvent(event);
    }
};

}  // namespace

PlaybackBar::PlaybackBar(QAction* play, QAction* step, QWidget* parent) : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 2, 6, 2);
    for (QAction* action : {play, step}) {
        auto* button = new QToolButton(this);
        button->setDefaultAction(action);
        row->addWidget(button);
    }
    slider_ = new SeekSlider(Qt::Horizontal, this);
    slider_->setObjectName(QStringLiteral("seekSlider"));
    slider_->setToolTip(tr("Frame of the recording"));
    slider_->setTracking(false);  // one seek when the handle is let go, not one a pixel
    row->addWidget(slider_, 1);
    place_ = new QLabel(this);
    place_->setObjectName(QStringLiteral("playbackPlace"));
    place_->setMinimumWidth(place_->fontMetrics().horizontalAdvance(
        tr("frame %1 of %2,  %3")
            .arg(QStringLiteral("000,000"), QStringLiteral("000,000"),
                 QStringLiteral("0,000.00 s"))));
    row->addWidget(place_);
    connect(slider_, &QSlider::valueChanged, this, [this](int frame) { emit seek_asked(frame); });
}

void PlaybackBar::show_snapshot(const Snapshot& snapshot) {
    const bool known = snapshot.frames_total > 0;
    slider_->setEnabled(known);
    if (known && !slider_->isSliderDown()) {
        const QSignalBlocker quiet(slider_);
        slider_->setRange(0, static_cast<int>(snapshot.frames_total - 1));
        slider_->setPageStep(
            static_cast<int>(std::max<std::int64_t>(1, snapshot.frames_total / 20)));
        slider_->setValue(static_cast<int>(snapshot.frame));
    }
    const QString time = seconds(static_cast<double>(snapshot.time_ns) * 1e-9);
    place_->setText(
        known ? tr("frame %1 of %2,  %3")
                    .arg(locale().toString(static_cast<qlonglong>(snapshot.frame)),
                         locale().toString(static_cast<qlonglong>(snapshot.frames_total)), time)
              : tr("frame %1,  %2")
                    .arg(locale().toString(static_cast<qlonglong>(snapshot.frame)), time));
}

}  // namespace kambara::ui
