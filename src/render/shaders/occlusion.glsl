// How much light reaches a place: ambient occlusion and soft shadows from the occlusion volume (render::OcclusionVolume).
// Lengths are in texel lengths (strictly, edges of a cube as large as a texel of level 0), directions in the world. Nothing
// here is random and no loop depends on what it finds, so neighbouring pixels do the same and shade alike.
// Bindings: uniform block 3, texture 9.

layout(std140, binding = 3) uniform OcclusionBlock {
    vec4 occlusionScale;      // xyz texture coordinate per voxel
    vec4 occlusionOffset;     // xyz texture coordinate of voxel 0
    vec4 occlusionFromWorld[3]; // texture coordinates per texel length along the world's x, y, z
    vec4 occlusionTexel[3];   // xyz edges of a texel in the world
    vec4 occlusionTowardsKey; // xyz world, unit
    vec4 occlusionStrengths;  // x ambient occlusion, y shadow, z 1 if what blocks light is transparent
};

layout(binding = 9) uniform sampler3D occlusionTexture;

// A level's texels are blurred into one another with a standard deviation of about 0.65 of their width. Farther than this
// many widths from a plane next to nothing of it is left.
const float kClear = 1.4;
// What is left nevertheless counts as nothing.
const float kFaint = 0.035;

float blockedAt(vec3 place, float level) {
    return max(textureLod(occlusionTexture, place, level).r - kFaint, 0.0) * (1.0 / (1.0 - kFaint));
}

// Two parts of a cone's width that are blocked one behind the other: by the same thing, mostly, and by others.
float blockedByBoth(float a, float b, float others) {
    float either = a + b - a * b;
    return mix(max(a, b), either, others);
}

vec3 occlusionCoordinate(vec3 voxel) { return voxel * occlusionScale.xyz + occlusionOffset.xyz; }

vec3 occlusionDirection(vec3 world) {
    return occlusionFromWorld[0].xyz * world.x + occlusionFromWorld[1].xyz * world.y + occlusionFromWorld[2].xyz * world.z;
}

// Width of a texel across a surface with this normal.
float occlusionWidth(vec3 normal) {
    return length(vec3(dot(normal, occlusionTexel[0].xyz), dot(normal, occlusionTexel[1].xyz),
                       dot(normal, occlusionTexel[2].xyz)));
}

// A cone whose width doubles with its distance: samples at start + direction * 2^level.
float openCone(vec3 start, vec3 direction) {
    const float reach[5] = float[5](1.0, 0.95, 0.85, 0.7, 0.5); // less, the farther: illustrators light cavities
    float blocked = 0.0;
    for (int level = 0; level < 5; ++level) {
        float there = blockedAt(start + direction * float(1 << level), float(level)) * reach[level];
        blocked = blockedByBoth(blocked, there, 0.2);
    }
    return 1.0 - blocked;
}

// The part of the sky above a surface that is open: 1 open .. 0 closed. `normal` world, unit.
// One wide cone along each of the world's axes on the normal's side, weighted by the squared cosine, as in ambient cubes
// (McTaggart 2004): the weights add up to 1 and go to 0 where an axis changes sides. Cones are bent away from the surface
// until none of them touches a flat one.
float ambientAt(vec3 voxel, vec3 normal) {
    float clear = kClear * occlusionWidth(normal);
    vec3 up = occlusionDirection(normal);
    vec3 start = occlusionCoordinate(voxel) + up * clear * 0.7;
    float open = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
        float cosine = abs(normal[axis]);
        vec3 along = occlusionFromWorld[axis].xyz * (normal[axis] < 0.0 ? -1.0 : 1.0);
        vec3 direction = kClear * along + max(clear - kClear * cosine, 0.0) * up;
        open += cosine * cosine * openCone(start, direction);
    }
    return mix(1.0, open, occlusionStrengths.x);
}

// A sample of the shadow cone `distance` along the light, kept off the surface it starts from.
float blockedTowardsKey(vec3 start, vec3 along, vec3 up, float cosine, float clear, float distance, float level) {
    float height = max(clear * exp2(level) - clear - distance * cosine, 0.0);
    return blockedAt(start + along * distance + up * height, level);
}

// The part of the key light that reaches a surface: 0 shadow .. 1. `normal` world, unit.
float lightReaching(vec3 voxel, vec3 normal) {
    const float others = 0.15;
    float cosine = max(dot(normal, occlusionTowardsKey.xyz), 0.0);
    float clear = kClear * occlusionWidth(normal);
    vec3 up = occlusionDirection(normal);
    vec3 along = occlusionDirection(occlusionTowardsKey.xyz);
    vec3 start = occlusionCoordinate(voxel) + up * clear;
    float blocked = 0.0;
    for (int level = 0; level < 5; ++level) {
        for (int i = 0; i < 3; ++i) {
            float distance = (3.0 + float(i)) * float(1 << level) - 1.5;
            float there = blockedTowardsKey(start, along, up, cosine, clear, distance, float(level));
            blocked = blockedByBoth(blocked, there, others);
        }
    }
    return mix(1.0, 1.0 - blocked, occlusionStrengths.y);
}

// For places in a volume: x the part of the key light, y of the sky's. Six samples.
vec2 cheapLight(vec3 voxel, vec3 normal) {
    vec3 up = occlusionDirection(normal);
    vec3 along = occlusionDirection(occlusionTowardsKey.xyz);
    vec3 start = occlusionCoordinate(voxel) + up;
    float key = 1.0;
    float sky = 0.0;
    for (int level = 1; level < 4; ++level) {
        float width = float(1 << level);
        key *= 1.0 - blockedAt(start + along * (1.5 * width), float(level));
        sky = blockedByBoth(sky, blockedAt(start + up * width, float(level)), 0.2);
    }
    return mix(vec2(1.0), vec2(key, 1.0 - sky), occlusionStrengths.yx);
}
