// SPDX-License-Identifier: Apache-2.0
#include "present.h"

#include <epoxy/gl.h>

namespace vs::desktop {

Presenter::Presenter() { glCreateFramebuffers(1, &source_); }
Presenter::~Presenter() { glDeleteFramebuffers(1, &source_); }

void Presenter::present(const gl::Texture& picture, unsigned int framebuffer, glm::ivec2 size) {
    glNamedFramebufferTexture(source_, GL_COLOR_ATTACHMENT0, picture.name(), 0);
    glNamedFramebufferReadBuffer(source_, GL_COLOR_ATTACHMENT0);
    // The picture's first row is its top one, the framebuffer's first row its bottom one.
    glBlitNamedFramebuffer(source_, framebuffer, 0, 0, picture.size().x, picture.size().y, 0, size.y, size.x,
                           0, GL_COLOR_BUFFER_BIT, GL_LINEAR);
    glNamedFramebufferTexture(source_, GL_COLOR_ATTACHMENT0, 0, 0); // the texture may be remade any time
}

} // namespace vs::desktop
