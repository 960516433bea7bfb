// The tiles that the next expansion has to look at, each once. Include after words.glsl.
// Bindings: storage 5 (expansions), 6 (work). With VS_BY_ROWS, rows that are near for the first time are
// noted too.

const uint kTilesPerGroup = 16u;
const uint kTilesPerRow = 4u;
const uint kMaxGroups =
    65535u; // per dispatch; the lists are walked with a stride, so fewer groups lose nothing

// One expansion: arguments of its two indirect dispatches, whose w counts the tiles, or the rows of tiles.
struct Expansion {
    uvec4 tiles;  // x groups, y = z = 1, w tiles
    uvec4 unmade; // likewise, a group a row, those rows that are near for the first time
    uvec4 grown;  // x + y + z + w: voxels grown
};
#include "segment/shaders/bindings.glsl"
layout(std430, binding = kExpansionsStorage) buffer Expansions { Expansion expansions[]; };
// Six parts, a number for each tile: the last expansion that was to look at it; the rules under which the
// words of a row of four tiles (a brick's along x, one after the other) in the plane `allowed` are made; two
// lists of tiles, and two of rows that are not made, which is cheaper together: a row of values shares a
// cache line. And four for what an expansion found in each tile of its list: from bit 8 on voxels that
// joined, bit 6 whether there were newest ones, below the sides that some touch.
layout(std430, binding = kWorkStorage) buffer Work { uint work[]; };

uniform uint stamp;         // of the expansion that tiles are noted for
uniform int expansionNoted; // its place in `expansions`
uniform uint tileCount;
uniform int listNoted;    // 0 or 1: which of the lists it takes
uniform uint rulesNumber; // of the present rules

uint listStart(int list) { return (2u + uint(list)) * tileCount; }
uint unmadeStart(int list) { return (4u + uint(list)) * tileCount; }

uint findingsStart() { return 6u * tileCount; }

uint groupsFor(uint place) { return min(place / kTilesPerGroup + 1u, kMaxGroups); }

// Rows that a tile at work lies in and that are not made.
void noteRowOf(uint tile) {
    uint row = tile / kTilesPerRow;
    if (work[tileCount + row] != rulesNumber &&
        atomicExchange(work[tileCount + row], rulesNumber) != rulesNumber) {
        uint place = atomicAdd(expansions[expansionNoted].unmade.w, 1u);
        work[unmadeStart(listNoted) + place] = row;
        atomicMax(expansions[expansionNoted].unmade.x, min(place + 1u, kMaxGroups));
    }
}

void activate(uint tile) {
    if (tile < tileCount && work[tile] != stamp && atomicExchange(work[tile], stamp) != stamp) {
        uint place = atomicAdd(expansions[expansionNoted].tiles.w, 1u);
        work[listStart(listNoted) + place] = tile;
        if (place % kTilesPerGroup == 0u) {
            atomicMax(expansions[expansionNoted].tiles.x, groupsFor(place));
        }
#ifdef VS_BY_ROWS
        noteRowOf(tile);
#endif
    }
}

// Bit x + 3 y + 9 z of `around` (13: the tile itself) stands for a tile next to the one at this place.
void activateAround(ivec3 place, uint around) {
    if (around != 0u) {
        do {
            int n = findLSB(around);
            activate(tileAt(place + ivec3(n % 3, n / 3 % 3, n / 9) - 1));
            around &= around - 1u;
        } while (around != 0u);
    }
}

// The tiles that neighbours of new voxels lie in. `sides`: which sides of the tile some of them touch: bits 0
// and 1 lower and upper x, 2 and 3 y, 4 and 5 z.
uint tilesTouched(uint sides) {
    uint around = 1u << 13;
#ifdef VS_NEIGHBOURS_26
    uint alongX = 2u | (sides & 1u) | (sides & 2u) << 1;
    uint alongY = 2u | (sides >> 2 & 1u) | (sides >> 2 & 2u) << 1;
    uint alongZ = 2u | (sides >> 4 & 1u) | (sides >> 4 & 2u) << 1;
    uint plane =
        (alongY & 1u) * alongX | ((alongY >> 1 & 1u) * alongX) << 3 | ((alongY >> 2 & 1u) * alongX) << 6;
    around |= (alongZ & 1u) * plane | ((alongZ >> 1 & 1u) * plane) << 9 | ((alongZ >> 2 & 1u) * plane) << 18;
#else
    around |= (sides & 1u) << 12 | (sides >> 1 & 1u) << 14 | (sides >> 2 & 1u) << 10 |
              (sides >> 3 & 1u) << 16 | (sides >> 4 & 1u) << 4 | (sides >> 5 & 1u) << 22;
#endif
    return around;
}

// The sides that new voxels of one word touch.
uint sidesOf(uint bits, uint word) {
    uint x = word & 1u;
    uint y = word >> 1 & 1u;
    uint z = word >> 2 & 3u;
    return uint(x == 0u && (bits & 0x11111111u) != 0u) | uint(x == 1u && (bits & 0x88888888u) != 0u) << 1 |
           uint(y == 0u && (bits & 0x000f000fu) != 0u) << 2 |
           uint(y == 1u && (bits & 0xf000f000u) != 0u) << 3 | uint(z == 0u && (bits & 0xffffu) != 0u) << 4 |
           uint(z == 3u && bits >> 16 != 0u) << 5;
}
// The same for a slab.
uint sidesOfSlab(uvec4 bits, uint slab) {
    uint all = bits.x | bits.y | bits.z | bits.w;
    uint z = slab & 3u;
    return uint(((bits.x | bits.z) & 0x11111111u) != 0u) |
           uint(((bits.y | bits.w) & 0x88888888u) != 0u) << 1 |
           uint(((bits.x | bits.y) & 0x000f000fu) != 0u) << 2 |
           uint(((bits.z | bits.w) & 0xf000f000u) != 0u) << 3 | uint(z == 0u && (all & 0xffffu) != 0u) << 4 |
           uint(z == 3u && all >> 16 != 0u) << 5;
}
