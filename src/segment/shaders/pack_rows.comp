// Packs membership into bits, which the smoothing reads many times: bit i of a row is the voxel i - 3 places
// after the tile's first along x. With VS_APART the membership of one segment alone, another one for each
// tile; where segments go on behind a cut, nobody's voxels are taken to be its. One invocation a row of 22
// voxels. In: storage 0 tiles, 3 and 4 voxels shown, with VS_APART 5 a label for each tile and texture 3
// labels. Out: storage 1, 22 x 22 rows a tile.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kRowsStorage) writeonly buffer Rows { uint rows[]; };

#ifdef VS_APART
layout(std430, binding = kLabelsOfTilesStorage) readonly buffer LabelsOfTiles { uint labelsOfTiles[]; };
layout(binding = kLabelTexture) uniform usampler3D labelTexture;

// Those of a row's members that belong to the tile's segment.
uint ownMembers(ivec3 first, uint members) {
    uint label = labelsOfTiles[uint(firstTile) + gl_WorkGroupID.y] & 0xffu;
    uint own = 0u;
    for (uint left = members; left != 0u; left &= left - 1u) {
        int x = findLSB(left);
        uint owner = texelFetch(labelTexture, first + ivec3(x, 0, 0), 0).r;
        own |= uint(owner == label || owner == 0u) << x;
    }
    return own;
}
#else
uint ownMembers(ivec3 first, uint members) { return members; }
#endif

void main() {
    int row = int(gl_GlobalInvocationID.x); // y + 22 z
    if (row >= kPadded * kPadded) {
        return;
    }
    ivec3 first = tileOrigin(gl_WorkGroupID.y) + ivec3(0, row % kPadded, row / kPadded) - kReach;
    uint bits = ownMembers(first, membersFrom(first));
    rows[gl_WorkGroupID.y * uint(kPadded * kPadded) + uint(row)] = bits;
}
