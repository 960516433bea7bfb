// Finds where membership differs from what the segmentation volume holds, and which of a tile's 27 neighbours (itself
// included) lie within the kernel's reach of such voxels. One group a tile; an invocation walks four rows along x.
// In: texture 1 segmentation; storage 0 tiles, 3 voxels shown. Out: storage 1 neighbour bits of each tile, zeros at first.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

layout(binding = 1) uniform sampler3D segmentation;
layout(location = 6) uniform int channel; // of the segmentation

layout(std430, binding = 1) buffer Reach { uint reach[]; };

// Three bits: whether something within reach of the previous tile, in this tile, or within reach of the next.
uint sides(int place) { return 2u | (place < kReach ? 1u : 0u) | (place >= kTile - kReach ? 4u : 0u); }

void main() {
    ivec3 origin = tileOrigin(gl_WorkGroupID.x);
    uint neighbours = 0u;
    for (int row = int(gl_LocalInvocationIndex); row < kTile * kTile; row += 64) {
        int y = row & (kTile - 1);
        int z = row >> 4;
        uint alongX = 0u;
        uint members = membersFrom(origin + ivec3(0, y, z));
        for (int x = 0; x < kTile; ++x) {
            ivec3 voxel = origin + ivec3(x, y, z);
            ivec3 inside = min(voxel, dims - 1);
            bool differs = (members >> x & 1u) != uint(texelFetch(segmentation, inside, 0)[channel] >= 0.5);
            alongX |= differs && voxel == inside ? sides(x) : 0u;
        }
        uint sidesY = sides(y);
        uint sidesZ = sides(z);
        uint plane = 0u;
        for (int i = 0; i < 3; ++i) {
            plane |= (sidesY >> i & 1u) != 0u ? alongX << (3 * i) : 0u;
        }
        for (int i = 0; i < 3; ++i) {
            neighbours |= (sidesZ >> i & 1u) != 0u ? plane << (9 * i) : 0u;
        }
    }
    if (neighbours != 0u) {
        atomicOr(reach[uint(firstTile) + gl_WorkGroupID.x], neighbours);
    }
}
