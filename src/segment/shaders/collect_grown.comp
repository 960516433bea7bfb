// Takes every grown voxel of the listed bricks as a possible parent, and forgets what was refused: after the rules have
// changed, or the newest generations were erased.
// In: texture 0 seed map; storage 7 brick indices. Out: storage 0 decided, 1 frontier, 3 parent words, 5 steps[0].
// One row of 16 groups a brick.
#include "segment/shaders/words.glsl"

layout(local_size_x = 64) in;

layout(binding = 0) uniform usampler3D seedMap;
layout(std430, binding = 0) writeonly buffer Decided { uint decided[]; };
layout(std430, binding = 1) writeonly buffer Frontier { uint frontier[]; };
layout(std430, binding = 3) writeonly buffer Parents { uint parents[]; };
layout(std430, binding = 5) buffer Steps { Step steps[]; };
layout(std430, binding = 7) readonly buffer Bricks { uint bricks[]; };

layout(location = 0) uniform ivec3 dims;
layout(location = 1) uniform ivec3 brickDims;
layout(location = 2) uniform int firstBrick;

void main() {
    ivec3 wordDims = wordDimsFor(dims);
    ivec3 brick = placeIn(bricks[uint(firstBrick) + gl_WorkGroupID.y], brickDims);
    ivec3 word = brick * kWordsPerBrick + placeIn(gl_GlobalInvocationID.x, kWordsPerBrick);
    if (any(greaterThanEqual(word, wordDims))) {
        return;
    }
    uint grown = 0u;
    for (int bit = 0; bit < 32; ++bit) {
        ivec3 voxel = word * kWordSize + voxelInWord(bit);
        bool isGrown = texelFetch(seedMap, min(voxel, dims - 1), 0).r != 0u && all(lessThan(voxel, dims));
        grown |= uint(isGrown) << bit;
    }
    if (grown == 0u) {
        return;
    }
    uint index = wordIndex(word, wordDims);
    decided[index] = grown;
    frontier[index] = grown;
    uint place = atomicAdd(steps[0].parents.w, 1u);
    parents[place] = packWord(word);
    if (place % kGroupSize == 0u) {
        atomicMax(steps[0].parents.x, min(place / kGroupSize + 1u, kMaxGroups));
    }
}
