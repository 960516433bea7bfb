// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/context.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <optional>

namespace vs::desktop {

// The engine's OpenGL 4.5 context, which owns every object of the document and of the picture. The window has
// none. Everything that touches the document calls makeCurrent() first.
class GlHost {
public:
    // Needs a running QApplication. Throws GlError if there is no OpenGL 4.5.
    GlHost();
    ~GlHost();
    GlHost(const GlHost&) = delete;
    GlHost& operator=(const GlHost&) = delete;

    void makeCurrent();
    [[nodiscard]] const gl::DeviceInfo& device() const { return engine_->device(); }
    [[nodiscard]] int errorCount() const { return engine_->errorCount(); }

private:
    QOffscreenSurface surface_;
    QOpenGLContext context_;
    std::optional<gl::Context> engine_;
};

} // namespace vs::desktop
