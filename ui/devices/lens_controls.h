// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>

#include "core/vsystem/command.h"
#include "core/vsystem/snapshot.h"

class QCheckBox;
class QGridLayout;
class QLabel;
class QSpinBox;
class QToolButton;

namespace kambara::ui {

class ShareSlider;

/// Zoom, focus and presets of the head. What the head lacks is disabled and says so.
class LensControls : public QWidget {
    Q_OBJECT
  public:
    explicit LensControls(QWidget* parent = nullptr);

    /// Width of the labels' column, for those of others above it.
    int labels_px() const { return labels_px_; }
    void show_head(const std::optional<HeadSnapshot>& head);

  signals:
    void asked(const kambara::Command& command);

  private:
    void build_zoom(QGridLayout* grid);
    void build_focus(QGridLayout* grid);
    void build_presets(QGridLayout* grid);
    QLabel* label(const QString& text);
    QToolButton* button(const QString& text, const char* object_name);

    int labels_px_ = 0;
    QToolButton* wider_;
    QToolButton* narrower_;
    ShareSlider* zoom_;
    QLabel* view_;
    ShareSlider* focus_;
    QCheckBox* autofocus_;
    QSpinBox* preset_;
    QToolButton* keep_;
    QToolButton* recall_;
};

}  // namespace kambara::ui
