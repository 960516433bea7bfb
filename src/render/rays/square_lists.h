// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/math.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"

namespace vs::render {

// The squares of 8 x 8 pixels in which one part of a picture may show something.
struct PartSquares {
    gl::Buffer list;
    int count = 0;
};

// Which squares of 8 x 8 pixels a picture is cast in: those in which no part of it can show anything are left
// out, and after two samples, if wanted, those that have settled. Mark the parts' beams, then list.
class SquareLists {
public:
    SquareLists();

    // For pictures of this size, in pixels.
    void resize(glm::ivec2 pictureSize);

    void forget();
    // `beams`: what find_beams.comp made of a part, one for each square of so many pixels.
    void mark(const gl::Texture& beams, int beamPixels);
    // Lists those with any of these pixels.
    void list(const Box2& window);
    // After two samples: squares where they agree take no more.
    void setSettledAside();
    // Lists those squares that take samples in which the part with these beams may show something.
    void listPart(const gl::Texture& beams, int beamPixels, PartSquares& part);

    // How many may show something: they stand first in the list.
    [[nodiscard]] int occupied() const { return occupied_; }
    // How many of these take samples: they stand first of all.
    [[nodiscard]] int active() const { return active_; }
    // How many may not: they stand last.
    [[nodiscard]] int empty() const { return empty_; }
    [[nodiscard]] int all() const { return count_.x * count_.y; }

    // For squares.glsl: the list of all squares, and of a part's.
    void bind() const;
    void bind(const PartSquares& part) const;
    // For resolve_picture.comp.
    void bindPlaces() const;

    // Work groups for so many squares: as many rows as a software renderer has threads; see squares.glsl.
    static glm::ivec3 groupsFor(int squares);

private:
    [[nodiscard]] std::size_t bytes() const;

    glm::ivec2 count_{0};
    int occupied_ = 0;
    int active_ = 0;
    int empty_ = 0;
    gl::Program mark_;
    gl::Program list_;
    gl::ProgramVariants listPart_{"render/shaders/list_part_squares.comp"}; // compiled when first needed
    gl::ProgramVariants setAside_{"render/shaders/set_squares_aside.comp"};
    gl::Buffer marks_;
    gl::Buffer squares_; // those that may show something first
    gl::Buffer places_;  // of squares in that list
    gl::Buffer counts_;
    gl::Buffer contrasts_; // of the first two samples, in each square
    gl::Buffer unsettled_; // the squares once more, in their new order
};

} // namespace vs::render
