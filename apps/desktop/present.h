// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/texture.h"

namespace vs::desktop {

// Puts a picture (rows from the top) into a framebuffer of any size, smoothly scaled. Its own framebuffer
// belongs to the context it was made in; the texture may come from one that shares with it.
class Presenter {
public:
    Presenter();
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    void present(const gl::Texture& picture, unsigned int framebuffer, glm::ivec2 size);

private:
    unsigned int source_ = 0;
};

} // namespace vs::desktop
