// Adds listed voxels, already grown, to the frontier.
// In: storage 7 voxel indices. In and out: storage 0 decided, 1 frontier, 5 steps[0]. Out: 3 parent words.
#include "segment/shaders/words.glsl"

layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

layout(std430, binding = 0) buffer Decided { uint decided[]; };
layout(std430, binding = 1) buffer Frontier { uint frontier[]; };
layout(std430, binding = 3) writeonly buffer Parents { uint parents[]; };
layout(std430, binding = 5) buffer Steps { Step steps[]; };
layout(std430, binding = 7) readonly buffer Voxels { uint voxels[]; };

layout(location = 0) uniform ivec3 dims;
layout(location = 1) uniform int count;

void main() {
    uint i = itemIndex();
    if (i >= uint(count)) {
        return;
    }
    ivec3 voxel = placeIn(voxels[i], dims);
    ivec3 inWord = voxel % kWordSize;
    uint bit = 1u << (inWord.x + 4 * inWord.y + 16 * inWord.z);
    ivec3 word = voxel / kWordSize;
    uint index = wordIndex(word, wordDimsFor(dims));
    atomicOr(decided[index], bit);
    if (atomicOr(frontier[index], bit) == 0u) {
        uint place = atomicAdd(steps[0].parents.w, 1u);
        parents[place] = packWord(word);
        if (place % kGroupSize == 0u) {
            atomicMax(steps[0].parents.x, min(place / kGroupSize + 1u, kMaxGroups));
        }
    }
}
