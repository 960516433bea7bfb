// Cuts what lies inside (or outside) an outline drawn on the picture, along the rays through it, to a depth
// below the surface seen or through everything. In: texture 0 distances from the outline (pixels, positive
// inside), with a depth texture 1 where along its ray the solid begins and ends under each pixel (mm,
// negative: nowhere), and texture 2 the same of what begins nearest around it. In/out: image 0 sculpture.
// variants: SCULPTURE_BITS=16;SCULPTURE_BITS=16 LIMITED=1
#include "sculpt/shaders/cut_solid.glsl"

#include "sculpt/shaders/bindings.glsl"
layout(binding = kOutlineDistancesTexture) uniform sampler2D outlineDistances;
layout(binding = kOwnDepthsTexture) uniform sampler2D ownDepths;
layout(binding = kFrontDepthsTexture) uniform sampler2D frontDepths;

uniform mat4 pixelFromVoxel;
uniform vec4 outlinePlace; // origin of the raster in pixels, band in pixels, mm of a pixel at w = 1
uniform vec4 eye;          // mm; w 1: orthographic
uniform vec3 forward;
uniform vec3 kind; // x 1: outside; y 1: to a depth; z radius in mm

// Pixels from the outline, positive inside; beyond the band as far as can be.
float outlineAt(vec2 pixel) {
    vec2 texel = pixel - outlinePlace.xy + 0.5;
    vec2 size = vec2(textureSize(outlineDistances, 0));
    bool isInside = all(greaterThan(texel, vec2(0.5))) && all(lessThan(texel, size - 0.5));
    float distance = textureLod(outlineDistances, texel / size, 0.0).r;
    distance = isInside ? distance : -outlinePlace.z;
    return abs(distance) > outlinePlace.z - 0.01 ? sign(distance) * 1e6 : distance;
}

float energyBetween(vec2 depths, float along) {
    float energy = min(energyBehind(depths.y - along), energyBehind(along - depths.x));
    return depths.x >= 0.0 ? energy : 0.0;
}

// Depths under a pixel, bilinear where the surface is one piece.
vec2 ownAt(vec2 pixel) {
    vec2 at = pixel - 0.5;
    ivec2 first = ivec2(floor(at));
    ivec2 last = textureSize(ownDepths, 0) - 1;
    vec2 f = at - vec2(first);
    vec2 a = texelFetch(ownDepths, clamp(first, ivec2(0), last), 0).rg;
    vec2 b = texelFetch(ownDepths, clamp(first + ivec2(1, 0), ivec2(0), last), 0).rg;
    vec2 c = texelFetch(ownDepths, clamp(first + ivec2(0, 1), ivec2(0), last), 0).rg;
    vec2 d = texelFetch(ownDepths, clamp(first + ivec2(1, 1), ivec2(0), last), 0).rg;
    vec2 nearest = f.y < 0.5 ? (f.x < 0.5 ? a : b) : (f.x < 0.5 ? c : d);
    float least = min(min(a.x, b.x), min(c.x, d.x));
    float most = max(max(a.x, b.x), max(c.x, d.x));
    return least >= 0.0 && most - least <= kind.z ? mix(mix(a, b, f.x), mix(c, d, f.x), f.y) : nearest;
}

float energyAt(vec3 voxel) {
    vec4 projected = pixelFromVoxel * vec4(voxel, 1.0);
    bool isBehind = projected.w <= 1e-3;
    vec2 pixel = projected.xy / (isBehind ? 1.0 : projected.w);
    float inside = isBehind ? -1e6 : outlineAt(pixel) * outlinePlace.w * projected.w;
    float energy = energyBehind(kind.x > 0.5 ? -inside : inside);
    if (kind.y > 0.5 && energy > negligible) {
        vec3 fromEye = (worldFromVoxel * vec4(voxel, 1.0)).xyz - eye.xyz;
        float along = eye.w > 0.5 ? dot(fromEye, forward) : length(fromEye);
        ivec2 at = ivec2(floor(pixel));
        ivec2 last = textureSize(ownDepths, 0) - 1;
        bool isSeen = !isBehind && all(greaterThanEqual(at, ivec2(0))) && all(lessThanEqual(at, last));
        vec2 front = texelFetch(frontDepths, clamp(at, ivec2(0), last), 0).rg;
        float between = max(energyBetween(ownAt(pixel), along), energyBetween(front, along));
        energy = min(energy, isSeen ? between : 0.0);
    }
    return energy;
}

void main() {
    ivec3 voxel;
    if (!lineStart(voxel)) {
        return;
    }
    for (int n = 0; n < 8 && voxel.x < dims.x; ++n) {
        combineVoxel(voxel, energyAt(vec3(voxel)));
        ++voxel.x;
    }
}
