// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "base/check.h"
#include "base/parallel.h"
#include "gl/texel_buffer.h"

#include <span>

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

// The quads of one slice, four texels each.
template <typename Texel>
void quadsOfSlice(std::span<const Texel> texels, glm::ivec2 slice, Texel* out) {
    for (int y = 0; y < slice.y; ++y) {
        const Texel* row = texels.data() + std::size_t(y) * std::size_t(slice.x);
        const Texel* next = y + 1 < slice.y ? row + slice.x : row;
        const auto write = [&](int x, int right) {
            out[0] = row[x];
            out[1] = row[right];
            out[2] = next[x];
            out[3] = next[right];
            out += 4;
        };
        for (int x = 0; x + 1 < slice.x; ++x) {
            write(x, x + 1);
        }
        write(slice.x - 1, slice.x - 1);
    }
}

// Fills quads from the texels of whole slices, of which the first is slice `firstZ` of the volume, on all
// processors.
template <typename Texel>
void fillQuads(std::span<const Texel> texels, glm::ivec2 slice, int firstZ, gl::TexelBuffer& quads) {
    const std::size_t perSlice = std::size_t(slice.x) * std::size_t(slice.y);
    const auto memory = quads.buffer().shared().subspan(4 * sizeof(Texel) * perSlice * std::size_t(firstZ));
    VS_CHECK(texels.size() % perSlice == 0 && 4 * texels.size_bytes() <= memory.size());
    inParallel(int(texels.size() / perSlice), [&](int z) {
        const std::size_t first = perSlice * std::size_t(z);
        quadsOfSlice(texels.subspan(first, perSlice), slice,
                     reinterpret_cast<Texel*>(memory.data()) + 4 * first);
    });
}

} // namespace vs::field
