// Smooths along y what is smooth along x. One invocation a row of 16 voxels along y, with a sliding window.
// In: storage 1, 16 x 22 x 22 values a tile. Out: storage 2, 16 x 16 x 22 values a tile.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

layout(std430, binding = 1) readonly buffer AlongX { float alongX[]; };
layout(std430, binding = 2) writeonly buffer AlongXY { float alongXY[]; };

void main() {
    uint row = gl_GlobalInvocationID.x; // x + 16 z
    if (row >= uint(kTile * kPadded)) {
        return;
    }
    const uint stride = uint(kTile);
    uint x = row % stride;
    uint z = row / stride;
    uint from = (gl_WorkGroupID.y * uint(kPadded) + z) * uint(kPadded) * stride + x;
    uint to = (gl_WorkGroupID.y * uint(kPadded) + z) * uint(kTile) * stride + x;
    float a = 0.0;
    float b = alongX[from];
    float c = alongX[from + stride];
    float d = alongX[from + 2u * stride];
    float e = alongX[from + 3u * stride];
    float f = alongX[from + 4u * stride];
    float g = alongX[from + 5u * stride];
    for (uint y = 0u; y < uint(kTile); ++y) {
        a = b;
        b = c;
        c = d;
        d = e;
        e = f;
        f = g;
        g = alongX[from + (y + 6u) * stride];
        alongXY[to + y * stride] = smoothed(a, b, c, d, e, f, g);
    }
}
