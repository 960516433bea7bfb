// Gives the segment at work those voxels of a plane that are nobody's, with one generation. With VS_NOTE
// nothing changes: bricks that would gain some are noted. In: storage 1 the plane, 7 brick numbers. In and
// out: storage 0 grown, 3 and 4 generations. Out: storage 2, with VS_NOTE for each listed brick whether it
// gains something, else how many voxels there are. One row of 16 groups a brick, an invocation a word.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) buffer Grown { uint grown[]; };
layout(std430, binding = kPlaneStorage) readonly buffer Plane { uint plane[]; };
layout(std430, binding = kGainsStorage) buffer Gains { uint gains[]; };
layout(std430, binding = kBricksStorage) readonly buffer Bricks { uint bricks[]; };

uniform int firstBrick;
uniform uint generation;

void main() {
    uint item = uint(firstBrick) + gl_WorkGroupID.y;
    uint word = bricks[item] * kWordsPerBrick + gl_GlobalInvocationID.x;
    uint fresh = plane[word] & ~grown[word];
    if (fresh == 0u) {
        return;
    }
#ifdef VS_NOTE
    gains[item] = 1u;
#else
    grown[word] |= fresh;
    storeGenerations(word, fresh, generation);
    atomicAdd(gains[0], uint(bitCount(fresh)));
#endif
}
