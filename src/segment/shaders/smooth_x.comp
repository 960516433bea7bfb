// Smooths membership along x. One invocation a row of 16 voxels, with a sliding window.
// In: texture 0 seed map; storage 0 tiles. Out: storage 1, 16 x 22 x 22 values a tile.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 1) writeonly buffer AlongX { float alongX[]; };

void main() {
    int row = int(gl_GlobalInvocationID.x); // y + 22 z
    if (row >= kPadded * kPadded) {
        return;
    }
    ivec3 voxel = tileOrigin(gl_WorkGroupID.y) + ivec3(0, row % kPadded - kReach, row / kPadded - kReach);
    uint place = (gl_WorkGroupID.y * uint(kPadded * kPadded) + uint(row)) * uint(kTile);
    float a = 0.0;
    float b = membership(voxel - ivec3(3, 0, 0));
    float c = membership(voxel - ivec3(2, 0, 0));
    float d = membership(voxel - ivec3(1, 0, 0));
    float e = membership(voxel);
    float f = membership(voxel + ivec3(1, 0, 0));
    float g = membership(voxel + ivec3(2, 0, 0));
    for (int x = 0; x < kTile; ++x) {
        a = b;
        b = c;
        c = d;
        d = e;
        e = f;
        f = g;
        g = membership(voxel + ivec3(x + 3, 0, 0));
        alongX[place + uint(x)] = smoothed(a, b, c, d, e, f, g);
    }
}
