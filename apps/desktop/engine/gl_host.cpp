// SPDX-License-Identifier: Apache-2.0
#include "engine/gl_host.h"

#include "base/error.h"

#include <QThread>

namespace vs::desktop {

namespace {

QSurfaceFormat wantedFormat() {
    QSurfaceFormat format;
    format.setVersion(4, 5);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setOption(QSurfaceFormat::ResetNotification);
    return format;
}

} // namespace

GlHost::GlHost() : owner_(QThread::currentThread()) {
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
    std::unique_lock lock(mutex_);
    handedOver_.wait(lock, [this] { return owner_ == QThread::currentThread(); });
    if (QOpenGLContext::currentContext() != &context_) {
        context_.makeCurrent(&surface_);
        engine_->makeCurrent();
    }
}

void GlHost::handOverTo(QThread& thread) {
    {
        const std::lock_guard lock(mutex_);
        if (QOpenGLContext::currentContext() == &context_) {
            context_.doneCurrent();
        }
        context_.moveToThread(&thread);
        owner_ = &thread;
    }
    handedOver_.notify_all();
}

} // namespace vs::desktop
