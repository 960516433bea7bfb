// Which voxels that have not grown the rules let in, by themselves, in rows of tiles that growth comes near
// for the first time. A group a row, an invocation a word, those along x side by side. In: the constraints,
// texture 0 data, 1 sculpture; storage 0 grown, 5 expansions, 6 work, 7 what is forbidden (with
// VS_FORBIDDEN). Out: storage 1 allowed.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) readonly buffer Grown { uint grown[]; };
layout(std430, binding = kAllowedStorage) writeonly buffer Allowed { uint allowed[]; };
#ifdef VS_FORBIDDEN
layout(std430, binding = kForbiddenToGrowStorage) readonly buffer Forbidden { uint forbidden[]; };
#endif

uniform int expansionIndex;

void main() {
    uint count = expansions[expansionIndex].unmade.w;
    uint i = gl_WorkGroupID.x;
    if (i >= count) {
        return;
    }
    uint x = gl_LocalInvocationID.x % 8u;
    uint inRow = x / 2u * kWordsPerTile + gl_LocalInvocationID.x / 8u * 2u + x % 2u;
    do {
        uint word = work[unmadeStart(1 - listNoted) + i] * kTilesPerRow * kWordsPerTile + inRow;
        ivec3 place = placeOfWord(word);
        uint bits = 0u;
        for (int bit = 0; bit < 32; ++bit) {
            bits |= uint(isAdmissible(min(voxelAt(place, bit), gridDims - 1))) << bit;
        }
        bits &= insideGrid(place) & ~grown[word];
#ifdef VS_FORBIDDEN
        bits &= ~forbidden[word];
#endif
        allowed[word] = bits;
        i += gl_NumWorkGroups.x;
    } while (i < count);
}
