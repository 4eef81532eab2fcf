// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <memory>

#include "core/camera/rig.h"
#include "core/vsystem/snapshot.h"
#include "ui/scene3d/scene.h"

class QCheckBox;

namespace kambara::ui {

/// The rig and the target's trail in space, live: cameras with their fields, the target with its
/// 95 % ellipsoid, drawn thirty times a second at most. Where nothing can be drawn in 3-D it shows
/// why instead, and everything else works on.
class SceneView : public QWidget {
    Q_OBJECT
  public:
    explicit SceneView(bool with_gl, QWidget* parent = nullptr);
    ~SceneView() override;

    bool works() const { return scene_ != nullptr; }
    void set_rig(const Rig& rig);
    void add(const Snapshot& snapshot);
    void clear_trail();
    void look_from(ScenePreset preset);
    int trail_points() const;
    bool save_png(const QString& file);

    QSize sizeHint() const override { return {420, 300}; }

  private:
    void build_controls();
    void ask_for_png();

    std::unique_ptr<Scene> scene_;
    QTimer drawing_;
    bool changed_ = false;
};

}  // namespace kambara::ui
