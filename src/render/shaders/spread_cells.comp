// Marked cells spread to the cells around them: with VS_ALONG_Z to those before and after, else to the eight
// around in the same plane. Both together are one step of the Chebyshev distance (Rosenfeld and Pfaltz 1968).
// One invocation a block. In: texture 0 planes. Out: storage 0 planes.
#include "render/shaders/cell_bits.glsl"

layout(local_size_x = 4, local_size_y = 16) in;

#include "gl/shaders/place.glsl"

#include "render/shaders/bindings.glsl"
layout(binding = kPlanesBeforeTexture) uniform usamplerBuffer
    planesBefore; // much faster than a storage block on software renderers
layout(std430, binding = kPlanesStorage) writeonly buffer Planes { uvec4 planes[]; };

uniform int from; // plane
uniform int to;   // plane

uvec4 bitsAt(ivec3 place) { return texelFetch(planesBefore, from * blocksPerPlane() + blockAt(place)); }

uvec4 spreadAlongX(ivec3 place) {
    uvec4 bits = bitsAt(place);
    return bits | bits << 1 | bits >> 1 | bitsAt(place - ivec3(1, 0, 0)) >> 31 |
           bitsAt(place + ivec3(1, 0, 0)) << 31;
}

void main() {
    ivec3 place = placeOfInvocation();
    if (any(greaterThanEqual(place, blocks()))) {
        return;
    }
#ifdef VS_ALONG_Z
    uvec4 bits = bitsAt(place) | bitsAt(place - ivec3(0, 0, 1)) | bitsAt(place + ivec3(0, 0, 1));
#else
    uvec4 rows = spreadAlongX(place);
    uint before = spreadAlongX(place - ivec3(0, 1, 0)).w;
    uint after = spreadAlongX(place + ivec3(0, 1, 0)).x;
    uvec4 bits = rows | uvec4(before, rows.xyz) | uvec4(rows.yzw, after);
    // Nothing spreads out of the grid, and back into it.
    ivec3 left = cells - place * kBlock;
    bits &= left.x < kBlock.x ? (1u << left.x) - 1u : ~0u;
    bits &= mix(uvec4(0u), uvec4(~0u), lessThan(ivec4(0, 1, 2, 3), ivec4(left.y)));
#endif
    planes[to * blocksPerPlane() + blockAt(place)] = bits;
}
