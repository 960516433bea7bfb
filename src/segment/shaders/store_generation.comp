// Gives listed voxels one generation; 0 takes it away. Several of them may share a word.
// In: storage 7 voxel indices. In and out: storage 0 grown, 3 and 4 generations. Out: image 0 labels (0).
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"

layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) buffer Grown { uint grown[]; };
layout(std430, binding = kVoxelsStorage) readonly buffer Voxels { uint voxels[]; };
layout(r8ui, binding = kLabelsImage) uniform writeonly uimage3D labels;

uniform int count;
uniform uint generation;

void main() {
    uint i = itemIndex();
    if (i >= uint(count)) {
        return;
    }
    ivec3 voxel = placeIn(voxels[i], dims);
    uint word = wordAt(wordPlaceOf(voxel));
    uint bit = bitOf(voxel);
    uint shift = 16u * (bit & 1u);
    atomicAnd(generations[word * 16u + (bit >> 1)], ~(0xffffu << shift));
    atomicOr(generations[word * 16u + (bit >> 1)], (generation & 0xffffu) << shift);
#ifdef VS_WIDE
    shift = 8u * (bit & 3u);
    atomicAnd(lateBits[word * 8u + (bit >> 2)], ~(0xffu << shift));
    atomicOr(lateBits[word * 8u + (bit >> 2)], (generation >> 16 & 0xffu) << shift);
#endif
    if (generation != 0u) {
        atomicOr(grown[word], 1u << bit);
    } else {
        atomicAnd(grown[word], ~(1u << bit));
    }
    imageStore(labels, voxel, uvec4(0u));
}
