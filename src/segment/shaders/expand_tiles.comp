// One generation: in the tiles at work, every voxel that may be entered and lies next to one of the newest
// joins, and becomes one of the newest itself. A tile is four invocations' work; each slab belongs to one of
// them, so nothing but the lists of tiles needs atomics. In: the constraints, texture 0 data, 4 newest voxels
// in two planes, of which one is read and the other written (storage 2), 5 and storage 1 allowed: what may be
// entered and has not been. In and out: storage 0 grown, 3 and 4 generations, 5 expansions, 6 work. With
// VS_BY_VOXEL no voxel was tested before; those on offer are, here (instead of allowed: texture 6 grown,
// storage 7 what is forbidden, with VS_FORBIDDEN). With VS_FLOOD a set spreads through another, and there are
// no generations.
#include "segment/shaders/constraints.glsl"
#include "segment/shaders/words.glsl"
#include "segment/shaders/generations.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kGrownStorage) buffer Grown { uvec4 grown[]; };
layout(std430, binding = kAllowedStorage) writeonly buffer Allowed { uvec4 allowed[]; };
layout(std430, binding = kNewestStorage) writeonly buffer Newest { uvec4 newest[]; };
layout(binding = kNewestTexelsTexture) uniform usamplerBuffer newestTexels;
#ifdef VS_BY_VOXEL
layout(binding = kGrownTexelsTexture) uniform usamplerBuffer grownTexels;
#ifdef VS_FORBIDDEN
layout(std430, binding = kForbiddenToGrowStorage) readonly buffer Forbidden { uvec4 forbidden[]; };
#endif
#else
layout(binding = kAllowedTexelsTexture) uniform usamplerBuffer allowedTexels;
#endif

uniform int expansionIndex;
uniform uint generation;
uniform int isBefore;  // 1: the newest voxels have the generation before this one; 0: any
uniform uint newestAt; // the slab that begins the plane which is read
uniform uint nextAt;   // and the one which is written

// Read as texels, which is many times faster on software renderers.
uvec4 bitsOf(uint slab) { return texelFetch(newestTexels, int(newestAt + slab)); }
#ifdef VS_FLOOD
// The region is a plane of single words.
uvec4 allowedIn(uint slab) {
    uvec4 region;
    for (uint i = 0u; i < 4u; ++i) {
        region[i] = texelFetch(allowedTexels, int(4u * slab + i)).r;
    }
    return region & ~grown[slab];
}
#elif defined(VS_BY_VOXEL)
// Not tested yet.
uvec4 allowedIn(uint slab) {
    uvec4 open = ~texelFetch(grownTexels, int(slab));
#ifdef VS_FORBIDDEN
    open &= ~forbidden[slab];
#endif
    return open;
}
#else
uvec4 allowedIn(uint slab) { return texelFetch(allowedTexels, int(slab)); }
#endif
#include "segment/shaders/neighbours.glsl"

#ifdef VS_BY_VOXEL
// Those of the voxels on offer, in the slab at a place, that the rules let in by themselves.
uvec4 admissible(ivec3 place, uvec4 offered) {
    uvec4 accepted = uvec4(0u);
    if (offered != uvec4(0u)) {
        do {
            uint inPlane = offered.x | offered.y;
            uint i = inPlane != 0u ? uint(offered.x == 0u) : 2u + uint(offered.z == 0u);
            int bit = findLSB(offered[i]);
            ivec3 voxel = voxelAt(place * ivec3(2, 2, 1) + ivec3(i & 1u, i >> 1, 0), bit);
            bool isAccepted = isAdmissible(min(voxel, gridDims - 1)) && isInside(voxel);
            accepted[i] |= uint(isAccepted) << bit;
            offered[i] &= offered[i] - 1u;
        } while (offered != uvec4(0u));
    }
    return accepted;
}
#endif

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
            for (isNeighbour = isNeighbour && !isAccepted && isInside(parent); isNeighbour;
                 isNeighbour = false) {
                uint word = wordAt(wordPlaceOf(parent));
                bool isParent = (bitsOf(word >> 2)[word & 3u] >> bitOf(parent) & 1u) != 0u;
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

// What note_tiles.comp needs to know (see `work` in active_tiles.glsl).
uint expandSlab(uint slab) {
    ivec3 place = placeOfSlab(slab);
    uvec4 open = allowedIn(slab);
    uvec4 fresh = nextTo(place) & open;
#ifdef VS_BY_VOXEL
    fresh = admissible(place, fresh);
#endif
#ifdef VS_PAIRED
    for (int i = 0; i < 4; ++i) {
        fresh[i] = acceptedPairs(place * ivec3(2, 2, 1) + ivec3(i & 1, i >> 1, 0), fresh[i]);
    }
#endif
    newest[nextAt + slab] = fresh;
    if (fresh != uvec4(0u)) {
        uvec4 grownBefore = grown[slab];
        grown[slab] = grownBefore | fresh;
#if !defined(VS_FLOOD) && !defined(VS_BY_VOXEL)
        allowed[slab] = open & ~fresh;
#endif
#ifndef VS_FLOOD
        uvec4 before = isBefore != 0 ? bitsOf(slab) : uvec4(0u);
        storeGenerationsOfSlab(slab, fresh, before, grownBefore & ~before, generation);
#endif
    }
    ivec4 counts = bitCount(fresh);
    return sidesOfSlab(fresh, slab) | uint(bitsOf(slab) != uvec4(0u)) << 6 |
           uint(counts.x + counts.y + counts.z + counts.w) << 8;
}

void main() {
    uint count = expansions[expansionIndex].tiles.w;
    uint i = gl_GlobalInvocationID.x / kSlabsPerTile;
    if (i >= count) {
        return;
    }
    uint z = gl_GlobalInvocationID.x % kSlabsPerTile;
    do {
        uint tile = work[listStart(1 - listNoted) + i];
        work[findingsStart() + kSlabsPerTile * i + z] = expandSlab(tile * kSlabsPerTile + z);
        i += gl_NumWorkGroups.x * kTilesPerGroup;
    } while (i < count);
}
