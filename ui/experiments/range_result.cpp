// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/range_result.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/base/quantities.h"
#include "ui/base/theme.h"
#include "ui/experiments/assistant_window.h"

namespace kambara::ui {
namespace {

QColor colour_of(RangeVerdict verdict) {
    switch (verdict) {
        case RangeVerdict::good:
            return theme::good;
        case RangeVerdict::not_good:
            return theme::bad;
        case RangeVerdict::good_corrected:
        case RangeVerdict::moved:
        case RangeVerdict::too_few_places:
            break;
    }
    return theme::caution;
}

qlonglong moved_places(const RangeExperiment& experiment) {
    const auto& stations = experiment.before.stations;
    return std::count_if(stations.begin(), stations.end(),
                         [](const StationError& one) { return !one.steady; });
}

}  // namespace

RangeResult::RangeResult(QWidget* parent)
    : QWidget(parent),
      verdict_(new QLabel(this)),
      sentence_(sentence_label(QStringLiteral("rangeSentence"), this)),
      numbers_(new QTableWidget(2, 7, this)),
      column_(new QVBoxLayout(this)) {
    verdict_->setObjectName(QStringLiteral("rangeVerdict"));
    verdict_->setMargin(8);
    verdict_->setWordWrap(true);
    QFont large = font();
    large.setPointSizeF(1.3 * large.pointSizeF());
    verdict_->setFont(large);
    numbers_->setObjectName(QStringLiteral("rangeNumbers"));
    numbers_->setHorizontalHeaderLabels({tr("baseline"), tr("range, mean"), tr("range, worst"),
                                         tr("depth, mean"), tr("depth, worst"),
                                         tr("position, mean"), tr("position, worst")});
    numbers_->setVerticalHeaderLabels({tr("before"), tr("after")});
    numbers_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    numbers_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    numbers_->setFixedHeight(numbers_->horizontalHeader()->sizeHint().height() +
                             2 * numbers_->verticalHeader()->defaultSectionSize() + 4);
    numbers_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    column_->addWidget(verdict_);
    column_->addWidget(sentence_);
    column_->addWidget(numbers_);
}

QString RangeResult::verdict(const RangeExperiment& experiment,
                             const std::function<QString(const RangeErrors&)>& numbers) {
    switch (experiment.verdict) {
        case RangeVerdict::good:
            return tr("Good without any correction: %1").arg(numbers(experiment.before));
        case RangeVerdict::good_corrected:
            return tr("Good after the correction of the baseline: %1")
                .arg(numbers(experiment.after));
        case RangeVerdict::not_good:
            return tr("Not good, even after the correction: %1").arg(numbers(experiment.after));
        case RangeVerdict::moved:
            return tr("No verdict: the target moved while it was measured, at %1 of the places. "
                      "Their spread is red in the table: let it stand still and measure there "
                      "again.")
                .arg(moved_places(experiment));
        case RangeVerdict::too_few_places:
            break;
    }
    return tr("Not good without a correction: %1. A baseline that is fitted to fewer than %2 "
              "places "
              "proves nothing: measure more, or give the baseline by tape.")
        .arg(numbers(experiment.before))
        .arg(least_stations_to_correct);
}

void RangeResult::show_experiment(const RangeExperiment& experiment, double baseline_mm) {
    const auto percents = [](double value) { return percent(0.01 * value, 3); };
    const auto fill = [&](int row, double baseline, const RangeErrors& errors) {
        const QString cells[] = {millimetres(baseline, 2),
                                 percents(errors.mean_range_pct),
                                 percents(errors.worst_range_pct),
                                 percents(errors.mean_depth_pct),
                                 percents(errors.worst_depth_pct),
                                 millimetres(errors.mean_position_mm, 2),
                                 millimetres(errors.worst_position_mm, 2)};
        int column = 0;
        for (const QString& cell : cells) {
            auto* item = new QTableWidgetItem(cell);
            item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
            numbers_->setItem(row, column++, item);
        }
    };
    fill(0, baseline_mm, experiment.before);
    fill(1, experiment.corrected_baseline_mm, experiment.after);
    const auto numbers = [&](const RangeErrors& errors) {
        return tr("range error %1 in the mean, %2 at worst")
            .arg(percents(errors.mean_range_pct), percents(errors.worst_range_pct));
    };
    verdict_->setText(verdict(experiment, numbers));
    verdict_->setStyleSheet(
        QStringLiteral("background: %1; color: black").arg(colour_of(experiment.verdict).name()));
    QString text = tr("Places: %1. Good is what 1999 reached with a corrected baseline: %2 in the "
                      "mean, %3 at worst.")
                       .arg(experiment.before.stations.size())
                       .arg(percent(0.01 * mean_range_error_1999_pct, 2),
                            percent(0.01 * worst_range_error_1999_pct, 2));
    text += QLatin1Char(' ');
    if (!experiment.baseline_found) {
        text += tr("The corrected baseline was measured by other means.");
    } else if (experiment.before.stations.size() == 1) {
        text += tr("The corrected baseline rests on one place alone.");
    } else {
        text +=
            tr("The corrected baseline is the one that suits these places best, \u00B1\u00A0%1: "
               "what is left after it says nothing of scale.")
                .arg(millimetres(experiment.corrected_baseline_sigma_mm, 3));
    }
    sentence_->setText(text);
    delete plots_;
    plots_ = range_plots(experiment, this);
    column_->addWidget(plots_, 1);
}

}  // namespace kambara::ui
