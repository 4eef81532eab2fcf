// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/scene3d/gl_probe.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

namespace kambara::ui {

void prepare_for_gl() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setSwapBehavior(QSurfaceFormat::DoubleBuffer);
    format.setRedBufferSize(8);
    format.setGreenBufferSize(8);
    format.setBlueBufferSize(8);
    format.setDepthBufferSize(8);
    format.setAlphaBufferSize(8);
    format.setStencilBufferSize(0);
    format.setStereo(false);
    format.setSamples(0);
    QSurfaceFormat::setDefaultFormat(format);
}

bool can_draw_with_gl() {
    // Without a window system nothing appears, whatever the context says.
    if (QGuiApplication::platformName() == QLatin1String("offscreen") ||
        QGuiApplication::platformName() == QLatin1String("minimal")) {
        return false;
    }
    QOpenGLContext context;
    if (!context.create()) {
        return false;
    }
    QOffscreenSurface surface;
    surface.setFormat(context.format());
    surface.create();
    if (!surface.isValid() || !context.makeCurrent(&surface)) {
        return false;
    }
    const QSurfaceFormat format = context.format();
    context.doneCurrent();
    return format.majorVersion() > 3 || (format.majorVersion() == 3 && format.minorVersion() >= 2);
}

}  // namespace kambara::ui
