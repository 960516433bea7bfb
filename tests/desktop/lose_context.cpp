// SPDX-License-Identifier: Apache-2.0
// Preloaded: says once that the graphics driver was reset, when the file that VS_LOSE_CONTEXT names is there,
// and takes the file away.
#include <epoxy/gl.h>

#include <cstdlib>
#include <unistd.h>

namespace {

GLenum resetStatus() {
    const char* sign = std::getenv("VS_LOSE_CONTEXT");
    return sign != nullptr && unlink(sign) == 0 ? GL_INNOCENT_CONTEXT_RESET : GL_NO_ERROR;
}

// The programs resolve OpenGL through libepoxy's pointers.
[[maybe_unused]] const bool isIn = [] {
    epoxy_glGetGraphicsResetStatus = resetStatus;
    return true;
}();

} // namespace
