// SPDX-License-Identifier: GPL-3.0-or-later
// What the range experiment's window is made of, and what its parts do.
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QStandardPaths>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/experiments/place_table.h"
#include "ui/experiments/range_result.h"
#include "ui/experiments/range_window.h"
#include "ui/experiments/save_row.h"

namespace kambara::ui {

void RangeWindow::build() {
    auto* all = new QVBoxLayout(this);
    tabs_ = new QTabWidget(this);
    tabs_->setObjectName(QStringLiteral("rangeTabs"));
    tabs_->addTab(places_page(), tr("Places"));
    tabs_->addTab(result_page(), tr("Result"));
    tabs_->setTabEnabled(1, false);
    tabs_->setTabToolTip(1, tr("Measure the places and judge them first."));
    all->addWidget(tabs_, 1);
    all->addWidget(foot());
}

QWidget* RangeWindow::places_page() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    auto* options = new QHBoxLayout;
    const auto labelled = [&](const QString& text, QWidget* field) {
        auto* label = new QLabel(text, page);
        label->setBuddy(field);
        options->addWidget(label);
        options->addWidget(field);
        options->addSpacing(16);
    };
    frame_ = new QComboBox(page);
    frame_->setObjectName(QStringLiteral("placesFrame"));
    frame_->addItem(tr("left camera"), QStringLiteral("left"));
    frame_->addItem(tr("rig"), QStringLiteral("rig"));
    frame_->addItem(tr("their own"), QStringLiteral("own"));
    frame_->setToolTip(
        tr("The frame in which the places are known. Their own: it is laid upon the "
           "measured places by least squares, and what is left is judged."));
    labelled(tr("&Frame of the places"), frame_);
    count_ = new QSpinBox(page);
    count_->setObjectName(QStringLiteral("readingsCount"));
    count_->setRange(1, 1000);
    count_->setValue(30);
    count_->setToolTip(
        tr("Positions that are averaged where you measure. The simulated experiment stays at each "
           "place for a second and takes what comes."));
    labelled(tr("Readings a &place"), count_);
    by_tape_ = new QCheckBox(tr("&Baseline by tape:"), page);
    by_tape_->setObjectName(QStringLiteral("rangeByTape"));
    by_tape_->setToolTip(
        tr("The correction is to this baseline. Without it, to the one that suits "
           "the places best."));
    true_baseline_mm_ = new QDoubleSpinBox(page);
    true_baseline_mm_->setRange(1.0, 1e5);
    true_baseline_mm_->setDecimals(2);
    true_baseline_mm_->setSuffix(QStringLiteral("\u202Fmm"));
    true_baseline_mm_->setEnabled(false);
    options->addWidget(by_tape_);
    options->addWidget(true_baseline_mm_);
    options->addStretch(1);
    column->addLayout(options);
    table_ = new PlaceTable(page);
    table_->setObjectName(QStringLiteral("placeTable"));
    empty_ = empty_label(QStringLiteral("rangeEmpty"), page);
    empty_->setMargin(40);
    empty_->setText(
        tr("There are no known places yet.\n\nAdd them one by one, or load a table "
           "whose columns are x_mm, y_mm, z_mm: x to the right, y down, z ahead.\n\n"
           "Then bring the tracked target to each place and measure. The simulated "
           "experiment does all of it by itself, in 75 seconds."));
    column->addWidget(table_, 1);
    column->addWidget(empty_, 1);
    target_ = sentence_label(QStringLiteral("rangeTarget"), page);
    live_ = sentence_label(QStringLiteral("rangeLive"), page);
    live_->setMinimumHeight(live_->fontMetrics().lineSpacing());
    column->addWidget(target_);
    column->addWidget(live_);
    auto* buttons = new QHBoxLayout;
    const auto button = [&](const QString& text, const char* name, bool checkable = false) {
        auto* made = new QPushButton(text, page);
        made->setObjectName(QLatin1String(name));
        made->setCheckable(checkable);
        buttons->addWidget(made);
        return made;
    };
    load_ = button(tr("&Load\u2026"), "loadPlaces");
    add_ = button(tr("&Add a place"), "addPlace");
    remove_ = button(tr("&Remove"), "removePlace");
    clear_ = button(tr("&Clear"), "clearPlaces");
    buttons->addStretch(1);
    simulate_ = button(tr("S&imulated experiment"), "simulateStations", true);
    measure_ = button(tr("&Measure"), "measurePlace", true);
    judge_ = button(tr("&Judge"), "judgePlaces");
    column->addLayout(buttons);
    return page;
}

QWidget* RangeWindow::result_page() {
    auto* page = new QWidget(this);
    auto* column = new QVBoxLayout(page);
    result_ = new RangeResult(page);
    column->addWidget(result_, 1);
    save_table_ = new SaveRow(tr("Table (CSV)"), tr("Save &table"),
                              QStringLiteral("saveRangeTable"), tr("Tables (*.csv)"), page);
    save_page_ = new SaveRow(tr("Report (HTML)"), tr("Save &report"),
                             QStringLiteral("saveRangePage"), tr("Reports (*.html)"), page);
    const QDir folder(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    save_table_->set_file(folder.filePath(QStringLiteral("range_experiment.csv")));
    save_page_->set_file(folder.filePath(QStringLiteral("range_experiment.html")));
    column->addWidget(save_table_);
    column->addWidget(save_page_);
    return page;
}

void RangeWindow::connect_all() {
    connect(load_, &QPushButton::clicked, this, [this] {
        const QString file = QFileDialog::getOpenFileName(this, tr("Known places"), {},
                                                          tr("Tables (*.csv);;All files (*)"));
        if (!file.isEmpty()) {
            load(file);
        }
    });
    connect(add_, &QPushButton::clicked, this, [this] {
        table_->setCurrentCell(table_->add_place(), 0);
        table_->setFocus();
    });
    connect(remove_, &QPushButton::clicked, table_, &PlaceTable::remove_chosen);
    connect(clear_, &QPushButton::clicked, this, [this] {
        if (may_drop(tr("Clear without saving"))) {
            table_->remove_all();
            row_of_station_.clear();
            saved_ = true;
        }
    });
    connect(measure_, &QPushButton::clicked, this, &RangeWindow::measure);
    connect(simulate_, &QPushButton::clicked, this, &RangeWindow::simulate);
    connect(judge_, &QPushButton::clicked, this, &RangeWindow::judge);
    connect(table_, &PlaceTable::known_changed, this, &RangeWindow::changed);
    connect(table_, &PlaceTable::typed, this, [this](const QString& wrong) {
        wrong.isEmpty()
            ? say({})
            : say_failure(tr("\u201C%1\u201D is no number. Write a length in mm.").arg(wrong));
    });
    connect(table_, &QTableWidget::currentCellChanged, this, &RangeWindow::changed);
    connect(frame_, qOverload<int>(&QComboBox::currentIndexChanged), this, &RangeWindow::changed);
    connect(by_tape_, &QCheckBox::toggled, true_baseline_mm_, &QWidget::setEnabled);
    for (SaveRow* row : {save_table_, save_page_}) {
        connect(row, &SaveRow::failed, this, [this](const QString& text) { say_failure(text); });
    }
    connect(save_table_, &SaveRow::save_asked, this,
            [this](const QString& file) { save(file, false); });
    connect(save_page_, &SaveRow::save_asked, this,
            [this](const QString& file) { save(file, true); });
}

}  // namespace kambara::ui
