// Sets (or clears) the bits of listed voxels in a plane.
// In: storage 7 voxel indices. In and out: storage 2 the plane.
#include "segment/shaders/words.glsl"

layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kMadePlaneStorage) buffer Plane { uint plane[]; };
layout(std430, binding = kVoxelsStorage) readonly buffer Voxels { uint voxels[]; };

uniform int count;
uniform int isToSet;

void main() {
    uint i = itemIndex();
    if (i < uint(count)) {
        ivec3 voxel = placeIn(voxels[i], dims);
        uint word = wordAt(wordPlaceOf(voxel));
        uint bit = 1u << bitOf(voxel);
        if (isToSet != 0) {
            atomicOr(plane[word], bit);
        } else {
            atomicAnd(plane[word], ~bit);
        }
    }
}
