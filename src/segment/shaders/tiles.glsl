// Segmentation is updated in tiles of 16^3 voxels; smoothing looks 3 voxels beyond. Two scratch blocks hold, for each tile
// at work, membership in 22 x 22 rows of 22 bits, and values smoothed along x and y (16 x 16 x 22, x fastest).
// Spaces: voxel indices. Bindings: texture 0 seed map; storage 0 tile indices; uniforms 0 to 4.

const int kTile = 16;
const int kReach = 3;
const int kPadded = kTile + 2 * kReach;

layout(binding = 0) uniform usampler3D seedMap;
layout(std430, binding = 0) readonly buffer Tiles { uint tiles[]; };

layout(location = 0) uniform ivec3 dims;
layout(location = 1) uniform ivec3 tileDims;
layout(location = 2) uniform int playhead;
layout(location = 3) uniform int firstTile;
layout(location = 4) uniform vec4 weights; // along the axis at work, of voxels at distance 0, 1, 2, 3

ivec3 tileOrigin(uint place) {
    uint index = tiles[uint(firstTile) + place];
    uvec3 size = uvec3(tileDims);
    return ivec3(index % size.x, index / size.x % size.y, index / (size.x * size.y)) * kTile;
}

// The voxel must be inside the grid.
bool isMember(ivec3 voxel) {
    uint generation = texelFetch(seedMap, voxel, 0).r;
    return generation != 0u && generation <= uint(playhead);
}

// Seven values in a row, of which the middle one is smoothed. One order of terms for every voxel, whatever tile it is
// reached from, so that incremental updates equal full ones.
float smoothed(vec4 w, float a, float b, float c, float d, float e, float f, float g) {
    return w.x * d + w.y * (c + e) + w.z * (b + f) + w.w * (a + g);
}
