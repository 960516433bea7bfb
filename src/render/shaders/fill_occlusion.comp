// How much of each texel of the occlusion volume blocks light: the part of it that is visible, or what its
// opacity holds back. CONTENT: 0 data in the displayed range, 1 segmentation, 2 either of the two, 3 opacity
// of the transfer function (TF_KIND). SCULPTED: there is a sculpture. FILLED: and material that was added.
// ON_VOXELS: blockSize is 2 along each axis, so that what is looked up are the voxels. In: the scene
// (field/shaders/scene.glsl), texture 3 macrocell distances. Out: image 0 (r8), texels [texelLo, texelHi).
// variants: CONTENT=0 ON_VOXELS=1;CONTENT=0;CONTENT=1 SCULPTED=1;CONTENT=2;CONTENT=3 TF_KIND=0 SCULPTED=1 ON_VOXELS=1;CONTENT=3 TF_KIND=2;CONTENT=0 FILLED=1 SCULPTED=1;CONTENT=3 TF_KIND=0 FILLED=2;CONTENT=2 FILLED=2
layout(local_size_x = 4, local_size_y = 4, local_size_z = 4) in;

#include "gl/shaders/place.glsl"

#include "field/shaders/bindings.glsl"
#include "render/shaders/bindings.glsl"
#include "field/shaders/scene.glsl"
#if CONTENT == 3
#include "render/shaders/classification.glsl"
#endif

layout(binding = kCellDistancesTexture) uniform usampler3D cellDistances;
layout(r8, binding = kOcclusionImage) uniform writeonly image3D occlusion;

uniform ivec3 texelLo;
uniform ivec3 texelHi;
uniform ivec3 blockSize;  // voxels of a texel
uniform int farEnough;    // a macrocell this far from all visible ones: nothing in the texel is visible
uniform float texelSteps; // length of a texel in steps
uniform int places;       // 8. Loops over a number that the compiler does not know stay loops, which a
                          // software renderer leaves after one turn where nothing is visible

// Eight values in a texel, half its width apart.
vec3 place(vec3 centre, int i) {
    return centre + 0.25 * vec3(blockSize) * (2.0 * vec3(i & 1, (i >> 1) & 1, i >> 2) - 1.0);
}

#ifdef ON_VOXELS
ivec3 voxelAt(vec3 p) { return min(ivec3(p + 0.5), dims.xyz - 1); }
float dataIn(vec3 p) { return scanValue(voxelAt(p)); }
float sculptureIn(vec3 p) { return texelFetch(sculptureTexture, voxelAt(p), 0).r; }
vec2 membershipsIn(vec3 p) { return texelFetch(segmentationTexture, voxelAt(p), 0).rg; }
#else
float dataIn(vec3 p) { return scanAt(p); }
float sculptureIn(vec3 p) { return sculptureAt(p); }
vec2 membershipsIn(vec3 p) { return membershipsAt(p); }
#endif

// The part of a texel in which something is >= 0, as if it changed evenly across the texel. From the mean,
// the smallest and the largest of the eight values.
float coverage(float sum, float lo, float hi) {
    return clamp(0.5 + 0.0625 * sum / max(hi - lo, 1e-20), 0.0, 1.0);
}

vec2 coverage(vec2 sum, vec2 lo, vec2 hi) {
    return vec2(coverage(sum.x, lo.x, hi.x), coverage(sum.y, lo.y, hi.y));
}

float dataCoverage(vec3 centre) {
    float sum = 0.0;
    float lo = 1e38;
    float hi = -1e38;
    for (int i = 0; i < places; ++i) {
        float inside = insideRange(dataIn(place(centre, i)));
        sum += inside;
        lo = min(lo, inside);
        hi = max(hi, inside);
    }
    return coverage(sum, lo, hi);
}

// In opaque segments (x), and clear of translucent ones (y): they block no light, nor does the data in them.
vec2 segmentationCoverage(vec3 centre) {
    vec2 sum = vec2(0.0);
    vec2 lo = vec2(1e38);
    vec2 hi = vec2(-1e38);
    for (int i = 0; i < places; ++i) {
        vec2 memberships = membershipsIn(place(centre, i));
        vec2 inside = vec2(memberships.x - 0.5, clearOfGlass(memberships));
        sum += inside;
        lo = min(lo, inside);
        hi = max(hi, inside);
    }
    return coverage(sum, lo, hi);
}

float sideCoverage(vec3 centre) {
    float sum = 0.0;
    float lo = 1e38;
    float hi = -1e38;
    for (int i = 0; i < places; ++i) {
        float side = visibleSide(sculptureIn(place(centre, i)));
        sum += side;
        lo = min(lo, side);
        hi = max(hi, side);
    }
    return coverage(sum, lo, hi);
}

#if CONTENT == 3
// Light held back along the length of a texel.
float opacityOf(vec3 centre) {
    float steepness = 0.0;
#if TF_KIND != 0
    vec3 difference = vec3(0.0);
    for (int i = 0; i < places; ++i) {
        difference += dataIn(place(centre, i)) * (2.0 * vec3(i & 1, (i >> 1) & 1, i >> 2) - 1.0);
    }
    steepness = length(worldGradient(difference / (2.0 * vec3(blockSize))));
#endif
    float sum = 0.0;
    for (int i = 0; i < places; ++i) {
        float opacity = classify(dataIn(place(centre, i)), steepness).a;
        sum += 1.0 - pow(1.0 - min(opacity, 0.9999), texelSteps);
    }
    return 0.125 * sum;
}
#endif

#ifdef FILLED
// How much of a texel is filled, by anything (x) and by what is seen (y).
vec2 fillCoverage(vec3 centre) {
    vec2 sum = vec2(0.0);
    vec2 lo = vec2(1e38);
    vec2 hi = vec2(-1e38);
    for (int i = 0; i < places; ++i) {
        vec2 inside = filledAt(place(centre, i)) - 0.5;
        sum += inside;
        lo = min(lo, inside);
        hi = max(hi, inside);
    }
    return coverage(sum, lo, hi);
}
#endif

// The part of a texel that lies in the grid, which reaches half a voxel beyond the outermost centres.
float partInGrid(vec3 centre) {
    vec3 inside = clamp((vec3(dims.xyz) - 0.5 - centre) / vec3(blockSize) + 0.5, 0.0, 1.0);
    return inside.x * inside.y * inside.z;
}

float blockedPart(vec3 centre) {
#if CONTENT == 0
    float part = dataCoverage(centre);
#elif CONTENT == 1
    float part = segmentationCoverage(centre).x;
#elif CONTENT == 2
    vec2 segments = segmentationCoverage(centre);
    float part = max(dataCoverage(centre) * segments.y, segments.x);
#else
    float part = opacityOf(centre);
#endif
#ifdef SCULPTED
    part *= sideCoverage(centre);
#endif
#ifdef FILLED
    vec2 filled = fillCoverage(centre);
#if CONTENT == 1
    filled.y = 0.0; // surfaces alone are seen, and of material none
#elif CONTENT == 3
    float material = 1.0 - pow(1.0 - min(classify(dataAt(centre), 0.0).a, 0.9999), texelSteps);
    filled.y *= material;
#endif
    part = part * (1.0 - filled.x) + filled.y;
#endif
    return part * partInGrid(centre);
}

void main() {
    ivec3 texel = texelLo + placeOfInvocation();
    if (any(greaterThanEqual(texel, texelHi))) {
        return;
    }
    vec3 centre = (vec3(texel) + 0.5) * vec3(blockSize) - 0.5;
    ivec3 cell = clamp(ivec3(floor(centre * 0.25)), ivec3(0), textureSize(cellDistances, 0) - 1);
    bool mayBlock =
        all(lessThan(texel * blockSize, dims.xyz)) && int(texelFetch(cellDistances, cell, 0).r) < farEnough;
    float part = 0.0;
    if (mayBlock) {
        part = blockedPart(centre);
    }
    imageStore(occlusion, texel, vec4(part));
}
