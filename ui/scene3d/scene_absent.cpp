// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene.h"

namespace kambara::ui {

std::unique_ptr<Scene> make_scene(QWidget*) {
    return nullptr;
}

}  // namespace kambara::ui
