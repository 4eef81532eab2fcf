// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QWidget>

namespace kambara::ui {

/// A stick to be held with the mouse: the farther from the middle, the faster. Let go, it springs
/// back.
class HeadStick : public QWidget {
    Q_OBJECT
  public:
    explicit HeadStick(QWidget* parent = nullptr);

    /// With `reason_not` for its tooltip where it is of no use.
    void allow(bool able, const QString& reason_not);
    /// From -1 to 1, right and up positive: the square of how far it is from the middle.
    QPointF deflection_at(const QPointF& point) const;

    /// Springs back though it is still pressed.
    void spring_back();

    QSize sizeHint() const override { return {110, 110}; }
    QSize minimumSizeHint() const override { return {90, 90}; }

  signals:
    void held(const QPointF& deflection);
    void let_go();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

  private:
    QPointF middle() const;
    double radius() const;
    void take(const QPointF& point);

    bool pressed_ = false;
    QPointF knob_;  // off the middle, px
};

}  // namespace kambara::ui
