// Erases generations after `last` in the listed bricks.
// In: storage 0 brick indices. In and out: image 0 seed map. One row of 16 groups a brick.
#include "segment/shaders/words.glsl"

layout(local_size_x = 64) in;

layout(r32ui, binding = 0) uniform uimage3D seedMap;
layout(std430, binding = 0) readonly buffer Bricks { uint bricks[]; };

layout(location = 0) uniform ivec3 brickDims;
layout(location = 1) uniform int last;
layout(location = 2) uniform int firstBrick;

void main() {
    ivec3 dims = imageSize(seedMap);
    ivec3 brick = placeIn(bricks[uint(firstBrick) + gl_WorkGroupID.y], brickDims);
    ivec3 first = (brick * kWordsPerBrick + placeIn(gl_GlobalInvocationID.x, kWordsPerBrick)) * kWordSize;
    for (int bit = 0; bit < 32; ++bit) {
        ivec3 voxel = first + voxelInWord(bit);
        if (all(lessThan(voxel, dims)) && imageLoad(seedMap, voxel).r > uint(last)) {
            imageStore(seedMap, voxel, uvec4(0u));
        }
    }
}
