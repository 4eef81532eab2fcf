// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QSlider>
#include <optional>

namespace kambara::ui {

/// A slider for something that takes its time to get where it is told: it stays where the operator
/// put it until the device has come there, or for some seconds.
class ShareSlider : public QSlider {
    Q_OBJECT
  public:
    explicit ShareSlider(QWidget* parent = nullptr);

    /// Where the device is, from 0 to 1.
    void show_share(double share);
    double share() const;
    /// As if the operator had put it there.
    void ask_for(double share);

  signals:
    void share_asked(double share);

  private:
    std::optional<double> asked_;
    QElapsedTimer since_asked_;
};

}  // namespace kambara::ui
