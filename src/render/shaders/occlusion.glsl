// How much light reaches a place: ambient occlusion and soft shadows from the occlusion volume
// (render::OcclusionVolume). Lengths are in texel lengths (strictly, edges of a cube as large as a texel of
// level 0), directions in the world. Nothing here is random and no loop depends on what it finds, so
// neighbouring pixels do the same and shade alike. Loops have their number of turns from the block, so that
// they stay loops: a software renderer leaves them after one turn where no pixel of its eight is lit, and
// would go through all of them unrolled. Bindings: uniform block 3, texture 9.

#include "render/shaders/bindings.glsl"
layout(std140, binding = kOcclusionBlock) uniform OcclusionBlock {
    vec4 occlusionScale;        // xyz texture coordinate per voxel
    vec4 occlusionOffset;       // xyz texture coordinate of voxel 0
    vec4 occlusionFromWorld[3]; // texture coordinates per texel length along the world's x, y, z
    vec4 occlusionTexel[3];     // xyz edges of a texel in the world
    vec4 occlusionTowardsKey;   // xyz world, unit
    vec4 occlusionStrengths;    // x ambient occlusion, y shadow
    ivec4 occlusionLevels;      // x that ambient cones reach, y shadows
};

layout(binding = kOcclusionTexture) uniform sampler3D occlusionTexture;

// A level's texels are blurred into one another with a standard deviation of about 0.65 of their width.
// Farther than this many widths from a plane next to nothing of it is left.
const float kClear = 1.5;
// What is left nevertheless counts as nothing.
const float kFaint = 0.035;

// How much of what blocks the light at one distance is not behind what blocks it nearer by.
const float kOthers = 0.1;
// How much less ambient cones see of what is far: times the cube of the level.
const float kFade = 0.0032;

float blockedAt(vec3 place, float level) {
    return max(textureLod(occlusionTexture, place, level).r - kFaint, 0.0) * (1.0 / (1.0 - kFaint));
}

// Two parts of a cone's width that are blocked one behind the other: by the same thing, mostly, and by
// others.
float blockedByBoth(float a, float b) { return mix(max(a, b), a + b - a * b, kOthers); }
vec3 blockedByBoth(vec3 a, vec3 b) { return mix(max(a, b), a + b - a * b, kOthers); }

vec3 occlusionCoordinate(vec3 voxel) { return voxel * occlusionScale.xyz + occlusionOffset.xyz; }

vec3 occlusionDirection(vec3 world) {
    return occlusionFromWorld[0].xyz * world.x + occlusionFromWorld[1].xyz * world.y +
           occlusionFromWorld[2].xyz * world.z;
}

// Width of a texel across a surface with this normal.
float occlusionWidth(vec3 normal) {
    return length(vec3(dot(normal, occlusionTexel[0].xyz), dot(normal, occlusionTexel[1].xyz),
                       dot(normal, occlusionTexel[2].xyz)));
}

// The part of the sky above a surface that is open: 1 open .. 0 closed. `normal` world, unit.
// One wide cone along each of the world's axes on the normal's side, weighted by the squared cosine, as in
// ambient cubes (McTaggart 2004): the weights add up to 1 and go to 0 where an axis changes sides. Each is
// bent away from the surface until it no longer touches a flat one, and is as wide as it is long: one sample
// a level.
float ambientAt(vec3 voxel, vec3 normal) {
    vec3 start = occlusionCoordinate(voxel);
    vec3 up = occlusionDirection(normal);
    vec3 side = mix(vec3(1.0), vec3(-1.0), lessThan(normal, vec3(0.0)));
    vec3 lift = kClear * max(occlusionWidth(normal) - abs(normal), 0.0);
    vec3 x = kClear * side.x * occlusionFromWorld[0].xyz + lift.x * up;
    vec3 y = kClear * side.y * occlusionFromWorld[1].xyz + lift.y * up;
    vec3 z = kClear * side.z * occlusionFromWorld[2].xyz + lift.z * up;
    vec3 blocked = vec3(0.0);
    float width = 1.0;
    for (int level = 0; level < occlusionLevels.x; ++level) {
        float lod = float(level);
        vec3 there = vec3(blockedAt(start + width * x, lod), blockedAt(start + width * y, lod),
                          blockedAt(start + width * z, lod));
        // Less, the farther: illustrators light cavities.
        blocked = blockedByBoth(blocked, there * (1.0 - kFade * lod * lod * lod));
        width *= 2.0;
    }
    return 1.0 - dot(blocked, normal * normal) * occlusionStrengths.x;
}

// A sample of the shadow cone, kept off the surface it starts from.
float blockedTowardsKey(vec3 start, vec3 along, vec3 up, vec2 cosineAndClear, float distance, float width,
                        float level) {
    float height = max(cosineAndClear.y * width - distance * cosineAndClear.x, 0.0);
    return blockedAt(start + along * distance + up * height, level);
}

// The part of the key light that reaches a surface: 0 shadow .. 1. `normal` world, unit.
// One cone, three samples a level, each blurred over about a sixth of its distance.
float lightReaching(vec3 voxel, vec3 normal) {
    vec3 start = occlusionCoordinate(voxel);
    vec3 up = occlusionDirection(normal);
    vec3 along = occlusionDirection(occlusionTowardsKey.xyz);
    vec2 c = vec2(max(dot(normal, occlusionTowardsKey.xyz), 0.0), kClear * occlusionWidth(normal));
    float blocked = 0.0;
    float width = 1.0;
    for (int level = 0; level < occlusionLevels.y; ++level) {
        float lod = float(level);
        vec3 distance = width * vec3(4.6, 5.9, 7.2) - 3.4;
        vec3 there = vec3(blockedTowardsKey(start, along, up, c, distance.x, width, lod),
                          blockedTowardsKey(start, along, up, c, distance.y, width, lod),
                          blockedTowardsKey(start, along, up, c, distance.z, width, lod));
        blocked = blockedByBoth(blockedByBoth(blockedByBoth(blocked, there.x), there.y), there.z);
        width *= 2.0;
    }
    return 1.0 - blocked * occlusionStrengths.y;
}

// The same for places in a volume, from six samples: x of the key light, y of the sky.
vec2 cheapLight(vec3 voxel, vec3 normal) {
    vec3 start = occlusionCoordinate(voxel);
    vec3 up = occlusionDirection(normal);
    vec3 along = occlusionDirection(occlusionTowardsKey.xyz);
    vec2 c = vec2(max(dot(normal, occlusionTowardsKey.xyz), 0.0), kClear * occlusionWidth(normal));
    vec3 key = vec3(blockedTowardsKey(start, along, up, c, 4.0, 2.0, 1.0),
                    blockedTowardsKey(start, along, up, c, 10.0, 4.0, 2.0),
                    blockedTowardsKey(start, along, up, c, 24.0, 8.0, 3.0));
    up *= c.y;
    vec3 sky = vec3(blockedAt(start + 2.0 * up, 1.0), blockedAt(start + 4.0 * up, 2.0),
                    blockedAt(start + 8.0 * up, 3.0));
    vec2 blocked = vec2(1.0 - (1.0 - key.x) * (1.0 - key.y) * (1.0 - key.z),
                        blockedByBoth(blockedByBoth(sky.x, sky.y), sky.z));
    return 1.0 - blocked * occlusionStrengths.yx;
}
