// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>

#include "core/devices/gamepad.h"
#include "core/pointing/stick_law.h"
#include "core/vsystem/snapshot.h"

namespace kambara::ui {

/// What turns the head for as long as it is held: keys, the window's stick, a gamepad. Says at what
/// speed again and again, as a drive wants it (DriveHead), and halts once nothing is held. The last
/// one to be taken up counts. Zoomed in, the same deflection turns more slowly.
class HandDrive : public QObject {
    Q_OBJECT
  public:
    enum class Source { keys, stick, gamepad };

    explicit HandDrive(QObject* parent = nullptr);

    /// Asked fifty times a second from now on; null: none any more.
    void set_gamepad(std::shared_ptr<const GamepadBase> gamepad);
    /// Whose head this is: its speeds, its zoom.
    void show_head(const std::optional<HeadSnapshot>& head);
    /// Of the head's full speed, when all is deflected to the end.
    void set_speed_share(double share);

    /// A deflection from -1 to 1, right and up positive.
    void hold(Source source, const QPointF& deflection);
    void release(Source source);
    /// Halts, and whatever is held must be taken up anew.
    void drop_all();
    bool held() const { return holding_.has_value(); }
    PadState pad_state() const { return pad_state_; }

  signals:
    void drive(double pan_rad_s, double tilt_rad_s);
    void halt();
    void dropped();
    void zoom(double share);
    /// A gamepad came, went, counts now, or hangs.
    void pad_changed(kambara::PadState state, const QString& name);

  private:
    void tick();
    void ask_gamepad();
    void follow_zoom(double wish);
    void tell();
    void run_timer();

    QTimer timer_;
    QElapsedTimer time_;
    qint64 told_ms_ = 0;
    std::array<QPointF, 3> deflections_;
    std::array<bool, 3> is_held_{};
    std::optional<Source> holding_;
    std::optional<HeadSnapshot> head_;
    double speed_share_ = 0.3;
    std::shared_ptr<const GamepadBase> gamepad_;
    StickLaw law_;
    PadState pad_state_ = PadState::absent;
    bool pad_halts_ = false;
    std::optional<double> zoom_;  // where the triggers have brought it
    qint64 zoomed_ms_ = 0;
    qint64 zoom_told_ms_ = 0;
};

}  // namespace kambara::ui
