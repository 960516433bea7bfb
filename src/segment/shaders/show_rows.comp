// Which voxels are shown: those of visible segments, and of the segment at work those up to the playhead.
// In: texture 3 labels; storage 0 grown, 1 a number for each label, 3 and 4 generations, 7 brick numbers. In and out: storage 2
// the plane of those labels that have the wanted number; 5 for each of a brick's eight tiles of 16^3 voxels, which of the 27
// around it (itself included) a kernel of 3 voxels carries changes into, zeros at first.
// With VS_OTHERS there are other segments, with VS_HIDES generations after the playhead.
// One row of 16 groups a brick, an invocation a word.
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/owners.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) readonly buffer Grown { uint grown[]; };
layout(std430, binding = 1) readonly buffer Kinds { uint kinds[]; };
layout(std430, binding = 2) buffer Shown { uint shown[]; };
layout(std430, binding = 5) buffer Reach { uint reach[]; };
layout(std430, binding = 7) readonly buffer Bricks { uint bricks[]; };

layout(location = 9) uniform int firstBrick;
layout(location = 10) uniform uint playhead;
layout(location = 12) uniform uint wanted;   // the number that makes a label's voxels appear in this plane

uint visibleIn(uint word) {
    uint bits = grown[word];
#ifdef VS_OTHERS
    ivec3 place = placeOfWord(word);
    uint own = ownVoxels(place, bits);
    uint visible = 0u;
    for (; bits != 0u; bits &= bits - 1u) {
        int bit = findLSB(bits);
        visible |= uint(kinds[ownerOf(voxelAt(place, bit))] == wanted) << bit;
    }
#else
    uint own = bits;
    uint visible = kinds[activeLabel] == wanted ? bits : 0u;
#endif
#ifdef VS_HIDES
    visible &= ~laterThan(word, own, playhead);
#endif
    return visible;
}

// Bits 0 to 2: the tile before, this one, and the next.
uint along(bool isNearBefore, bool isNearNext) { return 2u | uint(isNearBefore) | uint(isNearNext) << 2; }

void noteChanges(uint word, uint changed) {
    uvec3 tile = uvec3(word >> 4, word >> 6, word >> 8) & 3u; // of 8^3 voxels, in the brick
    uvec3 place = (tile & 1u) * uvec3(2, 2, 4) + (uvec3(word, word >> 1, word >> 2) & uvec3(1, 1, 3)); // of the word, in 16^3
    uint x = along(place.x == 0u && (changed & 0x77777777u) != 0u, place.x == 3u && (changed & 0xeeeeeeeeu) != 0u);
    uint y = along(place.y == 0u && (changed & 0x0fff0fffu) != 0u, place.y == 3u && (changed & 0xfff0fff0u) != 0u);
    uint z = along(place.z == 0u || (place.z == 1u && (changed & 0xffffu) != 0u),
                   place.z == 7u || (place.z == 6u && changed >> 16 != 0u));
    uint plane = (y & 1u) * x | ((y >> 1 & 1u) * x) << 3 | (y >> 2) * x << 6;
    uint around = (z & 1u) * plane | ((z >> 1 & 1u) * plane) << 9 | (z >> 2) * plane << 18;
    uint at = (uint(firstBrick) + gl_WorkGroupID.y) * 8u + (tile.x >> 1 | (tile.y >> 1) << 1 | (tile.z >> 1) << 2);
    around = changed != 0u ? around : 0u;
    if ((around & ~reach[at]) != 0u) {
        atomicOr(reach[at], around);
    }
}

void main() {
    uint word = bricks[uint(firstBrick) + gl_WorkGroupID.y] * kWordsPerBrick + gl_GlobalInvocationID.x;
    uint visible = visibleIn(word);
    noteChanges(word, visible ^ shown[word]);
    shown[word] = visible;
}
