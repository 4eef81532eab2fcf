// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/devices/lens_controls.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>

#include "ui/base/quantities.h"
#include "ui/devices/share_slider.h"

namespace kambara::ui {
namespace {

constexpr double zoom_step = 0.05;

// With its use as its tooltip, or why it has none.
void allow(QWidget* part, bool able, const QString& help, const QString& reason_not) {
    part->setEnabled(able);
    part->setToolTip(able ? help : reason_not);
}

}  // namespace

LensControls::LensControls(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(4);
    grid->setColumnStretch(1, 1);
    build_zoom(grid);
    build_focus(grid);
    build_presets(grid);
    show_head(std::nullopt);
}

QLabel* LensControls::label(const QString& text) {
    auto* made = new QLabel(text, this);
    labels_px_ = std::max(labels_px_, made->sizeHint().width());
    return made;
}

QToolButton* LensControls::button(const QString& text, const char* object_name) {
    auto* made = new QToolButton(this);
    made->setText(text);
    made->setObjectName(QLatin1String(object_name));
    return made;
}

void LensControls::build_zoom(QGridLayout* grid) {
    wider_ = button(QStringLiteral("\u2212"), "zoomOut");
    narrower_ = button(QStringLiteral("+"), "zoomIn");
    wider_->setAccessibleName(tr("Zoom out"));
    narrower_->setAccessibleName(tr("Zoom in"));
    zoom_ = new ShareSlider(this);
    zoom_->setObjectName(QStringLiteral("zoomSlider"));
    zoom_->setAccessibleName(tr("Zoom"));
    for (QToolButton* one : {wider_, narrower_}) {
        one->setAutoRepeat(true);
        one->setFixedWidth(one->fontMetrics().height() + 8);
        const double step = one == narrower_ ? zoom_step : -zoom_step;
        connect(one, &QToolButton::clicked, this,
                [this, step] { zoom_->ask_for(zoom_->share() + step); });
    }
    view_ = new QLabel(this);
    view_->setObjectName(QStringLiteral("zoomView"));
    view_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const QString widest =
        QStringLiteral("%1\u00D7  %2").arg(QLocale().toString(12.0, 'f', 1), degrees(0.85));
    view_->setMinimumWidth(view_->fontMetrics().horizontalAdvance(widest) + 4);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(wider_);
    row->addWidget(zoom_, 1);
    row->addWidget(narrower_);
    grid->addWidget(label(tr("Zoom")), 0, 0);
    grid->addLayout(row, 0, 1);
    grid->addWidget(view_, 0, 2);
    connect(zoom_, &ShareSlider::share_asked, this,
            [this](double share) { emit asked(ZoomHead{share}); });
}

void LensControls::build_focus(QGridLayout* grid) {
    focus_ = new ShareSlider(this);
    focus_->setObjectName(QStringLiteral("focusSlider"));
    focus_->setAccessibleName(tr("Focus"));
    autofocus_ = new QCheckBox(tr("Autofocus"), this);
    autofocus_->setObjectName(QStringLiteral("autofocus"));
    grid->addWidget(label(tr("Focus")), 1, 0);
    grid->addWidget(focus_, 1, 1);
    grid->addWidget(autofocus_, 1, 2, Qt::AlignRight);
    connect(focus_, &ShareSlider::share_asked, this,
            [this](double share) { emit asked(FocusHead{share}); });
    connect(autofocus_, &QCheckBox::clicked, this, [this](bool on) {
        if (on) {
            emit asked(AutofocusHead{});
        } else {
            emit asked(FocusHead{focus_->share()});  // stays where it is
        }
    });
}

void LensControls::build_presets(QGridLayout* grid) {
    preset_ = new QSpinBox(this);
    preset_->setObjectName(QStringLiteral("preset"));
    preset_->setAccessibleName(tr("Preset"));
    keep_ = button(tr("Keep"), "keepPreset");
    recall_ = button(tr("Recall"), "recallPreset");
    for (QToolButton* one : {keep_, recall_}) {
        one->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    row->addWidget(preset_);
    row->addWidget(keep_, 1);
    row->addWidget(recall_, 1);
    grid->addWidget(label(tr("Preset")), 2, 0);
    grid->addLayout(row, 2, 1, 1, 2);
    connect(keep_, &QToolButton::clicked, this,
            [this] { emit asked(KeepPreset{preset_->value()}); });
    connect(recall_, &QToolButton::clicked, this,
            [this] { emit asked(RecallPreset{preset_->value()}); });
}

void LensControls::show_head(const std::optional<HeadSnapshot>& head) {
    const HeadAbilities able = head ? head->abilities : HeadAbilities{};
    const QString no_head = tr("There is no pan-tilt head.");
    const auto lacking = [&](const QString& reason) { return head ? reason : no_head; };
    const QString no_zoom = lacking(tr("This head has no zoom."));
    allow(zoom_, able.zoom, tr("From wide to tele"), no_zoom);
    allow(wider_, able.zoom, tr("Zooms out"), no_zoom);
    allow(narrower_, able.zoom, tr("Zooms in"), no_zoom);
    allow(focus_, able.focus, tr("From far to near; autofocus ends with it"),
          lacking(tr("This head has no focus.")));
    allow(autofocus_, able.autofocus, tr("The camera focuses by itself"),
          lacking(tr("This head has no autofocus.")));
    const QString no_presets = lacking(tr("This head has no presets."));
    allow(preset_, able.presets > 0, tr("Number of the preset"), no_presets);
    allow(keep_, able.presets > 0, tr("Keeps where the head looks, its zoom and focus"),
          no_presets);
    allow(recall_, able.presets > 0, tr("Goes back to what was kept under this number"),
          no_presets);
    preset_->setRange(0, std::max(0, able.presets - 1));
    if (!head || !head->lens) {
        view_->setText(QStringLiteral("\u2013"));
        view_->setToolTip(head ? tr("The head does not tell of its lens.") : no_head);
        return;
    }
    const LensStatus& lens = *head->lens;
    zoom_->show_share(lens.zoom_share);
    focus_->show_share(lens.focus_share);
    autofocus_->setChecked(lens.autofocus);
    if (lens.horizontal_view_rad > 0.0) {
        view_->setText(QStringLiteral("%1\u00D7  %2")
                           .arg(QLocale().toString(lens.magnification(), 'f', 1),
                                degrees(lens.horizontal_view_rad)));
        view_->setToolTip(tr("Magnification, and the angle of view across, in air"));
    } else {
        view_->setText(percent(lens.zoom_share));
        view_->setToolTip(tr("Share of the zoom's way; this lens' angles are not known"));
    }
}

}  // namespace kambara::ui
