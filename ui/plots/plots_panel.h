// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>
#include <vector>

#include "core/vsystem/snapshot.h"

class QCustomPlot;
class QLabel;
class QToolButton;

namespace kambara::ui {

/// The last 60 seconds of x, y, z, quality, frame rate and latency. Drawn twenty times a second at
/// most; a cursor reads values off; pausing holds the drawing, not the recording.
class PlotsPanel : public QWidget {
    Q_OBJECT
  public:
    explicit PlotsPanel(QWidget* parent = nullptr);
    ~PlotsPanel() override;

    void add(const Snapshot& snapshot);
    void clear();
    void set_paused(bool paused);
    bool paused() const;
    int samples_shown() const;  ///< of the first plot, as drawn last

  private:
    struct Strip;
    void add_strip(const QString& name, const QString& unit, int decimals);
    void draw();
    void read_off(double time_s);

    std::vector<std::unique_ptr<Strip>> strips_;
    QToolButton* pause_;
    QLabel* cursor_;
    QTimer drawing_;
    bool changed_ = false;
};

}  // namespace kambara::ui
