// Answers for each listed voxel whether it can be a seed now: 0 refused by the constraints, 1 grown already, 2 yes.
// Generations after the playhead count as not grown.
// In: texture 0 data, 1 sculpture, 2 seed map; storage 0 voxel indices. Out: storage 1 answers.
#include "segment/shaders/constraints.glsl"

layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

layout(binding = 2) uniform usampler3D seedMap;
layout(std430, binding = 0) readonly buffer Voxels { uint voxels[]; };
layout(std430, binding = 1) writeonly buffer Answers { uint answers[]; };

layout(location = 0) uniform int count;
layout(location = 1) uniform int playhead;

void main() {
    uint i = itemIndex();
    if (i < uint(count)) {
        ivec3 voxel = voxelOf(voxels[i]);
        uint generation = texelFetch(seedMap, voxel, 0).r;
        bool isGrown = generation != 0u && generation <= uint(playhead);
        answers[i] = isGrown ? 1u : (isAdmissible(voxel) ? 2u : 0u);
    }
}
