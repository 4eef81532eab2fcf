// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/share_slider.h"

#include <QSignalBlocker>
#include <algorithm>
#include <cmath>

namespace kambara::ui {
namespace {

constexpr int fineness = 1000;
constexpr double arrived_share = 0.005;
constexpr qint64 patience_ms = 4000;

}  // namespace

ShareSlider::ShareSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
    setRange(0, fineness);
    setSingleStep(fineness / 50);
    setPageStep(fineness / 10);
    connect(this, &QSlider::valueChanged, this, [this] {
        asked_ = share();
        since_asked_.start();
        emit share_asked(*asked_);
    });
}

double ShareSlider::share() const {
    return static_cast<double>(value()) / fineness;
}

void ShareSlider::ask_for(double share) {
    setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * fineness)));
}

void ShareSlider::show_share(double share) {
    const bool arrived = asked_ && std::abs(share - *asked_) < arrived_share;
    if (isSliderDown() || (asked_ && !arrived && since_asked_.elapsed() < patience_ms)) {
        return;
    }
    asked_.reset();
    const QSignalBlocker silent(this);
    setValue(static_cast<int>(std::lround(share * fineness)));
}

}  // namespace kambara::ui
