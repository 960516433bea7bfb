// Packs membership into bits, which the smoothing reads many times: bit i of a row is the voxel i - 3 places
// after the tile's first along x. With VS_APART the membership of one segment alone (own_members.glsl). One
// invocation a row of 22 voxels. In: storage 0 tiles, 3 and 4 voxels shown. Out: storage 1, 22 x 22 rows a
// tile.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kRowsStorage) writeonly buffer Rows { uint rows[]; };

#include "segment/shaders/own_members.glsl"

void main() {
    int row = int(gl_GlobalInvocationID.x); // y + 22 z
    if (row >= kPadded * kPadded) {
        return;
    }
    ivec3 first = tileOrigin(gl_WorkGroupID.y) + ivec3(0, row % kPadded, row / kPadded) - kReach;
    uint bits = ownMembers(first, membersFrom(first));
    rows[gl_WorkGroupID.y * uint(kPadded * kPadded) + uint(row)] = bits;
}
