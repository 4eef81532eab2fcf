// SPDX-License-Identifier: GPL-3.0-or-later
// What the zoom calibration's window is made of, and what can be done in it when.
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QStandardPaths>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/experiments/save_row.h"
#include "ui/experiments/zoom_window.h"

namespace kambara::ui {

void ZoomWindow::build() {
    auto* all = new QVBoxLayout(this);
    state_ = sentence_label(QStringLiteral("zoomState"), this);
    state_->setMinimumHeight(2 * state_->fontMetrics().lineSpacing());
    all->addWidget(state_);
    table_ = new QTableWidget(0, 6, this);
    table_->setObjectName(QStringLiteral("zoomPlaces"));
    table_->setHorizontalHeaderLabels({tr("zoom"), tr("enlarges"), tr("deviation"),
                                       tr("by the head's table"), tr("points"), tr("residual")});
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->setTabKeyNavigation(false);
    table_->setAccessibleName(tr("Places of the zoom"));
    all->addWidget(table_, 1);
    empty_ = empty_label(QStringLiteral("zoomEmpty"), this);
    empty_->setText(
        tr("Nothing is measured yet.\n\nTurn the head to a scene at rest with much detail, some "
           "metres away, and go through the zoom: the lens goes from wide to tele by itself, and "
           "from each picture to the next it is measured how much larger things have become.\n\n"
           "What a maker's table says between the ends of a zoom is seldom known; this is what "
           "this head does."));
    all->addWidget(empty_, 1);
    verdict_ = sentence_label(QStringLiteral("zoomVerdict"), this);
    all->addWidget(verdict_);
    auto* row = new QHBoxLayout;
    go_ = new QPushButton(this);
    go_->setObjectName(QStringLiteral("zoomGo"));
    go_->setCheckable(true);
    row->addWidget(go_);
    row->addStretch(1);
    kind_ = new QComboBox(this);
    kind_->setObjectName(QStringLiteral("zoomKind"));
    for (const HeadKindLens& kind : ports_.head_kinds) {
        kind_->addItem(QString::fromStdString(kind.name));
    }
    kind_->setCurrentIndex(-1);  // which one is there, nobody but the operator knows for sure
    auto* label = new QLabel(tr("&Kind of head"), this);
    label->setBuddy(kind_);
    row->addWidget(label);
    row->addWidget(kind_);
    const auto millimetre_field = [&](const QString& text, const char* name, double most) {
        auto* field = new QDoubleSpinBox(this);
        field->setObjectName(QLatin1String(name));
        field->setRange(0.0, most);
        field->setDecimals(3);
        field->setSuffix(tr(" mm"));
        field->setSpecialValueText(tr("not known"));
        auto* its_label = new QLabel(text, this);
        its_label->setBuddy(field);
        row->addWidget(its_label);
        row->addWidget(field);
        return field;
    };
    widest_ = millimetre_field(tr("&Widest focal length"), "zoomWidest", 1000.0);
    sensor_ = millimetre_field(tr("sensor's &width"), "zoomSensor", 100.0);
    all->addLayout(row);
    save_ = new SaveRow(tr("Table of &heads"), tr("&Save table"), QStringLiteral("saveZoom"),
                        tr("Tables of heads (*.yaml)"), this);
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    save_->set_file(folder.filePath(QStringLiteral("heads.yaml")));
    all->addWidget(save_);
    all->addWidget(foot());
}

void ZoomWindow::changed() {
    const bool idle = doing_ == Doing::nothing;
    const QString why_not = hindrance();
    table_->setVisible(!taken_.empty());
    empty_->setVisible(taken_.empty());
    go_->setChecked(doing_ == Doing::zooming);
    go_->setText(doing_ == Doing::zooming ? tr("&Stop") : tr("&Go through the zoom"));
    go_->setEnabled(doing_ == Doing::zooming || (idle && why_not.isEmpty()));
    go_->setToolTip(why_not);
    const bool lens_known = widest_->value() > 0.0 && sensor_->value() > 0.0;
    save_->allow(idle && !places_.empty() && kind_->currentIndex() >= 0 && lens_known,
                 places_.empty() ? tr("Go through the zoom first: there is no curve.")
                 : kind_->currentIndex() < 0
                     ? tr("Choose the kind of head first.")
                     : tr("Tell the lens' focal length at its widest and the sensor's width first: "
                          "the head's manual has them."));
}

void ZoomWindow::show_lens_of_kind() {
    const auto index = static_cast<std::size_t>(std::max(0, kind_->currentIndex()));
    if (index < ports_.head_kinds.size()) {
        widest_->setValue(ports_.head_kinds[index].widest_f_mm);
        sensor_->setValue(ports_.head_kinds[index].sensor_width_mm);
    }
    changed();
}

}  // namespace kambara::ui
