// Segmentation is updated in tiles of 16^3 voxels; smoothing looks 3 voxels beyond. Two scratch blocks hold,
// for each tile at work, membership in 22 x 22 rows of 22 bits, and values smoothed along x and y (16 x 16 x
// 22, x fastest). Spaces: voxel indices. Bindings: storage 0 tile indices, 3 the voxels shown, one bit each.
// With VS_CONTINUED storage 4 has the voxels that count as the opposite (continue_segments.comp).
#include "segment/shaders/words.glsl"

const int kTile = 16;
const int kReach = 3;
const int kPadded = kTile + 2 * kReach;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kTilesStorage) readonly buffer Tiles { uint tiles[]; };
layout(std430, binding = kShownStorage) readonly buffer Shown { uint shown[]; };
#ifdef VS_CONTINUED
layout(std430, binding = kTurnedStorage) readonly buffer Turned { uint turned[]; };
uint membersIn(uint word) { return shown[word] ^ turned[word]; }
#else
uint membersIn(uint word) { return shown[word]; }
#endif

uniform ivec3 tileDims;
uniform int firstTile;
uniform vec4 weights; // along the axis at work, of voxels at distance 0, 1, 2, 3

ivec3 tileOrigin(uint place) {
    uint index = tiles[uint(firstTile) + place];
    uvec3 size = uvec3(tileDims);
    return ivec3(index % size.x, index / size.x % size.y, index / (size.x * size.y)) * kTile;
}

// kPadded voxels along x from this one on, bit by bit; nothing lies outside the grid.
uint membersFrom(ivec3 first) {
    uint members = 0u;
    uint shift = uint(first.y & 3) << 2 | uint(first.z & 1) << 4;
    for (int word = 0; word < 7; ++word) {
        int x = (first.x & ~3) + 4 * word;
        uint four = membersIn(wordAt(wordPlaceOf(ivec3(x, first.yz)))) >> shift & 15u;
        int to = x - first.x;
        members |= to >= 0 ? four << to : four >> -to;
    }
    return members & (1u << kPadded) - 1u;
}

// Seven values in a row, of which the middle one is smoothed. One order of terms for every voxel, whatever
// tile it is reached from, so that incremental updates equal full ones.
float smoothed(vec4 w, float a, float b, float c, float d, float e, float f, float g) {
    return w.x * d + w.y * (c + e) + w.z * (b + f) + w.w * (a + g);
}
