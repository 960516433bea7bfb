// Convolves tiles along AXIS with symmetric taps of REACH voxels on either side. One work group a tile, one
// invocation a line of 8 voxels, which it loads once with what the taps reach of the two neighbouring tiles.
// AXIS 0 turns fixed-point deposits into energy; AXIS 2, the last, also sets the deposits back to zero for
// the next use, unless they are to be kept.
// variants: AXIS=0 REACH=2 FIXED_ONE=4194304.0 FIXED_LIMIT=1073741824u;AXIS=1 REACH=0 FIXED_ONE=4194304.0 FIXED_LIMIT=1073741824u;AXIS=2 REACH=4 FIXED_ONE=4194304.0 FIXED_LIMIT=1073741824u
// In: storage 0 tile list, storage 1 stages (list_tiles.comp), image 0 deposits, image 1 source (AXIS 1 and
// 2). Out: image 2 result. Texels of tiles that the pass before has not computed are stale and count as zero.
layout(local_size_x = 8, local_size_y = 8) in;

#include "sculpt/shaders/bindings.glsl"
layout(std430, binding = kTileListStorage) readonly buffer TileList { uint tileList[]; };
layout(std430, binding = kStagesStorage) readonly buffer Stages { uint stages[]; };
layout(r32ui, binding = kDepositsImage) uniform uimage3D deposits;
layout(r32f, binding = kSourceImage) uniform readonly image3D source;
layout(r32f, binding = kResultImage) uniform writeonly image3D result;

uniform ivec3 tileDims;
uniform float taps[5];
uniform int keepsDeposits;

#include "sculpt/shaders/tiles.glsl"

#if AXIS == 0
const ivec3 along = ivec3(1, 0, 0);
#elif AXIS == 1
const ivec3 along = ivec3(0, 1, 0);
#else
const ivec3 along = ivec3(0, 0, 1);
#endif

ivec3 lineStart(ivec3 tile) {
    ivec2 local = ivec2(gl_LocalInvocationID.xy);
    return tile * 8 +
           (AXIS == 0 ? ivec3(0, local) : (AXIS == 1 ? ivec3(local.x, 0, local.y) : ivec3(local, 0)));
}

// 1 if the pass before has computed this tile, else 0.
uint isComputed(ivec3 tile) {
    bool inside = all(greaterThanEqual(tile, ivec3(0))) && all(lessThan(tile, tileDims));
    return inside ? (stages[(tile.z * tileDims.y + tile.y) * tileDims.x + tile.x] >> AXIS) & 1u : 0u;
}

float loadSource(ivec3 texel, uint valid) {
#if AXIS == 0
    return valid != 0u ? float(min(imageLoad(deposits, texel).r, FIXED_LIMIT)) * (1.0 / FIXED_ONE) : 0.0;
#else
    return valid != 0u ? imageLoad(source, texel).r : 0.0;
#endif
}

void main() {
    ivec3 tile;
    if (!tileOfGroup(tileDims, tile)) {
        return;
    }
    ivec3 start = lineStart(tile);
    uint before = isComputed(tile - along);
    uint here = isComputed(tile);
    uint after = isComputed(tile + along);
    float line[8 + 2 * REACH];
    for (int n = 0; n < 8 + 2 * REACH; ++n) {
        uint valid = n < REACH ? before : (n < 8 + REACH ? here : after);
        line[n] = loadSource(start + (n - REACH) * along, valid);
    }
    for (int n = 0; n < 8; ++n) {
        float sum = taps[0] * line[n + REACH];
        for (int k = 1; k <= REACH; ++k) {
            sum += taps[k] * (line[n + REACH - k] + line[n + REACH + k]);
        }
        imageStore(result, start + n * along, vec4(sum));
    }
#if AXIS == 2
    if (keepsDeposits == 0 && (stages[(tile.z * tileDims.y + tile.y) * tileDims.x + tile.x] & 1u) != 0u) {
        for (int n = 0; n < 8; ++n) {
            imageStore(deposits, start + n * along, uvec4(0u));
        }
    }
#endif
}
