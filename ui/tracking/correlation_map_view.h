// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>

#include "core/vsystem/snapshot.h"

namespace kambara::ui {

/// How like the template every place of the search window is, live, as a heat map with its scale;
/// a cross marks the best place. The colours' range can be stretched to what the map holds.
class CorrelationMapView : public QWidget {
    Q_OBJECT
  public:
    explicit CorrelationMapView(QWidget* parent = nullptr);

    void show_snapshot(const SnapshotPtr& snapshot);
    void clear();
    void set_stretched(bool stretched);
    bool has_map() const { return search_ && !search_->map.empty(); }

    QSize sizeHint() const override { return {260, 220}; }
    QSize minimumSizeHint() const override { return {140, 120}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void colour();
    void paint_scale(QPainter& painter, const QRect& bar) const;

    std::shared_ptr<const SearchDetail> search_;
    bool lost_ = false;
    QImage image_;
    QPoint best_;
    double lowest_ = 0.0;  // of the colours' range
    double highest_ = 1.0;
    bool stretched_ = false;
};

}  // namespace kambara::ui
