// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/event_log.h"

#include <QHeaderView>
#include <QScrollBar>
#include <QTableWidget>
#include <QTime>
#include <QVBoxLayout>

#include "ui/base/core_text.h"
#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr int most_rows = 1000;

}  // namespace

EventLog::EventLog(QWidget* parent) : QWidget(parent), table_(new QTableWidget(0, 3, this)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(table_);
    table_->setObjectName(QStringLiteral("eventTable"));
    table_->setHorizontalHeaderLabels({tr("Time"), tr("Kind"), tr("What happened")});
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
    table_->setShowGrid(false);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setColumnWidth(
        0, table_->fontMetrics().horizontalAdvance(QStringLiteral("00:00:00")) + 24);
    table_->setColumnWidth(1, table_->fontMetrics().horizontalAdvance(tr("Warning")) + 24);
}

void EventLog::add(const Event& event) {
    add_row(event.kind, translated(event.text));
}

void EventLog::add_note(const QString& text) {
    add_row(Event::Kind::note, text);
}

void EventLog::add_fault(const QString& text) {
    add_row(Event::Kind::fault, text);
}

int EventLog::rows() const {
    return table_->rowCount();
}

bool EventLog::tells(const QString& part) const {
    for (int row = 0; row < table_->rowCount(); ++row) {
        const QTableWidgetItem* item = table_->item(row, table_->columnCount() - 1);
        if (item != nullptr && item->text().contains(part)) {
            return true;
        }
    }
    return false;
}

void EventLog::add_row(Event::Kind kind, const QString& text) {
    const QScrollBar* bar = table_->verticalScrollBar();
    const bool at_end = bar->value() == bar->maximum();
    if (rows() >= most_rows) {
        table_->removeRow(0);
    }
    const int row = rows();
    table_->insertRow(row);
    const QString kinds[] = {tr("Note"), tr("Warning"), tr("Fault")};
    const QColor colours[] = {theme::text, theme::caution, theme::bad};
    const QString texts[] = {QTime::currentTime().toString(QStringLiteral("HH:mm:ss")),
                             kinds[static_cast<int>(kind)], text};
    for (int i = 0; i < 3; ++i) {
        auto* item = new QTableWidgetItem(texts[i]);
        item->setForeground(colours[static_cast<int>(kind)]);
        item->setToolTip(text);
        table_->setItem(row, i, item);
    }
    if (at_end) {
        table_->scrollToBottom();
    }
}

}  // namespace kambara::ui
