// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/context.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <condition_variable>
#include <mutex>
#include <optional>

namespace vs::desktop {

// The engine's OpenGL 4.5 context, which owns every object of the document and of the picture. The window has
// none. Everything that touches the document calls makeCurrent() first. One thread has it at a time: the one
// that made it, until it hands it over.
class GlHost {
public:
    // Needs a running QApplication. Throws GlError if there is no OpenGL 4.5.
    GlHost();
    ~GlHost();
    GlHost(const GlHost&) = delete;
    GlHost& operator=(const GlHost&) = delete;

    // Waits for the context while another thread has it.
    void makeCurrent();
    // Called by the thread that has it.
    void handOverTo(QThread& thread);
    [[nodiscard]] const gl::DeviceInfo& device() const { return engine_->device(); }
    [[nodiscard]] int errorCount() const { return engine_->errorCount(); }

private:
    QOffscreenSurface surface_;
    QOpenGLContext context_;
    std::optional<gl::Context> engine_;
    std::mutex mutex_;
    std::condition_variable handedOver_;
    QThread* owner_;
};

} // namespace vs::desktop
