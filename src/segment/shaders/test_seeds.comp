// Answers for each listed voxel whether it can be a seed now: 0 refused by the constraints or another
// segment's, 1 grown already, 2 yes, 3 yes but it was forbidden (with VS_FORBIDDEN). Generations after the
// playhead count as not grown. In: the constraints, texture 0 data, 1 sculpture, 3 labels; storage 0 grown, 3
// and 4 generations, 7 voxel indices. Out: storage 1 answers. Storage 2: what is forbidden.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"

layout(local_size_x = 64) in;

#include "gl/shaders/items.glsl"

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) readonly buffer Grown { uint grown[]; };
layout(std430, binding = kAnswersStorage) writeonly buffer Answers { uint answers[]; };
#ifdef VS_FORBIDDEN
layout(std430, binding = kForbiddenToSeedStorage) readonly buffer Forbidden { uint forbidden[]; };
#endif
layout(std430, binding = kVoxelsStorage) readonly buffer Voxels { uint voxels[]; };

uniform int count;
uniform uint playhead;

void main() {
    uint i = itemIndex();
    if (i < uint(count)) {
        ivec3 voxel = voxelOf(voxels[i]);
        ivec3 place = wordPlaceOf(voxel);
        uint word = wordAt(place);
        uint bit = 1u << bitOf(voxel);
        bool isGrown = (grown[word] & bit) != 0u;
        bool isOwn = ownVoxels(place, grown[word] & bit) != 0u;
        bool isHidden = isOwn && laterThan(word, bit, playhead) != 0u;
        bool isFree = !isGrown || isHidden;
        uint free = 2u;
#ifdef VS_FORBIDDEN
        free = (forbidden[word] & bit) != 0u ? 3u : 2u;
#endif
        answers[i] = isFree ? (isAdmissible(voxel) ? free : 0u) : (isOwn ? 1u : 0u);
    }
}
