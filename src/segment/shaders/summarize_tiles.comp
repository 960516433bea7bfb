// Smallest and largest value of every macrocell (4^3 voxels, 5^3 corners) that has a corner in a tile. One
// group a tile, one invocation a cell; cells that two tiles share are written twice, alike. With VS_LOOSE
// anything may be in them, which takes no look at the voxels: while scrubbing. In: texture 1 segmentation;
// storage 0 tiles. Out: image 1 cells (rg32f).
#include "segment/shaders/tiles.glsl"

layout(local_size_x = 128) in;

#include "segment/shaders/bindings.glsl"
layout(binding = kSegmentationTexture) uniform sampler3D segmentation;
layout(rg32f, binding = kCellsImage) uniform writeonly image3D cells;

uniform ivec3 cellDims;

const int kCell = 4;
const int kCellsAround =
    kTile / kCell + 1; // along an axis: those inside, and the one whose last corner is the first voxel

void main() {
    int index = int(gl_LocalInvocationIndex);
    ivec3 place = ivec3(index % kCellsAround, index / kCellsAround % kCellsAround,
                        index / (kCellsAround * kCellsAround));
    ivec3 cell = tileOrigin(gl_WorkGroupID.y) / kCell - 1 + place;
    if (place.z >= kCellsAround || any(greaterThanEqual(uvec3(cell), uvec3(cellDims)))) {
        return;
    }
#ifdef VS_LOOSE
    imageStore(cells, cell, vec4(0.0, 1.0, 0.0, 0.0));
#else
    ivec3 first = cell * kCell;
    ivec3 last = min(first + kCell, dims - 1);
    float lo = 1.0;
    float hi = 0.0;
    for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
            for (int x = first.x; x <= last.x; ++x) {
                vec2 both = texelFetch(segmentation, ivec3(x, y, z), 0).rg;
                float value = max(both.r, both.g);
                lo = min(lo, value);
                hi = max(hi, value);
            }
        }
    }
    imageStore(cells, cell, vec4(lo, hi, 0.0, 0.0));
#endif
}
