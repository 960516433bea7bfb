// After an expansion: counts what has joined, and notes which tiles the next one has to look at. One
// invocation a tile that was at work. In and out: storage 1 first and last generation of each brick, 5
// expansions, 6 work.
#include "segment/shaders/words.glsl"
#include "segment/shaders/active_tiles.glsl"

layout(local_size_x = 16) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kBrickNumbersStorage) buffer Bricks { uvec2 bricks[]; };

uniform int expansionIndex;
uniform uint generation;
uniform int cleansUp; // 0: the plane that the expansion read will be cleared

// Generations only rise, and all of this dispatch write the same one.
void noteInBrick(uint brick) {
    if (bricks[brick].y != generation) {
        uint first = bricks[brick].x;
        bricks[brick] = uvec2(first == 0u ? generation : first, generation);
    }
}

void main() {
    uint count = expansions[expansionIndex].tiles.w;
    uint grown = 0u;
    uint i = gl_GlobalInvocationID.x;
    if (i >= count) {
        return;
    }
    do {
        uint tile = work[listStart(1 - listNoted) + i];
        uint sides = 0u;
        uint total = 0u;
        for (uint z = 0u; z < kSlabsPerTile; ++z) {
            uint found = work[findingsStart() + kSlabsPerTile * i + z];
            sides |= found & 0xffu;
            total += found >> 8;
        }
        grown += total;
#ifndef VS_FLOOD
        if (total != 0u) {
            noteInBrick(tile / kTilesPerBrick);
        }
#endif
        // A tile whose newest voxels nobody follows is looked at once more, so that both planes are left
        // without them.
        uint again = cleansUp != 0 ? sides >> 6 & 1u : 0u;
        uint around = total != 0u ? tilesTouched(sides) : again << 13;
        activateAround(placeOfTile(tile), around);
        i += gl_NumWorkGroups.x * kTilesPerGroup;
    } while (i < count);
    atomicAdd(expansions[expansionIndex].grown[gl_WorkGroupID.x & 3u], grown);
}
