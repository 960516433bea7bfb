// Second half of an expansion: every voxel on offer is tested once; those that pass get the new generation and form the
// next frontier. Each word is one invocation's own, so the seed map needs no atomics.
// In: texture 0 data, texture 1 sculpture; storage 4 candidate words. In and out: storage 0 decided, 2 offers (left
// zero), 5 steps, 6 first and last generation of each brick. Out: image 0 seed map; storage 1 frontier, 3 parent words.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"

layout(local_size_x = 64) in;

layout(r32ui, binding = 0) uniform writeonly uimage3D seedMap;
layout(std430, binding = 0) buffer Decided { uint decided[]; };
layout(std430, binding = 1) writeonly buffer Frontier { uint frontier[]; };
layout(std430, binding = 2) buffer Offers { uint offers[]; };
layout(std430, binding = 3) writeonly buffer Parents { uint parents[]; };
layout(std430, binding = 4) readonly buffer Candidates { uint candidates[]; };
layout(std430, binding = 5) buffer Steps { Step steps[]; };
layout(std430, binding = 6) buffer Bricks { uvec2 bricks[]; };

layout(location = 0) uniform int stepIndex;
layout(location = 1) uniform ivec3 wordDims;
layout(location = 2) uniform ivec3 brickDims;
layout(location = 3) uniform int generation;

void noteGrown(uint index, ivec3 word, uint grown) {
    frontier[index] = grown;
    uint place = atomicAdd(steps[stepIndex + 1].parents.w, 1u);
    parents[place] = packWord(word);
    if (place % kGroupSize == 0u) {
        atomicMax(steps[stepIndex + 1].parents.x, min(place / kGroupSize + 1u, kMaxGroups));
    }
    // Generations only rise, and all of this dispatch write the same one.
    ivec3 brick = word / kWordsPerBrick;
    uint brickIndex = uint((brick.z * brickDims.y + brick.y) * brickDims.x + brick.x);
    for (bool isOld = bricks[brickIndex].y != uint(generation); isOld; isOld = false) {
        uint first = bricks[brickIndex].x;
        bricks[brickIndex] = uvec2(first == 0u ? uint(generation) : first, uint(generation));
    }
}

void main() {
    uint count = steps[stepIndex].candidates.w;
    uint total = 0u;
    for (uint i = gl_GlobalInvocationID.x; i < count; i += gl_NumWorkGroups.x * kGroupSize) {
        ivec3 word = unpackWord(candidates[i]);
        uint index = wordIndex(word, wordDims);
        uint offered = offers[index];
        offers[index] = 0u;
        uint grown = 0u;
        for (uint bits = offered; bits != 0u; bits &= bits - 1u) {
            int bit = findLSB(bits);
            ivec3 voxel = word * kWordSize + voxelInWord(bit);
            if (isInside(voxel) && isAdmissible(voxel)) {
                grown |= 1u << bit;
                imageStore(seedMap, voxel, uvec4(generation));
            }
        }
        decided[index] |= offered;
        if (grown != 0u) {
            noteGrown(index, word, grown);
            total += uint(bitCount(grown));
        }
    }
    if (total != 0u) {
        atomicAdd(steps[stepIndex].grown.x, total);
    }
}
