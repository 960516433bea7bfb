// Combines radiation with the sculpture in the radiation's tiles: one work group a tile, one invocation a
// line along x. In: storage 0 tile list, image 0 energy (texel t is voxel originVoxel + t), image 2 an
// earlier sculpture. In/out: image 1 sculpture. Out: storage 1 number of voxels changed.
// variants: SCULPTURE_BITS=8;SCULPTURE_BITS=16;SCULPTURE_BITS=32;SCULPTURE_BITS=16 LIMITED=1
layout(local_size_x = 8, local_size_y = 8) in;

#include "sculpt/shaders/bindings.glsl"
layout(std430, binding = kTileListStorage) readonly buffer TileList { uint tileList[]; };
layout(std430, binding = kChangedStorage) buffer Changed { uint changed; };
layout(r32f, binding = kEnergyImage) uniform readonly image3D energy;
#include "sculpt/shaders/stored_values.glsl"
layout(SCULPTURE_FORMAT, binding = kSculptureImage) uniform image3D sculpture;
layout(SCULPTURE_FORMAT, binding = kEarlierImage) uniform readonly image3D earlier;

uniform ivec3 tileDims;
uniform ivec3 originVoxel;
uniform ivec3 firstVoxel; // of the sculpture, where it is a window onto a larger one
uniform ivec3 dims;
uniform int isRestore;
uniform int base; // united with: 0 the sculpture as it is, 1 the earlier one, 2 nothing

#include "sculpt/shaders/limits.glsl"
#include "sculpt/shaders/tiles.glsl"

void main() {
    ivec3 tile;
    if (!tileOfGroup(tileDims, tile)) {
        return;
    }
    ivec3 texel = tile * 8 + ivec3(0, gl_LocalInvocationID.xy);
    uint count = 0u;
    for (int n = 0; n < 8; ++n) {
        ivec3 voxel = texel + originVoxel - firstVoxel;
        if (all(greaterThanEqual(voxel, ivec3(0))) && all(lessThan(voxel, dims))) {
            float e = min(clamp(imageLoad(energy, texel).r, 0.0, 1.0), mostEnergy(voxel));
            float stored = imageLoad(sculpture, voxel).r;
            float before = base == 0 ? stored : (base == 1 ? imageLoad(earlier, voxel).r : 0.0);
            float remains = e >= 0.5 ? min(1.0 - e, justVisible) : 1.0 - e;
            float wanted = isRestore != 0 ? min(before, remains) : max(before, e);
            float after = e > negligible ? asStored(wanted) : before;
            if (differ(after, stored)) {
                imageStore(sculpture, voxel, vec4(after));
                ++count;
            }
        }
        texel.x += 1;
    }
    if (count > 0u) {
        atomicAdd(changed, count);
    }
}
