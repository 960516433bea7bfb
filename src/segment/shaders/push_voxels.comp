// Puts listed voxels among the newest; if asked to, only those in a region.
// In: storage 7 voxel indices. In and out: storage 1 the region, or without one what may be entered, which
// they are taken from; 2 newest. Out: storage 5 steps[0], 6 work.
#include "segment/shaders/words.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kRegionStorage) buffer Region { uint region[]; };
layout(std430, binding = kNewestStorage) buffer Newest { uint newest[]; };
layout(std430, binding = kVoxelsStorage) readonly buffer Voxels { uint voxels[]; };

uniform int count;
uniform uint newestAt;
uniform int isWithin;

void main() {
    uint i = itemIndex();
    if (i >= uint(count)) {
        return;
    }
    ivec3 voxel = placeIn(voxels[i], dims);
    uint word = wordAt(wordPlaceOf(voxel));
    uint bit = 1u << bitOf(voxel);
    if (isWithin != 0 && (region[word] & bit) == 0u) {
        return;
    }
    if (isWithin == 0) {
        atomicAnd(region[word], ~bit);
    }
    atomicOr(newest[newestAt + word], bit);
    activateAround(placeOfTile(word / kWordsPerTile), tilesTouched(sidesOf(bit, word)));
}
