// Which voxels that have not grown the rules let in, by themselves, in tiles that growth comes near for the first time. One
// invocation a word.
// In: the constraints, texture 0 data, 1 sculpture; storage 0 grown, 5 steps, 6 work, 7 what is forbidden (with VS_FORBIDDEN). Out:
// storage 1 allowed.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Grown { uint grown[]; };
layout(std430, binding = 1) writeonly buffer Allowed { uint allowed[]; };
#ifdef VS_FORBIDDEN
layout(std430, binding = 7) readonly buffer Forbidden { uint forbidden[]; };
#endif

layout(location = 10) uniform int stepIndex;

void main() {
    uint count = steps[stepIndex].unmade.w;
    uint slot = gl_LocalInvocationID.x / kWordsPerTile;
    uint i = gl_WorkGroupID.x * 4u + slot;
    if (i >= count) {
        return;
    }
    do {
        uint tile = work[unmadeStart(1 - listNoted) + i];
        uint word = tile * kWordsPerTile + gl_LocalInvocationID.x % kWordsPerTile;
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
        i += gl_NumWorkGroups.x * 4u;
    } while (i < count);
}
