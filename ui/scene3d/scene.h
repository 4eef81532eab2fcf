// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <memory>

#include "core/camera/rig.h"
#include "core/vsystem/snapshot.h"

class QWidget;

namespace kambara::ui {

enum class ScenePreset { behind, above, side };

/// What the 3-D view shows, behind a wall that keeps VTK's headers in.
class Scene {
  public:
    virtual ~Scene() = default;
    virtual QWidget* widget() = 0;
    virtual void set_rig(const Rig& rig) = 0;
    virtual void add(const Snapshot& snapshot) = 0;  ///< cheap: draws nothing
    virtual void clear_trail() = 0;
    virtual void look_from(ScenePreset preset) = 0;
    virtual void follow(bool follows) = 0;
    virtual void render() = 0;
    virtual bool save_png(const QString& file) = 0;
    virtual int trail_points() const = 0;
};

/// Null where the program was built without VTK.
std::unique_ptr<Scene> make_scene(QWidget* parent);

}  // namespace kambara::ui
