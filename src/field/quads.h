// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gl/texel_buffer.h"

#include <span>
#include <vector>

namespace vs::field {

// The data once more, for renderers without texture units: at each voxel, in one texel, the stored values of
// four voxels of its slice: its own, the next along x, the next along y, and the next along both; at the
// grid's border the last one's. Two fetches and a few lines of arithmetic make a trilinear sample
// (field/shaders/quads.glsl), a third faster on llvmpipe than its own filter, at four times the memory of the
// data. Texels are as Field::texels has them; x fastest, then y, then z.

// The most bytes of quads that are made: larger ones no longer stay in a processor's caches, and are no
// faster than the filter (doc/performance.md).
inline constexpr std::size_t kMostQuadBytes = std::size_t(256) << 20;

// Makes none that take more than so many bytes, from now on, of any volume: for what tries out how volumes
// are drawn that have none.
void limitQuads(std::size_t bytes);

// Room for the quads of a volume of these voxels, or nothing where they would be of no use: for large
// volumes, and on hardware. Throws GlError if the device has no room.
gl::TexelBuffer makeQuads(glm::ivec3 dims, gl::Format ofTexels);

// Fills quads from texels that were computed on the device (R16 or R32F).
void fillQuads(const gl::Texture& texels, gl::TexelBuffer& quads);

// The quads of whole slices, four texels each.
template <typename Texel>
std::vector<Texel> quadsOfSlices(std::span<const Texel> texels, glm::ivec2 slice) {
    std::vector<Texel> quads(4 * texels.size());
    Texel* out = quads.data();
    for (const Texel* row = texels.data(); row != texels.data() + texels.size(); row += slice.x) {
        const bool isLast = (row - texels.data()) / slice.x % slice.y == slice.y - 1;
        const Texel* next = isLast ? row : row + slice.x;
        for (int x = 0; x < slice.x; ++x, out += 4) {
            const int right = std::min(x + 1, slice.x - 1);
            out[0] = row[x];
            out[1] = row[right];
            out[2] = next[x];
            out[3] = next[right];
        }
    }
    return quads;
}

} // namespace vs::field
