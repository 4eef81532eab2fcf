// SPDX-License-Identifier: GPL-3.0-or-later
#include <qcustomplot.h>

#include <QGridLayout>
#include <algorithm>
#include <utility>

#include "ui/base/theme.h"
#include "ui/experiments/range_result.h"

namespace kambara::ui {
namespace {

struct RangePlots {
    Q_DECLARE_TR_FUNCTIONS(kambara::ui::RangePlots)
};

void dress(QCPAxis& axis, const QString& label) {
    axis.setLabel(label);
    axis.setBasePen(QPen(theme::line));
    axis.setTickPen(QPen(theme::line));
    axis.setSubTickPen(Qt::NoPen);
    axis.setTickLabelColor(theme::text);
    axis.setLabelColor(theme::text);
    axis.grid()->setPen(QPen(QColor(0x3a, 0x40, 0x49), 0.0, Qt::DotLine));
    axis.grid()->setZeroLinePen(QPen(theme::line));
}

QCustomPlot* made_plot(const QString& x, const QString& y, QWidget* parent) {
    auto* plot = new QCustomPlot(parent);
    plot->setBackground(QBrush(theme::ground));
    plot->setMinimumSize(220, 150);
    dress(*plot->xAxis, x);
    dress(*plot->yAxis, y);
    plot->legend->setVisible(true);
    plot->legend->setBrush(Qt::NoBrush);
    plot->legend->setTextColor(theme::text);
    // Above the plot, where it hides no point.
    plot->legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot->legend->setBorderPen(Qt::NoPen);
    plot->plotLayout()->insertRow(0);
    plot->plotLayout()->addElement(0, 0, plot->legend);
    plot->plotLayout()->setRowStretchFactor(0, 0.001);
    return plot;
}

void add_points(QCustomPlot& plot, const QString& name, const QColor& colour,
                QCPScatterStyle::ScatterShape shape, const QVector<double>& x,
                const QVector<double>& y) {
    QCPGraph* graph = plot.addGraph();
    graph->setName(name);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setPen(QPen(colour, 1.2));
    graph->setScatterStyle(QCPScatterStyle(shape, QPen(colour, 1.2), Qt::NoBrush, 6.0));
    graph->setData(x, y);
}

// Room about the points; a single one, or equal ones, still have an axis.
void fit(QCustomPlot& plot) {
    plot.rescaleAxes();
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        const QCPRange range = axis->range();
        const double least = axis == plot.yAxis ? 0.01 : 25.0;
        const double room = std::max(least, 0.12 * range.size());
        axis->setRange(range.lower - room, range.upper + room);
    }
}

QCustomPlot* error_plot(const RangeExperiment& experiment, int axis, const QString& label,
                        QWidget* parent) {
    auto* plot = made_plot(label, RangePlots::tr("range error, %"), parent);
    const auto add = [&](const RangeErrors& errors, const QString& name, const QColor& colour,
                         QCPScatterStyle::ScatterShape shape) {
        QVector<double> x;
        QVector<double> y;
        for (const StationError& one : errors.stations) {
            x << one.known_in_left_mm[axis];
            y << one.range_error_pct;
        }
        add_points(*plot, name, colour, shape, x, y);
    };
    add(experiment.before, RangePlots::tr("before"), theme::caution, QCPScatterStyle::ssCross);
    add(experiment.after, RangePlots::tr("after"), theme::accent, QCPScatterStyle::ssCircle);
    fit(*plot);
    return plot;
}

QCustomPlot* estimates(const RangeExperiment& experiment, QWidget* parent) {
    auto* plot = made_plot(RangePlots::tr("side x, mm"), RangePlots::tr("depth z, mm"), parent);
    QVector<double> known_x;
    QVector<double> known_z;
    QVector<double> x;
    QVector<double> z;
    for (const StationError& one : experiment.before.stations) {
        known_x << one.known_in_left_mm.x();
        known_z << one.known_in_left_mm.z();
        x << one.measured_in_left_mm.x();
        z << one.measured_in_left_mm.z();
    }
    add_points(*plot, RangePlots::tr("known"), theme::good, QCPScatterStyle::ssCircle, known_x,
               known_z);
    add_points(*plot, RangePlots::tr("measured"), theme::caution, QCPScatterStyle::ssCross, x, z);
    fit(*plot);
    return plot;
}

}  // namespace

QWidget* range_plots(const RangeExperiment& experiment, QWidget* parent) {
    auto* all = new QWidget(parent);
    all->setObjectName(QStringLiteral("rangePlots"));
    auto* grid = new QGridLayout(all);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(error_plot(experiment, 2, RangePlots::tr("depth z, mm"), all), 0, 0);
    grid->addWidget(error_plot(experiment, 1, RangePlots::tr("height y, mm (down)"), all), 0, 1);
    grid->addWidget(error_plot(experiment, 0, RangePlots::tr("side x, mm"), all), 1, 0);
    grid->addWidget(estimates(experiment, all), 1, 1);
    return all;
}

}  // namespace kambara::ui
