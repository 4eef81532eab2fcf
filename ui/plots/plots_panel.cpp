// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plots/plots_panel.h"

#include <qcustomplot.h>

#include <QGridLayout>
#include <QLabel>
#include <QLocale>
#include <QMouseEvent>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <limits>

#include "ui/base/theme.h"
#include "ui/plots/time_series.h"

namespace kambara::ui {
namespace {

constexpr double window_s = 60.0;
constexpr int drawing_ms = 50;
constexpr int columns = 3;
constexpr double fine_below = 5.0;  // a range whose ticks are no whole numbers
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

void dress(QCPAxis& axis) {
    axis.setBasePen(QPen(theme::line));
    axis.setTickPen(QPen(theme::line));
    axis.setSubTickPen(Qt::NoPen);
    axis.setTickLabelColor(theme::text);
    axis.setLabelColor(theme::text);
    axis.grid()->setPen(QPen(QColor(0x3a, 0x40, 0x49), 0.0, Qt::DotLine));
    axis.grid()->setZeroLinePen(Qt::NoPen);
    axis.setTickLabelPadding(3);
    axis.setLabelPadding(2);
}

}  // namespace

struct PlotsPanel::Strip {
    QString name;
    QString unit;
    int decimals;
    TimeSeries series{window_s};
    QCustomPlot* plot = nullptr;
};

PlotsPanel::PlotsPanel(QWidget* parent) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(4, 4, 4, 4);
    grid->setSpacing(4);
    add_strip(tr("x"), QStringLiteral("mm"), 1);
    add_strip(tr("y"), QStringLiteral("mm"), 1);
    add_strip(tr("z"), QStringLiteral("mm"), 1);
    add_strip(tr("Quality"), QStringLiteral("%"), 0);
    add_strip(tr("Rate"), QStringLiteral("Hz"), 1);
    add_strip(tr("Latency"), QStringLiteral("ms"), 1);
    pause_ = new QToolButton(this);
    pause_->setObjectName(QStringLiteral("pausePlots"));
    pause_->setText(tr("Pause plots"));
    pause_->setToolTip(tr("Holds the drawing; nothing that comes meanwhile is lost."));
    pause_->setCheckable(true);
    cursor_ = new QLabel(this);
    cursor_->setObjectName(QStringLiteral("plotCursor"));
    cursor_->setText(tr("Point at a plot to read values off."));
    cursor_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    grid->addWidget(pause_, 2, 0, Qt::AlignLeft);
    grid->addWidget(cursor_, 2, 1, 1, 2);
    connect(&drawing_, &QTimer::timeout, this, &PlotsPanel::draw);
    connect(pause_, &QToolButton::toggled, this, [this] { changed_ = true; });
    drawing_.start(drawing_ms);
}

PlotsPanel::~PlotsPanel() = default;

void PlotsPanel::add_strip(const QString& name, const QString& unit, int decimals) {
    auto strip = std::make_unique<Strip>(Strip{name, unit, decimals});
    auto* plot = new QCustomPlot(this);
    strip->plot = plot;
    plot->setBackground(QBrush(theme::ground));
    plot->setMinimumSize(120, 70);
    plot->setNoAntialiasingOnDrag(true);
    plot->setPlottingHints(QCP::phFastPolylines);
    plot->addGraph();
    plot->graph(0)->setPen(QPen(theme::accent, 1.0));
    plot->graph(0)->setAntialiased(false);
    dress(*plot->xAxis);
    dress(*plot->yAxis);
    plot->xAxis->setNumberFormat(QStringLiteral("f"));
    plot->xAxis->setNumberPrecision(0);
    plot->yAxis->setNumberFormat(QStringLiteral("f"));
    plot->yAxis->setNumberPrecision(0);
    plot->yAxis->ticker()->setTickCount(3);
    auto twenties = QSharedPointer<QCPAxisTickerFixed>::create();
    twenties->setTickStep(20.0);
    plot->xAxis->setTicker(twenties);
    plot->axisRect()->setMinimumMargins(QMargins(44, 0, 6, 4));
    QFont small = font();
    small.setPointSizeF(0.85 * small.pointSizeF());
    for (QCPAxis* axis : {plot->xAxis, plot->yAxis}) {
        axis->setTickLabelFont(small);
        axis->setLabelFont(small);
    }
    // Above the plot: beside a low one there is no room for long names.
    auto* title = new QCPTextElement(plot, QStringLiteral("%1 (%2)").arg(name, unit), small);
    title->setTextColor(theme::text);
    plot->plotLayout()->insertRow(0);
    plot->plotLayout()->addElement(0, 0, title);
    plot->plotLayout()->setRowSpacing(0);
    connect(plot, &QCustomPlot::mouseMove, this, [this, plot](QMouseEvent* event) {
        read_off(plot->xAxis->pixelToCoord(event->pos().x()));
    });
    const int place = static_cast<int>(strips_.size());
    if (place >= columns) {
        plot->xAxis->setLabel(tr("time (s)"));
    }
    static_cast<QGridLayout*>(layout())->addWidget(plot, place / columns, place % columns);
    strips_.push_back(std::move(strip));
}

bool PlotsPanel::paused() const {
    return pause_->isChecked();
}

void PlotsPanel::set_paused(bool paused) {
    pause_->setChecked(paused);
}

int PlotsPanel::samples_shown() const {
    return strips_.front()->plot->graph(0)->dataCount();
}

void PlotsPanel::add(const Snapshot& snapshot) {
    const double time_s = static_cast<double>(snapshot.time_ns) * 1e-9;
    const TrackSnapshot* track = steered_track(snapshot);
    const auto position = track != nullptr ? track->estimate.position : std::nullopt;
    const double values[] = {
        position ? position->point_in_left_mm.x() : nothing,
        position ? position->point_in_left_mm.y() : nothing,
        position ? position->point_in_left_mm.z() : nothing,
        track != nullptr ? 100.0 * track->estimate.quality : nothing,
        snapshot.rate_hz,
        snapshot.latency_ms,
    };
    for (std::size_t i = 0; i < strips_.size(); ++i) {
        strips_[i]->series.add(time_s, values[i]);
    }
    changed_ = true;
}

void PlotsPanel::clear() {
    for (auto& strip : strips_) {
        strip->series.clear();
    }
    changed_ = true;
}

void PlotsPanel::draw() {
    if (!changed_ || paused() || !isVisible()) {
        return;
    }
    changed_ = false;
    QVector<double> times_s;
    QVector<double> values;
    for (auto& strip : strips_) {
        QCustomPlot& plot = *strip->plot;
        strip->series.decimated(plot.axisRect()->width(), times_s, values);
        plot.graph(0)->setData(times_s, values, true);
        const double now_s = strip->series.newest_s();
        plot.xAxis->setRange(std::max(0.0, now_s - window_s), std::max(now_s, window_s));
        bool found = false;
        QCPRange range = plot.graph(0)->getValueRange(found);
        if (found) {
            const double pad = std::max(0.1 * range.size(), 1.0);
            // What is never below zero has no axis there.
            const double lower = range.lower - pad;
            plot.yAxis->setRange(range.lower >= 0.0 ? std::max(0.0, lower) : lower,
                                 range.upper + pad);
            // Two ticks never read the same.
            plot.yAxis->setNumberPrecision(plot.yAxis->range().size() < fine_below ? 1 : 0);
        }
        plot.replot(QCustomPlot::rpQueuedReplot);
    }
}

void PlotsPanel::read_off(double time_s) {
    QStringList parts{tr("at %1 s").arg(locale().toString(time_s, 'f', 2))};
    for (const auto& strip : strips_) {
        const double value = strip->series.at(time_s);
        parts << (std::isfinite(value)
                      ? QStringLiteral("%1 %2 %3")
                            .arg(strip->name, locale().toString(value, 'f', strip->decimals),
                                 strip->unit)
                      : QStringLiteral("%1 \u2013").arg(strip->name));
    }
    cursor_->setText(parts.join(QStringLiteral("    ")));
}

}  // namespace kambara::ui
