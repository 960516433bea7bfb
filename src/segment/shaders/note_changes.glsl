// Which tiles of 16^3 voxels a kernel of 3 voxels carries changes of a plane of bits into.
// Include after words.glsl. Bindings: storage 5, for each of a listed brick's eight tiles a bit for each of
// the 27 around it (itself included), zeros at first. One row of groups a brick, an invocation a word.

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kReachStorage) buffer Reach { uint reach[]; };

uniform int firstBrick;

// Bits 0 to 2: the tile before, this one, and the next.
uint along(bool isNearBefore, bool isNearNext) { return 2u | uint(isNearBefore) | uint(isNearNext) << 2; }

void noteChanges(uint word, uint changed) {
    uvec3 tile = uvec3(word >> 4, word >> 6, word >> 8) & 3u; // of 8^3 voxels, in the brick
    uvec3 place = (tile & 1u) * uvec3(2, 2, 4) +
                  (uvec3(word, word >> 1, word >> 2) & uvec3(1, 1, 3)); // of the word, in 16^3
    uint x =
        along(place.x == 0u && (changed & 0x77777777u) != 0u, place.x == 3u && (changed & 0xeeeeeeeeu) != 0u);
    uint y =
        along(place.y == 0u && (changed & 0x0fff0fffu) != 0u, place.y == 3u && (changed & 0xfff0fff0u) != 0u);
    uint z = along(place.z == 0u || (place.z == 1u && (changed & 0xffffu) != 0u),
                   place.z == 7u || (place.z == 6u && changed >> 16 != 0u));
    uint plane = (y & 1u) * x | ((y >> 1 & 1u) * x) << 3 | (y >> 2) * x << 6;
    uint around = (z & 1u) * plane | ((z >> 1 & 1u) * plane) << 9 | (z >> 2) * plane << 18;
    uint at =
        (uint(firstBrick) + gl_WorkGroupID.y) * 8u + (tile.x >> 1 | (tile.y >> 1) << 1 | (tile.z >> 1) << 2);
    around = changed != 0u ? around : 0u;
    if ((around & ~reach[at]) != 0u) {
        atomicOr(reach[at], around);
    }
}
