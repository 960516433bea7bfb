// The voxels of the segment at work as a plane: those of generations after `last`, with VS_ADMISSIBLE only
// those that the present rules would let in. In: the constraints, texture 0 data, 1 sculpture, 3 labels;
// storage 0 grown, 3 and 4 generations, 7 brick numbers, 6 what is forbidden (with VS_FORBIDDEN). Out:
// storage 2 the plane. One row of 16 groups a brick, an invocation a word.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) readonly buffer Grown { uint grown[]; };
layout(std430, binding = kMadePlaneStorage) writeonly buffer Plane { uint plane[]; };
#ifdef VS_FORBIDDEN
layout(std430, binding = kForbiddenInPlaneStorage) readonly buffer Forbidden { uint forbidden[]; };
#endif
layout(std430, binding = kBricksStorage) readonly buffer Bricks { uint bricks[]; };

uniform int firstBrick;
uniform uint last;

void main() {
    uint word = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kWordsPerBrick + gl_GlobalInvocationID.x;
    ivec3 place = placeOfWord(word);
    uint bits = ownVoxels(place, grown[word]);
    bits = last != 0u ? laterThan(word, bits, last) : bits;
#ifdef VS_ADMISSIBLE
    uint admissible = 0u;
    for (uint left = bits; left != 0u; left &= left - 1u) {
        int bit = findLSB(left);
        admissible |= uint(isAdmissible(voxelAt(place, bit))) << bit;
    }
    bits = admissible;
#ifdef VS_FORBIDDEN
    bits &= ~forbidden[word];
#endif
#endif
    plane[word] = bits;
}
