// Cutting voxel by voxel by an energy that is known for each: the includer's main() goes along lineStart()
// and calls combineVoxel(). Work groups are the tiles of 8^3 voxels in a list, one invocation a line along x.
layout(local_size_x = 8, local_size_y = 8) in;

#include "sculpt/shaders/stored_values.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(SCULPTURE_FORMAT, binding = kSolidSculptureImage) uniform image3D sculpture;

layout(std430, binding = kTileListStorage) readonly buffer TileList { uint tileList[]; };

uniform ivec3 tileDims;
uniform ivec3 firstVoxel; // of the sculpture, where it is a window onto a larger one
uniform ivec3 dims;       // of the grid
uniform int isRestore;
uniform mat4 worldFromVoxel;
uniform float sigma; // of the edge, mm

#include "sculpt/shaders/limits.glsl"
#include "sculpt/shaders/tiles.glsl"

// The first voxel of this invocation's line; false when there is none.
bool lineStart(out ivec3 voxel) {
    ivec3 tile;
    bool exists = tileOfGroup(tileDims, tile);
    voxel = tile * 8 + ivec3(0, gl_LocalInvocationID.xy);
    return exists && all(lessThan(voxel, dims));
}

// Half the Gaussian's integral: the energy at a distance (mm, positive inside) from a plane. To 1.5e-4
// (Bowling et al. 2009, a logistic approximation).
float energyBehind(float distance) {
    float x = clamp(distance / sigma, -6.0, 6.0);
    return 1.0 / (1.0 + exp(-x * (1.5976 + 0.070566 * x * x)));
}

void combineVoxel(ivec3 voxel, float wholeEnergy) {
    float energy = min(wholeEnergy, mostEnergy(voxel - firstVoxel));
    if (energy > negligible) {
        float before = imageLoad(sculpture, voxel - firstVoxel).r;
        float e = energy > 1.0 - negligible ? 1.0 : energy;
        float remains = e >= 0.5 ? min(1.0 - e, justVisible) : 1.0 - e;
        float wanted = asStored(isRestore != 0 ? min(before, remains) : max(before, e));
        if (differ(wanted, before)) {
            imageStore(sculpture, voxel - firstVoxel, vec4(wanted));
        }
    }
}
