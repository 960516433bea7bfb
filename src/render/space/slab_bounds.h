// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/program.h"
#include "gl/texel_buffer.h"
#include "gl/texture.h"
#include "render/space/macrocells.h"

namespace vs::render {

// Bounds of the values that the rays of each beam (a square of pixels) can meet, slab by slab of its length:
// with them a maximum intensity projection looks at few of its samples and misses none. See
// render/shaders/slabs.glsl.
class SlabBounds {
public:
    SlabBounds();

    // Bounds for samples `sampleStep` apart along the beams of a picture. The scene, the view, `macrocells`
    // and `beams` (texture 8) must be bound.
    void update(const Macrocells& macrocells, const gl::Texture& beams, int beamPixels, float sampleStep);

    // Binds the bounds as texture 11.
    void bind() const;

private:
    void widenTops(const Macrocells& macrocells);

    gl::Program widen_;
    gl::Program bound_;
    gl::Texture tops_; // of macrocells
    std::uint64_t topsVersion_ = 0;
    gl::TexelBuffer lists_;
};

} // namespace vs::render
