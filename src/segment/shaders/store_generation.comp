// Writes one generation (0 erases) at each listed voxel.
// In: storage 0 voxel indices. Out: image 0 seed map.
layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

layout(r32ui, binding = 0) uniform writeonly uimage3D seedMap;
layout(std430, binding = 0) readonly buffer Voxels { uint voxels[]; };

layout(location = 0) uniform int count;
layout(location = 1) uniform int generation;

void main() {
    uint i = itemIndex();
    if (i < uint(count)) {
        uint index = voxels[i];
        uvec3 size = uvec3(imageSize(seedMap));
        ivec3 voxel = ivec3(index % size.x, index / size.x % size.y, index / (size.x * size.y));
        imageStore(seedMap, voxel, uvec4(generation));
    }
}
