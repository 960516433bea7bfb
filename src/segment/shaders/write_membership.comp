// Writes the region without smoothing: 1 at its voxels, 0 at all others. One invocation a row of 16 voxels
// along x. In: storage 0 tiles, 3 and 4 voxels shown. Out: image 0 segmentation,
// or with VS_APART tiles of one segment alone.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/own_members.glsl"
#include "segment/shaders/segmentation_image.glsl"

void main() {
    int row = int(gl_GlobalInvocationID.x);
    ivec3 voxel = tileOrigin(gl_WorkGroupID.y) + ivec3(0, row & (kTile - 1), row >> 4);
    if (any(greaterThanEqual(voxel, dims))) {
        return;
    }
    int width = min(kTile, dims.x - voxel.x);
    uint members = ownMembers(voxel, membersFrom(voxel) & (1u << width) - 1u);
    for (int x = 0; x < width; ++x, ++voxel.x) {
        storeMembership(voxel, float(members >> x & 1u));
    }
}
