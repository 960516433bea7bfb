// Writes the region without smoothing: 1 at its voxels, 0 at all others. One invocation a row of 16 voxels
// along x. In: storage 0 tiles, 3 and 4 voxels shown. Out: image 0 segmentation.
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 64) in;

#include "segment/shaders/segmentation_image.glsl"

void main() {
    int row = int(gl_GlobalInvocationID.x);
    ivec3 voxel = tileOrigin(gl_WorkGroupID.y) + ivec3(0, row & (kTile - 1), row >> 4);
    if (any(greaterThanEqual(voxel, dims))) {
        return;
    }
    int width = min(kTile, dims.x - voxel.x);
    uint members = membersFrom(voxel);
    for (int x = 0; x < width; ++x, ++voxel.x) {
        storeMembership(voxel, float(members >> x & 1u));
    }
}
