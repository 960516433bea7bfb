// Packs membership into bits, which the smoothing reads many times: bit i of a row is the voxel i - 3 places after the tile's
// first along x. One invocation a row of 22 voxels.
// In: texture 0 seed map; storage 0 tiles. Out: storage 1, 22 x 22 rows a tile.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 1) writeonly buffer Rows { uint rows[]; };

void main() {
    int row = int(gl_GlobalInvocationID.x); // y + 22 z
    if (row >= kPadded * kPadded) {
        return;
    }
    ivec3 first = tileOrigin(gl_WorkGroupID.y) + ivec3(0, row % kPadded, row / kPadded) - kReach;
    bool isInside = all(lessThan(uvec2(first.yz), uvec2(dims.yz)));
    // Nothing lies outside the grid.
    int begin = max(0, -first.x);
    int end = isInside ? min(kPadded, dims.x - first.x) : 0;
    uint bits = 0u;
    for (int x = begin; x < end; ++x) {
        bits |= uint(isMember(first + ivec3(x, 0, 0))) << x;
    }
    rows[gl_WorkGroupID.y * uint(kPadded * kPadded) + uint(row)] = bits;
}
