// SPDX-License-Identifier: Apache-2.0
#include "gl_host.h"

#include "base/error.h"

namespace vs::desktop {

namespace {

QSurfaceFormat wantedFormat() {
    QSurfaceFormat format;
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    return format;
}

} // namespace

GlHost::GlHost() {
    surface_.setFormat(wantedFormat());
    surface_.create();
    context_.setFormat(wantedFormat());
    if (!context_.create() || !context_.makeCurrent(&surface_)) {
        throw GlError("no OpenGL 4.5 context could be made for the window; update the graphics driver or set "
                      "LIBGL_ALWAYS_SOFTWARE=1 for Mesa's software renderer");
    }
    engine_ = gl::Context::adoptCurrent();
}

GlHost::~GlHost() { makeCurrent(); }

void GlHost::makeCurrent() {
    if (QOpenGLContext::currentContext() != &context_) {
        context_.makeCurrent(&surface_);
    }
}

} // namespace vs::desktop
