// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/scene_view.h"

#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QToolBar>
#include <QVBoxLayout>

#include "ui/base/theme.h"

namespace kambara::ui {
namespace {

constexpr int drawing_ms = 33;

}  // namespace

SceneView::SceneView(bool with_gl, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    scene_ = with_gl ? make_scene(this) : nullptr;
    if (!scene_) {
        auto* note = new QLabel(
            tr("There is no 3-D view: OpenGL 3.2 is not available here.\n"
               "Everything else works. To have it, install a graphics driver or run the program "
               "where the screen is."),
            this);
        note->setObjectName(QStringLiteral("noScene"));
        note->setAlignment(Qt::AlignCenter);
        note->setWordWrap(true);
        note->setStyleSheet(QStringLiteral("color: %1").arg(theme::faint.name()));
        column->addWidget(note);
        return;
    }
    column->addWidget(scene_->widget(), 1);
    build_controls();
    connect(&drawing_, &QTimer::timeout, this, [this] {
        if (changed_ && isVisible()) {
            changed_ = false;
            scene_->render();
        }
    });
    drawing_.start(drawing_ms);
}

SceneView::~SceneView() = default;

void SceneView::build_controls() {
    // A tool bar hides what has no room behind its arrow; a row of buttons would widen the window.
    auto* bar = new QToolBar(this);
    bar->setStyleSheet(QStringLiteral("QToolButton { padding: 3px 5px }"));
    const auto button = [&](const QString& text, const QString& help) {
        QAction* action = bar->addAction(text);
        action->setToolTip(help);
        return action;
    };
    const auto on_click = [this](QAction* action, auto&& act) {
        connect(action, &QAction::triggered, this, act);
    };
    on_click(button(tr("Behind"), tr("Look along with the cameras")),
             [this] { look_from(ScenePreset::behind); });
    on_click(button(tr("Above"), tr("Look down on the rig")),
             [this] { look_from(ScenePreset::above); });
    on_click(button(tr("Side"), tr("Look from the right")),
             [this] { look_from(ScenePreset::side); });
    bar->addSeparator();
    QAction* follow = button(tr("Follow"), tr("Keeps the target in the middle"));
    follow->setCheckable(true);
    connect(follow, &QAction::toggled, this, [this](bool on) {
        scene_->follow(on);
        changed_ = true;
    });
    on_click(button(tr("Clear"), tr("Forgets where the target was")), [this] { clear_trail(); });
    on_click(button(tr("Save\u2026"), tr("Writes the 3-D view as a PNG file")),
             [this] { ask_for_png(); });
    layout()->addWidget(bar);
}

void SceneView::set_rig(const Rig& rig) {
    if (scene_) {
        scene_->set_rig(rig);
        changed_ = true;
    }
}

void SceneView::add(const Snapshot& snapshot) {
    if (scene_) {
        scene_->add(snapshot);
        changed_ = true;
    }
}

void SceneView::clear_trail() {
    if (scene_) {
        scene_->clear_trail();
        changed_ = true;
    }
}

void SceneView::look_from(ScenePreset preset) {
    if (scene_) {
        scene_->look_from(preset);
        changed_ = true;
    }
}

int SceneView::trail_points() const {
    return scene_ ? scene_->trail_points() : 0;
}

bool SceneView::save_png(const QString& file) {
    return scene_ && scene_->save_png(file);
}

void SceneView::ask_for_png() {
    QString file = QFileDialog::getSaveFileName(this, tr("Save 3-D picture"),
                                                QStringLiteral("scene.png"), tr("PNG (*.png)"));
    if (file.isEmpty()) {
        return;
    }
    if (!file.endsWith(QLatin1String(".png"), Qt::CaseInsensitive)) {
        file += QStringLiteral(".png");
    }
    if (!save_png(file)) {
        QMessageBox::warning(
            this, tr("Save 3-D picture"),
            tr("%1 can't be written. Choose a folder that you may write to.").arg(file));
    }
}

}  // namespace kambara::ui
