// After the rules have changed, or the newest generations were erased: all grown voxels of the segment at
// work, other than frozen ones, become the newest, and the tiles are listed in which something next to them
// may join. One group a brick, an invocation a tile. In: texture 3 labels, 6 grown; storage 1 first
// and last generation of each brick, 3 and 4 generations, 7 brick numbers. Out: storage 2 newest, 5
// expansions[0], 6 work.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(binding = kGrownTexelsTexture) uniform usamplerBuffer
    grownTexels; // much faster than a storage block on software renderers
layout(std430, binding = kNewestStorage) writeonly buffer Newest { uvec4 newest[]; };
layout(std430, binding = kNumbersStorage) readonly buffer Numbers { uint numbers[]; };
layout(std430, binding = kBrickNumbersStorage) readonly buffer Bricks { uvec2 bricks[]; };

uniform int firstBrick;
uniform uint newestAt;
uniform uint frozen; // generations up to this one do not grow any more

// Of a slab's grown voxels, those that may be grown from: all, but with VS_PARTLY.
uvec4 growing(uint slab, uvec4 bits) {
#ifdef VS_PARTLY
    ivec3 place = placeOfSlab(slab);
    for (int i = 0; i < 4; ++i) {
        bits[i] = ownVoxels(place * ivec3(2, 2, 1) + ivec3(i & 1, i >> 1, 0), bits[i]);
        if (frozen != 0u) {
            bits[i] = laterThan(4u * slab + uint(i), bits[i], frozen);
        }
    }
#endif
    return bits;
}

// Tiles around one that lie in other bricks, of which only those are meant that hold nothing of this segment.
void activateAcross(ivec3 place) {
    ivec3 inBrick = place & 3;
    bool isAtSide = any(equal(inBrick, ivec3(0))) || any(equal(inBrick, ivec3(3)));
    // All around: one that lies across an edge may be in another brick though only one side is a brick's.
    uint all = isAtSide ? tilesTouched(0x3fu) & ~(1u << 13) : 0u;
    for (uint around = all; around != 0u; around &= around - 1u) {
        int n = findLSB(around);
        uint tile = tileAt(place + ivec3(n % 3, n / 3 % 3, n / 9) - 1);
        uint brick = tile / kTilesPerBrick;
        if (brick < brickCount() && bricks[brick].y == 0u) {
            activate(tile);
        }
    }
}

void main() {
    uint tile = numbers[uint(firstBrick) + gl_WorkGroupID.y] * kTilesPerBrick + gl_LocalInvocationIndex;
    uvec4 every = uvec4(~0u);
    uvec4 some = uvec4(0u);
    for (uint slab = tile * kSlabsPerTile; slab < (tile + 1u) * kSlabsPerTile; ++slab) {
        uvec4 bits = texelFetch(grownTexels, int(slab));
        uvec4 from = growing(slab, bits);
        newest[newestAt + slab] = from;
        every &= bits;
        some |= from;
    }
    if (every != uvec4(~0u)) {
        activate(tile);
    }
    if (some != uvec4(0u)) {
        activateAcross(placeOfTile(tile));
    }
}
