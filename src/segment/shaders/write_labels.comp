// Labels the voxels of the segment at work that have none yet.
// In: texture 3 labels; storage 0 grown, 7 brick numbers. Out: image 0 labels. One row of 16 groups a brick,
// an invocation a word.
#include "segment/shaders/words.glsl"
#include "segment/shaders/owners.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) readonly buffer Grown { uint grown[]; };
layout(std430, binding = kBricksStorage) readonly buffer Bricks { uint bricks[]; };
layout(r8ui, binding = kLabelsImage) uniform writeonly uimage3D labels;

uniform int firstBrick;

void main() {
    uint word = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kWordsPerBrick + gl_GlobalInvocationID.x;
    ivec3 place = placeOfWord(word);
    for (uint left = grown[word]; left != 0u; left &= left - 1u) {
        ivec3 voxel = voxelAt(place, findLSB(left));
        if (texelFetch(labelTexture, voxel, 0).r == 0u) {
            imageStore(labels, voxel, uvec4(activeLabel));
        }
    }
}
