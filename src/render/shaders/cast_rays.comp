// One sample per pixel of the picture: cast a ray, find what the mode asks for, colour it, add it to the accumulation.
// MODE: 0 surface, 1 MIP, 2 X-ray, 3 overlay (segmentation as surface, the rest as X-ray), 4 segment (both as surface),
// 5 volume (compositing). CONTENT and SCULPTED: see surface.glsl. TF_KIND: what the transfer function goes by that colours
// all modes (classification.glsl); not defined: none does.
// In: the scene (field/shaders/scene.glsl), the view (rays.glsl). Out: image 0 (rgba32f) sum of display colours, and of
// coverage: how much of the background they hide.
// variants: MODE=0 CONTENT=0;MODE=0 CONTENT=0 SCULPTED=1;MODE=1 CONTENT=0;MODE=2 CONTENT=0 SCULPTED=1;MODE=3 CONTENT=1 SCULPTED=1;MODE=4 CONTENT=2;MODE=5 CONTENT=0 TF_KIND=0;MODE=5 CONTENT=0 SCULPTED=1 TF_KIND=2;MODE=0 CONTENT=0 TF_KIND=1;MODE=1 CONTENT=0 TF_KIND=0;MODE=2 CONTENT=0 TF_KIND=2;MODE=0 CONTENT=0 TRICUBIC=1
layout(local_size_x = 64) in;

#include "field/shaders/scene.glsl"
#include "render/shaders/rays.glsl"
#include "render/shaders/squares.glsl"
#include "render/shaders/surface.glsl"
#if MODE == 1
#define SLABS
#include "render/shaders/slabs.glsl"
#endif
#include "render/shaders/maximum.glsl"
#include "render/shaders/shading.glsl"
#ifdef TF_KIND
#include "render/shaders/classification.glsl"
#endif
#if MODE == 5
#include "render/shaders/composite.glsl"
#endif

layout(binding = 8) uniform sampler2D beams; // where along its rays each square of pixels may show something

layout(location = 3) uniform vec2 exposure;     // x: X-ray gain per diagonal; y: volume's diagonal in steps
layout(location = 4) uniform vec3 segmentColour; // linear
layout(location = 5) uniform float sampleStep;   // steps between samples in MIP and X-ray
layout(location = 6) uniform int beamShift;      // side of a beam's square: 1 << this; division is slow
layout(location = 7) uniform vec4 backgroundTop; // display colour; w 1: there is none, and it is black
layout(location = 8) uniform vec4 backgroundBottom;

const vec3 kSurfaceColour = vec3(0.72, 0.57, 0.45); // linear: the ivory of anatomical plates

// Where a value lies in the displayed range, 0 to 1; a range of one value counts in full.
float partOfRange(float value) { return range.y > range.x ? (value - range.x) / (range.y - range.x) : 1.0; }

// Different for each pixel and sample, the same each time (interleaved gradient noise, Jimenez 2014).
float startJitter(ivec2 pixel) {
    return fract(52.9829189 * fract(dot(vec2(pixel) + 64.0 * pixelOffset, vec2(0.06711056, 0.00583715))));
}

#ifdef TF_KIND
// The transfer function's colour of a value at p, linear.
vec3 functionColour(float value, vec3 p) {
#if TF_KIND == 0
    return classify(value, 0.0).rgb;
#else
    return classify(value, length(dataGradient(p))).rgb;
#endif
}
#endif

// The colour of the data's own surface. It shows one value, the displayed range's end, so a transfer function is asked for
// what lies a step behind it.
vec3 surfaceColour(Hit hit, Ray ray) {
#ifdef TF_KIND
    vec3 behind = hit.voxel + ray.direction;
    return functionColour(dataAt(behind), behind);
#else
    return kSurfaceColour;
#endif
}

float greyOf(float value) { return clamp((value - range.z) / max(range.w - range.z, 1e-20), 0.0, 1.0); }

vec3 shadeHit(Hit hit, Ray ray) {
    vec3 right = viewRight.xyz;
    vec3 up = viewUp.xyz;
    vec3 albedo = hit.isSegment ? segmentColour : surfaceColour(hit, ray);
    if (!hit.isCut) {
        return displayFromLinear(lit(albedo, hit.normal, -ray.world, right, up, -viewForward.xyz, 0.12));
    }
    // A section shows the data's own values: grey, shaded just enough to tell its shape.
#ifdef TF_KIND
    vec3 section = functionColour(dataAt(hit.voxel), hit.voxel);
#else
    vec3 section = linearFromDisplay(vec3(0.15 + 0.85 * greyOf(dataAt(hit.voxel))) * vec3(1.0, 0.985, 0.96));
#endif
    section = hit.isSegment ? mix(section, segmentColour, 0.55) : section;
    vec3 key = normalize(-0.45 * right + 0.65 * up - 0.75 * viewForward.xyz);
    return displayFromLinear(section * (0.55 + 0.45 * max(dot(hit.normal, key), 0.0)));
}

#if MODE == 2 || MODE == 3
// Integral of (value - lo) / (hi - lo) over the visible part of the ray up to tEnd, in steps: a. The transfer function's
// colours, each weighted by that: rgb.
vec4 integralAlong(Ray ray, float tEnd) {
    const int batch = 8; // samples a turn: see surface.glsl
    vec3 inverseDirection = safeInverse(ray.direction);
    vec4 sum = vec4(0.0);
    float t = nextSample(ray.tBegin, sampleStep, 0.5);
    do {
        // Whole steps only, so that the samples stay evenly spaced across a skip.
        float skip;
        do {
            skip = emptyUntil(ray, t, inverseDirection);
            t = skip > 0.0 ? nextSample(t + skip, sampleStep, 0.5) : t;
        } while (skip > 0.0 && t < tEnd);
        for (int i = 0; i < batch; ++i) {
            float here = t + float(i) * sampleStep;
            vec3 p = at(ray, here);
            float value = dataAt(p);
            bool counts = here < tEnd && insideRange(value) >= 0.0 && sideAt(p) >= 0.0;
            float part = counts ? partOfRange(value) : 0.0;
            sum.a += part;
#ifdef TF_KIND
            sum.rgb += part * functionColour(value, p);
#endif
        }
        t += float(batch) * sampleStep;
    } while (t < tEnd);
    return sum * sampleStep;
}
#endif

#if MODE == 2 || MODE == 3
// The display colour of an integral: white, or what the transfer function says.
vec3 integralColour(vec4 integral) {
#ifdef TF_KIND
    return displayFromLinear(integral.rgb / max(integral.a, 1e-6));
#else
    return vec3(1.0);
#endif
}
#endif

// Display colour over what is behind, and coverage: that colour is linear in `behind`, and 1 - coverage its slope.
vec4 colourOf(Ray ray, vec3 behind, float jitter) {
#if MODE == 0 || MODE == 4
    Hit hit = findSurface(ray, jitter);
    return hit.found ? vec4(shadeHit(hit, ray), 1.0) : vec4(behind, 0.0);
#elif MODE == 1
    Greatest greatest = findGreatestInSlabs(ray, sampleStep);
    float brightness = clamp(partOfRange(greatest.value), 0.0, 1.0);
#ifdef TF_KIND
    vec4 shown = vec4(displayFromLinear(functionColour(greatest.value, at(ray, greatest.t))), 1.0);
#else
    vec4 shown = vec4(mix(behind * 0.3, vec3(1.0), brightness), 1.0 - 0.3 * (1.0 - brightness));
#endif
    return greatest.value > -1e29 ? shown : vec4(behind, 0.0);
#elif MODE == 2
    vec4 integral = integralAlong(ray, ray.tEnd);
    float brightness = clamp(integral.a / exposure.y * exposure.x, 0.0, 1.0);
    return vec4(mix(behind, integralColour(integral), brightness), brightness);
#elif MODE == 3
    Hit hit = findSurface(ray, jitter);
    vec4 integral = integralAlong(ray, hit.found ? hit.t : ray.tEnd);
    float brightness = clamp(integral.a / exposure.y * exposure.x, 0.0, 1.0);
    vec3 base = hit.found ? shadeHit(hit, ray) : behind;
    float veil = brightness * (hit.found ? 0.45 : 0.9);
    return vec4(mix(base, vec3(0.86, 0.91, 1.0) * integralColour(integral), veil), hit.found ? 1.0 : veil);
#else
    vec4 seen = compositeAlong(ray, sampleStep, jitter);
    if (backgroundTop.w > 0.5) { // light is mixed here, not display colours: what programs that do so make of it
        return vec4(displayFromLinear(seen.rgb / max(seen.a, 1e-6)) * seen.a, seen.a);
    }
    return vec4(displayFromLinear(seen.rgb + (1.0 - seen.a) * linearFromDisplay(behind)), seen.a);
#endif
}

void main() {
    ivec2 pixel = pixelOfInvocation();
    if (any(greaterThanEqual(pixel, ivec2(viewport.xy)))) {
        return;
    }
    vec2 position = vec2(pixel) + pixelOffset;
    Ray ray = rayThrough(position);
    ray.beam = pixel >> beamShift;
    ray.beamEnds = texelFetch(beams, ray.beam, 0).rg;
    ray.tBegin = max(ray.tBegin, ray.beamEnds.x);
    ray.tEnd = min(ray.tEnd, ray.beamEnds.y);
    vec3 behind = background(position, viewport.xy, backgroundTop.xyz, backgroundBottom.xyz);
#if MODE == 1 || MODE == 2 || MODE == 3
    behind = ray.tNear < ray.tFar ? min(behind, kFilm) : behind;
#endif
    addToPicture(pixel, colourOf(ray, behind, startJitter(pixel)));
}
