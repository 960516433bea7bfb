// Takes voxels away from the segment at work: those of generations after `last`, with VS_BY_PLANE only those
// of them that are in a plane, or not in it. With VS_NOTE nothing is erased: bricks that would lose some are
// noted. In: texture 3 labels; storage 7 brick numbers; 1 the plane. In and out: storage 0 grown, 3 and 4
// generations. Out: image 0 labels; storage 2 with VS_NOTE, for each listed brick, whether it loses
// something; else with VS_BY_PLANE how many voxels of each generation are gone. One row of 16 groups a brick,
// an invocation a word.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) buffer Grown { uint grown[]; };
layout(std430, binding = kPlaneStorage) readonly buffer Plane { uint plane[]; };
layout(std430, binding = kLossesStorage) buffer Losses { uint losses[]; };
layout(std430, binding = kBricksStorage) readonly buffer Bricks { uint bricks[]; };
layout(r8ui, binding = kLabelsImage) uniform writeonly uimage3D labels;

uniform int firstBrick;
uniform uint last;
uniform int erasesPlane; // 1: what is in the plane; 0: what is not

void main() {
    uint item = uint(firstBrick) + gl_WorkGroupID.y;
    uint word = bricks[item] * kWordsPerBrick + gl_GlobalInvocationID.x;
    ivec3 place = placeOfWord(word);
    uint doomed = grown[word];
#ifdef VS_BY_PLANE
    doomed &= plane[word] ^ (erasesPlane != 0 ? 0u : 0xffffffffu);
#endif
    doomed = ownVoxels(place, doomed);
    doomed = last != 0u ? laterThan(word, doomed, last) : doomed;
    if (doomed == 0u) {
        return;
    }
#ifdef VS_NOTE
    losses[item] = 1u;
#else
#ifdef VS_BY_PLANE
    for (uint left = doomed; left != 0u; left &= left - 1u) {
        atomicAdd(losses[generationIn(word, uint(findLSB(left)))], 1u);
    }
#endif
    grown[word] &= ~doomed;
    storeGenerations(word, doomed, 0u);
    for (uint left = doomed; left != 0u; left &= left - 1u) {
        imageStore(labels, voxelAt(place, findLSB(left)), uvec4(0u));
    }
#endif
}
