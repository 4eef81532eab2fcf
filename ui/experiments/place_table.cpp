// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/experiments/place_table.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "core/stereo/range_experiment.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

enum Column {
    known_x,
    known_y,
    known_z,
    count,
    spread,
    measured_x,
    measured_y,
    measured_z,
    off,
    off_range,
    columns
};

constexpr int typed_role = Qt::UserRole;  // true: by hand, not read from a file

std::optional<double> number_in(const QTableWidgetItem* item) {
    if (item == nullptr) {
        return std::nullopt;
    }
    bool is_number = false;
    const QString text = item->text().trimmed();
    double value = QLocale().toDouble(text, &is_number);
    if (!is_number) {
        value = QLocale::c().toDouble(text, &is_number);
    }
    return is_number && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool fine_in(const QTableWidgetItem* item) {
    return item->text().trimmed().isEmpty() || number_in(item);
}

}  // namespace

PlaceTable::PlaceTable(QWidget* parent) : QTableWidget(0, columns, parent) {
    setHorizontalHeaderLabels({tr("x mm"), tr("y mm"), tr("z mm"), tr("readings"), tr("spread mm"),
                               tr("measured x mm"), tr("y mm"), tr("z mm"), tr("off mm"),
                               tr("range error %")});
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setMinimumSectionSize(60);
    setSelectionBehavior(QAbstractItemView::SelectItems);
    setTabKeyNavigation(false);
    setAccessibleName(tr("Known places"));
    connect(this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) {
        if (!filling_ && item->column() <= known_z) {
            filling_ = true;
            item->setData(typed_role, true);
            filling_ = false;
            mark(item);
            emit typed(fine_in(item) ? QString() : item->text().trimmed());
            emit known_changed();
        }
    });
}

void PlaceTable::mark(QTableWidgetItem* item) {
    const bool fine = fine_in(item);
    filling_ = true;
    // Struck out as well: where the cell is chosen its colour can't be seen.
    QFont letters = font();
    letters.setStrikeOut(!fine);
    item->setFont(letters);
    item->setForeground(fine ? theme::text : theme::bad);
    item->setToolTip(fine ? QString() : tr("This is no number. Write a length in mm."));
    filling_ = false;
}

void PlaceTable::set_cell(int row, int column, const QString& text) {
    filling_ = true;
    if (item(row, column) == nullptr) {
        auto* made = new QTableWidgetItem;
        made->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        if (column > known_z) {
            made->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
        }
        setItem(row, column, made);
    }
    item(row, column)->setText(text);
    filling_ = false;
}

int PlaceTable::add_place(const std::optional<Eigen::Vector3d>& known) {
    const int row = rowCount();
    insertRow(row);
    readings_.emplace_back();
    for (int column = 0; column < columns; ++column) {
        QString text;
        if (known && column <= known_z) {
            // As many decimals as the number has, within what a tape tells.
            const double value = (*known)[column];
            const bool tenths = std::abs(10.0 * value - std::round(10.0 * value)) < 1e-6;
            text = QLocale().toString(value, 'f', tenths ? 1 : 4);
        }
        set_cell(row, column, text);
    }
    emit known_changed();
    return row;
}

void PlaceTable::remove_chosen() {
    const int row = currentRow();
    if (row >= 0) {
        removeRow(row);
        readings_.erase(readings_.begin() + row);
        emit known_changed();
    }
}

void PlaceTable::remove_all() {
    setRowCount(0);
    readings_.clear();
    emit known_changed();
}

std::optional<Eigen::Vector3d> PlaceTable::known_mm(int row) const {
    const auto at_x = number_in(item(row, known_x));
    const auto at_y = number_in(item(row, known_y));
    const auto at_z = number_in(item(row, known_z));
    return at_x && at_y && at_z ? std::optional(Eigen::Vector3d(*at_x, *at_y, *at_z))
                                : std::nullopt;
}

const std::vector<Eigen::Vector3d>& PlaceTable::readings(int row) const {
    return readings_.at(static_cast<std::size_t>(row));
}

void PlaceTable::set_readings(int row, std::vector<Eigen::Vector3d> readings_in_left_mm) {
    auto& readings = readings_.at(static_cast<std::size_t>(row));
    readings = std::move(readings_in_left_mm);
    const Spread told = spread_of(readings);
    set_cell(row, count,
             readings.empty() ? QString()
                              : QLocale().toString(static_cast<qulonglong>(readings.size())));
    for (int axis = 0; axis < 3; ++axis) {
        set_cell(row, measured_x + axis,
                 readings.empty() ? QString() : QLocale().toString(told.mean_mm[axis], 'f', 1));
    }
    set_cell(row, spread, readings.empty() ? QString() : QLocale().toString(told.rms_mm, 'f', 1));
    filling_ = true;
    item(row, spread)->setForeground(told.steady ? theme::text : theme::bad);
    item(row, spread)
        ->setToolTip(told.steady ? tr("How far the readings lie about their mean, RMS.")
                                 : tr("So far apart that the target has moved, or "
                                      "another one was matched. Measure again."));
    filling_ = false;
}

void PlaceTable::show_difference(int row, const std::optional<Difference>& difference) {
    set_cell(row, off,
             difference ? QLocale().toString(difference->off_mm.norm(), 'f', 2) : QString());
    set_cell(row, off_range,
             difference ? QLocale().toString(difference->range_pct, 'f', 3) : QString());
}

int PlaceTable::measured() const {
    return static_cast<int>(std::count_if(readings_.begin(), readings_.end(),
                                          [](const auto& readings) { return !readings.empty(); }));
}

int PlaceTable::typed_only() const {
    int typed = 0;
    for (int row = 0; row < rowCount(); ++row) {
        bool any = false;
        for (const int column : {known_x, known_y, known_z}) {
            const QTableWidgetItem* one = item(row, column);
            any = any || (one->data(typed_role).toBool() && !one->text().trimmed().isEmpty());
        }
        typed += any && readings(row).empty() ? 1 : 0;
    }
    return typed;
}

int PlaceTable::next_to_measure(int row) const {
    for (int i = 1; i <= rowCount(); ++i) {
        const int other = (row + i) % rowCount();
        if (readings(other).empty()) {
            return other;
        }
    }
    return -1;
}

void PlaceTable::keyPressEvent(QKeyEvent* event) {
    const bool may_change = editTriggers() != QAbstractItemView::NoEditTriggers;
    if (event->key() == Qt::Key_Delete && state() != QAbstractItemView::EditingState) {
        if (!may_change) {
            return;  // a place is being measured
        }
        remove_chosen();
        return;
    }
    QTableWidget::keyPressEvent(event);
}

}  // namespace kambara::ui
