// Smooths membership along x and y. One invocation a row of 16 voxels along y, with a sliding window.
// In: storage 1, 22 x 22 packed rows a tile. Out: storage 2, 16 x 16 x 22 values a tile, negative at the
// region's voxels (the value itself is positive there).
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
layout(std430, binding = kRowsStorage) readonly buffer Rows { uint rows[]; };
layout(std430, binding = kAlongXYStorage) writeonly buffer AlongXY { float alongXY[]; };

uniform vec4 weightsX;

// The lowest seven bits smoothed along x, at the middle one.
float alongX(uint bits) {
    return smoothed(weightsX, float(bits & 1u), float(bits >> 1 & 1u), float(bits >> 2 & 1u),
                    float(bits >> 3 & 1u), float(bits >> 4 & 1u), float(bits >> 5 & 1u),
                    float(bits >> 6 & 1u));
}

void main() {
    uint row = gl_GlobalInvocationID.x; // x + 16 z
    if (row >= uint(kTile * kPadded)) {
        return;
    }
    int x = int(row) % kTile;
    uint slice = gl_WorkGroupID.y * uint(kPadded) + row / uint(kTile);
    uint from = slice * uint(kPadded);
    uint to = slice * uint(kTile * kTile) + uint(x);
    float a = 0.0;
    float b = alongX(rows[from] >> x);
    float c = alongX(rows[from + 1u] >> x);
    float d = alongX(rows[from + 2u] >> x);
    float e = alongX(rows[from + 3u] >> x);
    float f = alongX(rows[from + 4u] >> x);
    float g = alongX(rows[from + 5u] >> x);
    // The rows from the middle of the window on, which say where the region is.
    uint m0 = rows[from + 3u];
    uint m1 = rows[from + 4u];
    uint m2 = rows[from + 5u];
    for (uint y = 0u; y < uint(kTile); ++y) {
        uint newest = rows[from + y + 6u];
        a = b;
        b = c;
        c = d;
        d = e;
        e = f;
        f = g;
        g = alongX(newest >> x);
        float value = smoothed(weights, a, b, c, d, e, f, g);
        alongXY[to + y * uint(kTile)] = (m0 >> (x + kReach) & 1u) != 0u ? -value : value;
        m0 = m1;
        m1 = m2;
        m2 = newest;
    }
}
