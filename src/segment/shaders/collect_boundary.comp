// After the rules have changed, or the newest generations were erased: what grows next grows from voxels that have a neighbour
// which has not grown. Takes those of the segment at work, other than frozen ones, as the newest, and forgets what was refused.
// In: texture 3 labels, 6 grown; storage 3 and 4 generations, 7 brick numbers. Out: storage 2 newest, 5 steps[0], 6 work.
// One row of 16 groups a brick, an invocation a slab.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 16) in;

layout(binding = 6) uniform usamplerBuffer grownTexels; // much faster than a storage block on software renderers
layout(std430, binding = 2) writeonly buffer Newest { uvec4 newest[]; };
layout(std430, binding = 7) readonly buffer Bricks { uint bricks[]; };

layout(location = 9) uniform int firstBrick;
layout(location = 10) uniform uint newestAt;
layout(location = 11) uniform uint frozen; // generations up to this one do not grow any more

uvec4 bitsOf(uint slab) { return ~texelFetch(grownTexels, int(slab)); }
#include "segment/shaders/neighbours.glsl"

void main() {
    uint slab = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kSlabsPerBrick + gl_GlobalInvocationID.x;
    ivec3 place = placeOfSlab(slab);
    uvec4 from = ~bitsOf(slab) & nextTo(place);
    for (int i = 0; i < 4; ++i) {
        from[i] = ownVoxels(place * ivec3(2, 2, 1) + ivec3(i & 1, i >> 1, 0), from[i]);
        if (frozen != 0u) {
            from[i] = laterThan(4u * slab + uint(i), from[i], frozen);
        }
    }
    if (from != uvec4(0u)) {
        newest[newestAt + slab] = from;
        activateAround(placeOfTile(slab / kSlabsPerTile), tilesTouched(sidesOfSlab(from, slab)));
    }
}
