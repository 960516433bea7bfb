// Smooths along z what is smooth along x and y, and holds the result to the truth: at least 0.5 at the
// region's voxels, below 0.5 at all others. One invocation a row of 16 voxels along z, with a sliding window.
// In: storage 0 tiles, 2 with 16 x 16 x 22 values a tile, negative at the region's voxels. Out: image 0
// segmentation (r8, or rg8 with VS_GLASS: then one channel of it), or with VS_APART tiles of one segment
// alone.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/bindings.glsl"
#include "segment/shaders/segmentation_image.glsl"
layout(std430, binding = kAlongXYStorage) readonly buffer AlongXY { float alongXY[]; };

// Held to the truth by mirroring at 0.5, so that the thinner a part is the farther its level is pushed out: a
// voxel on its own becomes a dot of nearly its own size, which can be seen, and not a point.
void store(ivec3 voxel, float texel, bool isMember) {
    storeMembership(voxel, (isMember ? max(texel, 255.0 - texel) : min(texel, 255.0 - texel)) / 255.0);
}

void main() {
    uint row = gl_GlobalInvocationID.x; // x + 16 y
    const uint stride = uint(kTile * kTile);
    ivec3 voxel = tileOrigin(gl_WorkGroupID.y) + ivec3(row % uint(kTile), row / uint(kTile), 0);
    if (any(greaterThanEqual(voxel, dims))) {
        return;
    }
    uint from = gl_WorkGroupID.y * uint(kPadded) * stride + row;
    float a = 0.0;
    float b = abs(alongXY[from]);
    float c = abs(alongXY[from + stride]);
    float d = abs(alongXY[from + 2u * stride]);
    float e = abs(alongXY[from + 3u * stride]);
    float f = abs(alongXY[from + 4u * stride]);
    float g = abs(alongXY[from + 5u * stride]);
    // Signs from the middle of the window on.
    bool m0 = alongXY[from + 3u * stride] < 0.0;
    bool m1 = alongXY[from + 4u * stride] < 0.0;
    bool m2 = alongXY[from + 5u * stride] < 0.0;
    int depth = min(kTile, dims.z - voxel.z);
    for (int z = 0; z < depth; ++z, ++voxel.z) {
        a = b;
        b = c;
        c = d;
        d = e;
        e = f;
        f = g;
        float newest = alongXY[from + (uint(z) + 6u) * stride];
        g = abs(newest);
        // In the texel's own units, where 0.5 lies between 127 and 128.
        float texel = round(clamp(smoothed(weights, a, b, c, d, e, f, g), 0.0, 1.0) * 255.0);
        store(voxel, texel, m0);
        m0 = m1;
        m1 = m2;
        m2 = newest < 0.0;
    }
}
