// The distance of each macrocell from the nearest that may hold something: as many steps as did not reach it.
// One invocation a block. In: texture 0 planes 0 to `far` - 1. Out: image 0 (r32ui): distances, at most
// `far`.
#include "render/shaders/cell_bits.glsl"

layout(local_size_x = 4, local_size_y = 16) in;

#include "gl/shaders/place.glsl"

#include "render/shaders/bindings.glsl"
layout(binding = kPlanesTexture) uniform usamplerBuffer planes;
layout(r32ui, binding = kDistancesImage) uniform writeonly uimage3D distances;

uniform int far;

void main() {
    ivec3 place = placeOfInvocation();
    if (any(greaterThanEqual(place, blocks()))) {
        return;
    }
    // Counts of 128 cells at a time: one, two, four, eight and sixteen.
    uvec4 counts[5] = uvec4[5](uvec4(0u), uvec4(0u), uvec4(0u), uvec4(0u), uvec4(0u));
    int block = blockAt(place);
    for (int r = 0; r < far; ++r) {
        uvec4 carry = ~texelFetch(planes, r * blocksPerPlane() + block);
        for (int digit = 0; digit < 5; ++digit) {
            uvec4 sum = counts[digit] ^ carry;
            carry &= counts[digit];
            counts[digit] = sum;
        }
    }
    ivec3 first = place * kBlock;
    ivec3 size = min(cells - first, kBlock);
    for (int y = 0; y < size.y; ++y) {
        for (int x = 0; x < size.x; ++x) {
            uint distance = 0u;
            for (int digit = 0; digit < 5; ++digit) {
                distance |= (counts[digit][y] >> x & 1u) << digit;
            }
            imageStore(distances, first + ivec3(x, y, 0), uvec4(distance));
        }
    }
}
