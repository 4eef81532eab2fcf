// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/calibration/result_page.h"

#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/base/core_text.h"
#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/calibration/guide_view.h"
#include "ui/calibration/range_map.h"
#include "ui/calibration/residual_plot.h"

namespace kambara::ui {

ResultPage::ResultPage(QWidget* parent) : QWidget(parent) {
    auto* page = new QVBoxLayout(this);
    verdict_ = new QLabel(this);
    verdict_->setObjectName(QStringLiteral("calibrationVerdict"));
    verdict_->setMargin(8);
    QFont large = font();
    large.setPointSizeF(1.5 * large.pointSizeF());
    verdict_->setFont(large);
    reasons_ = new QLabel(this);
    reasons_->setObjectName(QStringLiteral("calibrationReasons"));
    reasons_->setWordWrap(true);
    tabs_ = new QTabWidget(this);
    tabs_->setObjectName(QStringLiteral("resultTabs"));
    numbers_ = new QTableWidget(0, 2, this);
    numbers_->setObjectName(QStringLiteral("calibrationNumbers"));
    numbers_->horizontalHeader()->hide();
    numbers_->verticalHeader()->hide();
    numbers_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    numbers_->horizontalHeader()->setStretchLastSection(true);
    numbers_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    page->addWidget(verdict_);
    page->addWidget(reasons_);
    page->addWidget(tabs_, 1);
    auto* files = new QGridLayout;
    const auto row = [&](int at, const QString& label, const QString& action, const char* name,
                         QLineEdit*& edit, QPushButton*& save) {
        edit = new QLineEdit(this);
        edit->setObjectName(QLatin1String(name) + QStringLiteral("File"));
        auto* choose = new QPushButton(tr("Choose\u2026"), this);
        save = new QPushButton(action, this);
        save->setObjectName(QLatin1String(name));
        files->addWidget(new QLabel(label, this), at, 0);
        files->addWidget(edit, at, 1);
        files->addWidget(choose, at, 2);
        files->addWidget(save, at, 3);
        QLineEdit* const field = edit;
        connect(choose, &QPushButton::clicked, this, [this, field, label] {
            const QString chosen = QFileDialog::getSaveFileName(this, label, field->text());
            if (!chosen.isEmpty()) {
                field->setText(chosen);
            }
        });
    };
    row(0, tr("Rig file"), tr("&Save rig"), "saveRig", rig_file_, save_rig_);
    row(1, tr("Report (HTML)"), tr("Save &report"), "saveReport", report_file_, save_report_);
    page->addLayout(files);
    auto* last = new QHBoxLayout;
    auto* back = new QPushButton(tr("&Back to the shots"), this);
    back->setObjectName(QStringLiteral("backToShots"));
    said_ = new QLabel(this);
    said_->setObjectName(QStringLiteral("savedNote"));
    said_->setWordWrap(true);
    last->addWidget(back);
    last->addWidget(said_, 1);
    page->addLayout(last);
    connect(back, &QPushButton::clicked, this, &ResultPage::back_asked);
    connect(save_rig_, &QPushButton::clicked, this,
            [this] { emit save_rig_asked(rig_file_->text()); });
    connect(save_report_, &QPushButton::clicked, this,
            [this] { emit save_report_asked(report_file_->text()); });
}

void ResultPage::show_outcome(const SessionOutcomePtr& outcome, const QString& folder) {
    const CalibrationReport& report = outcome->report;
    const bool refused = report.verdict == Verdict::refused;
    switch (report.verdict) {
        case Verdict::good:
            verdict_->setText(tr("Verdict: good"));
            break;
        case Verdict::usable:
            verdict_->setText(tr("Verdict: usable"));
            break;
        case Verdict::refused:
            verdict_->setText(tr("Verdict: refused"));
            break;
    }
    const QColor colour = report.verdict == Verdict::good     ? theme::good
                          : report.verdict == Verdict::usable ? theme::caution
                                                              : theme::bad;
    verdict_->setStyleSheet(QStringLiteral("background: %1; color: black").arg(colour.name()));
    QStringList sentences;
    for (const auto* list : {&report.reasons, &report.notes}) {
        for (const std::string& sentence : *list) {
            sentences << translated(sentence);
        }
    }
    if (sentences.isEmpty()) {
        sentences << tr("Nothing speaks against it. Save the rig, then use it for tracking.");
    }
    reasons_->setText(sentences.join(QLatin1Char('\n')));
    numbers_->setParent(this);
    while (tabs_->count() > 0) {
        QWidget* tab = tabs_->widget(0);
        tabs_->removeTab(0);
        if (tab != numbers_) {
            tab->deleteLater();
        }
    }
    auto* residuals = new QWidget(this);
    auto* beside = new QHBoxLayout(residuals);
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (report.cameras[c]) {
            auto* plot = new ResidualPlot(c, report, residuals);
            plot->setObjectName(QStringLiteral("residuals%1").arg(c));
            beside->addWidget(plot, 1);
        }
    }
    auto* ranges = new RangeMap(report.range_errors, this);
    ranges->setObjectName(QStringLiteral("rangeMap"));
    fill_numbers(*outcome);
    tabs_->addTab(residuals, tr("Residuals"));
    tabs_->addTab(ranges, tr("Range errors"));
    tabs_->addTab(numbers_, tr("Numbers"));
    const QDir results(QDir(folder).filePath(QStringLiteral("result")));
    rig_file_->setText(results.filePath(QStringLiteral("rig.yaml")));
    report_file_->setText(results.filePath(QStringLiteral("report.html")));
    save_rig_->setEnabled(!refused);
    save_rig_->setToolTip(refused ? tr("A refused calibration gives no rig: take more shots.")
                                  : tr("Writes the rig with the pictures' hashes, settings, date"));
    said_->clear();
}

void ResultPage::fill_numbers(const SessionOutcome& outcome) {
    numbers_->setRowCount(0);
    const auto add = [this](const QString& name, const QString& value) {
        const int row = numbers_->rowCount();
        numbers_->insertRow(row);
        numbers_->setItem(row, 0, new QTableWidgetItem(name));
        numbers_->setItem(row, 1, new QTableWidgetItem(value));
    };
    const CalibrationReport& report = outcome.report;
    add(tr("Shots used"), tr("%1 of %2").arg(report.views_used).arg(outcome.numbers.size()));
    add(tr("Corners used"), tr("%1 of %2").arg(report.corners_used).arg(report.corners_total));
    add(tr("Residuals"), pixels(report.rms_px, 3));
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (const auto& pair = report.pairs[c]) {
            add(tr("Left to %1").arg(camera_title(c)),
                QStringLiteral("%1 \u00B1 %2")
                    .arg(millimetres(pair->baseline_mm, 2),
                         millimetres(pair->baseline_sigma_mm, 2)));
        }
    }
    if (report.held_out) {
        add(tr("Lengths in shots that took no part"),
            tr("%1 off in the mean").arg(millimetres(report.held_out->mean_error_mm, 3)));
    }
    for (std::size_t c = 0; c < most_cameras; ++c) {
        if (report.cameras[c]) {
            for (const NamedValue& value : report.cameras[c]->parameters) {
                add(camera_title(c) + QStringLiteral(": ") + QString::fromStdString(value.name),
                    QStringLiteral("%1 \u00B1 %2")
                        .arg(QLocale().toString(value.value, 'g', 7),
                             QLocale().toString(value.sigma, 'g', 2)));
            }
        }
    }
    for (const RejectedView& view : report.views_rejected) {
        const int number = outcome.numbers.at(static_cast<std::size_t>(view.view));
        add(tr("Shot %1 left out").arg(number),
            QString::fromStdString(view.camera.empty() ? "" : view.camera + ": ") +
                translated(view.reason));
    }
}

void ResultPage::say(const QString& text, const QColor& colour) {
    said_->setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
    said_->setText(text);
}

void ResultPage::show_saved(const QString& file) {
    say(tr("Saved: %1").arg(file), theme::good);
}

void ResultPage::show_failure(const QString& text) {
    say(text, theme::bad);
}

}  // namespace kambara::ui
