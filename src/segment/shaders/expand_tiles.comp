// One generation: in the tiles at work, every voxel that may be entered and lies next to one of the newest joins, and becomes
// one of the newest itself. A tile is eight invocations' work; each word belongs to one of them, so nothing but the lists of tiles
// needs atomics.
// In: the constraints, texture 0 data, 4 newest voxels in two planes, of which one is read and the other written (storage 2),
// 5 allowed. In and out: storage 0 grown, 3 and 4 generations, 5 steps, 6 work.
// With VS_FLOOD a set spreads through another, and there are no generations.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 0) buffer Grown { uint grown[]; };
layout(std430, binding = 2) writeonly buffer Newest { uint newest[]; };
layout(binding = 4) uniform usamplerBuffer newestTexels;
layout(binding = 5) uniform usamplerBuffer allowedTexels;

layout(location = 10) uniform int stepIndex;
layout(location = 11) uniform uint generation;
layout(location = 13) uniform uint newestAt;    // where the plane begins that is read
layout(location = 14) uniform uint nextAt;      // and the one that is written

// Read as texels, which is many times faster on software renderers.
uint bitsOf(uint word) { return texelFetch(newestTexels, int(newestAt + word)).r; }
#include "segment/shaders/neighbours.glsl"

#ifdef VS_PAIRED
// Those of the voxels on offer that one of the newest around them may be left for.
uint acceptedPairs(ivec3 place, uint offered) {
    uint accepted = 0u;
    for (uint left = offered; left != 0u; left &= left - 1u) {
        int bit = findLSB(left);
        ivec3 child = voxelAt(place, bit);
        bool isAccepted = false;
        for (int n = 0; n < 27; ++n) {
            ivec3 offset = ivec3(n % 3, n / 3 % 3, n / 9) - 1;
#ifdef VS_NEIGHBOURS_26
            bool isNeighbour = n != 13;
#else
            bool isNeighbour = abs(offset.x) + abs(offset.y) + abs(offset.z) == 1;
#endif
            ivec3 parent = child + offset;
            for (isNeighbour = isNeighbour && !isAccepted && isInside(parent); isNeighbour; isNeighbour = false) {
                bool isParent = (bitsOf(wordAt(wordPlaceOf(parent))) >> bitOf(parent) & 1u) != 0u;
                for (; isParent; isParent = false) {
                    isAccepted = isAdmissibleFrom(parent, child);
                }
            }
        }
        accepted |= uint(isAccepted) << bit;
    }
    return accepted;
}
#endif

// What note_tiles.comp needs to know (see found() there).
uint expandTile(uint tile, uint lane) {
    ivec3 place = placeOfTile(tile);
    uint total = 0u;
    uint sides = 0u;
    uint hadNewest = 0u;
    for (uint part = 0u; part < 2u; ++part) {
        uint word = tile * kWordsPerTile + 8u * part + lane;
        ivec3 wordPlace = place * ivec3(2, 2, 4) + ivec3(lane & 1u, lane >> 1 & 1u, 2u * part + (lane >> 2));
        uint fresh = nextTo(wordPlace) & texelFetch(allowedTexels, int(word)).r & ~grown[word];
#ifdef VS_PAIRED
        fresh = acceptedPairs(wordPlace, fresh);
#endif
        hadNewest |= bitsOf(word);
        newest[nextAt + word] = fresh;
        grown[word] |= fresh;
        total += uint(bitCount(fresh));
        sides |= sidesOf(fresh, word);
#ifndef VS_FLOOD
        storeGenerations(word, fresh, generation);
#endif
    }
    return sides | uint(hadNewest != 0u) << 6 | total << 8;
}

void main() {
    uint count = steps[stepIndex].tiles.w;
    uint slot = gl_LocalInvocationID.x / 8u;
    for (uint i = gl_WorkGroupID.x * kTilesPerGroup + slot; i < count; i += gl_NumWorkGroups.x * kTilesPerGroup) {
        uint lane = gl_LocalInvocationID.x % 8u;
        work[findingsStart() + 8u * i + lane] = expandTile(work[listStart(1 - listNoted) + i], lane);
    }
}
